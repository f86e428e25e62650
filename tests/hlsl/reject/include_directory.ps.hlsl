// flags: -T ps_5_0
// expect: include_directory.ps.hlsl:3:1: error: '#include': cannot read 'include': it is a directory
#include "include"
