// flags: -T ps_5_0
// expect: include_itself.ps.hlsl:3:1: error: '#include': includes are nested more than 64 deep: does a file include itself?
#include "include_itself.ps.hlsl"
