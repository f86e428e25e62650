// table_io.hlsli: the exact table that a pass reads. WORDS is set on the compiler's command line: 1 or 2.
#ifndef BOXCAR_TABLE_IO_HLSLI
#define BOXCAR_TABLE_IO_HLSLI

#include "boxcar/sat_exact.hlsli"

Texture2D<uint4> table : register(t0);
#if WORDS == 2
Texture2D<uint4> tableHigh : register(t1);
#endif

// isSigned: codes may be negative; two words only.
SATExactTable TableRead(bool isSigned)
{
#if WORDS == 2
    return SATTable64(table, tableHigh, isSigned);
#else
    return SATTable32(table);
#endif
}

#endif
