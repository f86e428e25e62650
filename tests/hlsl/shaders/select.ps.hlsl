// HLSL 2021's select, and, or on two pictures.
#include "shaders/quad_io.hlsli"

Texture2D<float4> left : register(t0);
Texture2D<float4> right : register(t1);

float Next(inout float count)
{
    return count += 1.0;
}

float4 main(QuadVertex i) : SV_Target0
{
    float4 a = left.Load(int3(i.position.xy, 0));
    float4 b = right.Load(int3(i.position.xy, 0));
#if FORM == 0  // vectors
    return select(a > b, a, b);
#elif FORM == 1  // one condition for all
    return select(a.x > b.x, a, b);
#elif FORM == 2  // scalars for vectors, of two types: the common type is float
    return select(a > b, 1, 0.5);
#elif FORM == 3  // int and uint: uint, so that -3 is large
    return float4(select(a.xyz > b.xyz, int3(-3, -2, -1), 2u) >> 16, 0.0);
#elif FORM == 4
    return float4(select(and(a > 0.5, b > 0.5), float4(1, 1, 1, 1), 0.0));
#elif FORM == 5
    return float4(select(or(a > 0.5, b.x > 0.5), 1.0, float4(0, 0, 0, 0)));
#elif FORM == 6  // both values are evaluated
    float count = 0.0;
    float chosen = select(a.x > b.x, Next(count), 10.0 * Next(count));
    return float4(chosen, count, 0.0, 0.0);
#elif FORM == 7  // a matrix
    float2x3 m = select(a.x > b.x, float2x3(a.xyz, b.xyz), float2x3(b.xyz, a.xyz));
    return float4(m[0], m[1].z);
#elif FORM == 8  // an int is a condition
    return select((int4)(a * 4.0) - 2, a, b);
#endif
}
