// flags: -T ps_5_0
// expect: include_directory.ps.hlsl:3:1: error: '#include': 'include': a folder; a file is expected
#include "include"
