// equirectangular.hlsli: light from all around as one picture.
#ifndef BOXCAR_EQUIRECTANGULAR_HLSLI
#define BOXCAR_EQUIRECTANGULAR_HLSLI

// EquirectangularUv: u = 0.5 + atan2(x, -z) / (2 pi), v = acos(y) / pi.
//
//   dir  length 1
float2 EquirectangularUv(float3 dir)
{
    float longitude = abs(dir.x) + abs(dir.z) > 0.0 ? atan2(dir.x, -dir.z) : 0.0;
    return float2(0.5 + longitude / 6.28318531, acos(clamp(dir.y, -1.0, 1.0)) / 3.14159265);
}

// EquirectangularSample: bilinear, round the seam, and not over the poles.
float3 EquirectangularSample(Texture2D<float4> environment, SamplerState linearRepeat, float3 dir)
{
    float2 extent;
    environment.GetDimensions(extent.x, extent.y);
    float2 uv = EquirectangularUv(dir);
    uv.y = clamp(uv.y, 0.5 / extent.y, 1.0 - 0.5 / extent.y);
    return environment.SampleLevel(linearRepeat, uv, 0.0).rgb;
}

#endif
