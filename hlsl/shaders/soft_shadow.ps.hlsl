// soft_shadow.ps: surfaces in the light of a lamp of some size, whose shadows blur away from what casts them.
//
//   HARD=0  the mean depth of what is in the way, from a box as wide as any penumbra can be, and from narrower ones;
//           then the share of the lamp, from a box as wide as this penumbra is
//   HARD=1  one texel of the map
//
// Green 2003 (blur by the distance from the occluder); beyond the papers: variance shadow maps on tables
#include "boxcar/compat.hlsli"
#include "boxcar/footprint.hlsli"
#include "boxcar/sat_moments.hlsli"
#include "constants/effect_constants.h"
#include "shaders/quad_io.hlsli"
#include "shaders/scene.hlsli"

BOXCAR_CONSTANTS(Constants) { SoftShadowConstants g; };
Texture2D<float4> position : register(t0);
Texture2D<float4> normal : register(t1);
Texture2D<float4> albedo : register(t2);
Texture2D<float4> depth : register(t3);
#if HARD == 0
Texture2D<uint4> table : register(t4);
Texture2D<uint4> tableHigh : register(t5);
#endif

static const float kCodes = 65535.0;
static const float kBiasWorld = 0.006;    // a surface does not shade itself
static const float kSpreadWorld = 0.004;  // the least standard deviation of depth that counts
static const float kOffsetTexels = 1.5;   // of the map: how far along its normal a surface is looked up
static const float3 kLampLight = float3(0.95, 0.86, 0.72);

#if HARD == 0
// The moments of the map's codes over a square.
SATMoments MomentsRound(float2 edgeTexels, int2 extentTexels, float widthTexels)
{
    SATFrame frame = SATFrameAtCorner(extentTexels, SAT_EDGE_CLIP);
    SATBox box = SATClipBox(frame, SATBoxAt(edgeTexels, float2(widthTexels, widthTexels)));
    SATMoments m = SATMomentsOf(SATTable64(table, tableHigh, false), frame, box);
    float leastCodes = kSpreadWorld * kCodes / g.reachWorld;
    m.variance = max(m.variance, leastCodes * leastCodes);
    return m;
}
#endif

// The share of the lamp that a surface sees; 1 outside the map.
float LampShare(float3 positionWorld, float3 normalWorld)
{
    int2 extentTexels;
    depth.GetDimensions(extentTexels.x, extentTexels.y);
    float texelWorld = length(positionWorld - g.lampWorld) / g.texelsAtOne;
    float3 fromWorld = positionWorld + kOffsetTexels * texelWorld * normalWorld;
    float distanceWorld = length(fromWorld - g.lampWorld);
    float4 clip = mul(g.clipFromWorld, float4(fromWorld, 1.0));
    float2 uv = float2(0.5, -0.5) * clip.xy / max(clip.w, 1e-6) + 0.5;
    bool isInMap = clip.w > 0.0 && uv.x >= 0.0 && uv.x < 1.0 && uv.y >= 0.0 && uv.y < 1.0
                && distanceWorld < g.nearWorld + g.reachWorld;
    if (!isInMap)
        return 1.0;

    float2 edgeTexels = TexelUvToEdge(uv, extentTexels);
    float receiver = distanceWorld - kBiasWorld - g.nearWorld;  // from where the map's depth is 0
#if HARD == 0
    float codesAtOne = kCodes / g.reachWorld;
    float lampTexels = g.lampSizeWorld * g.texelsAtOne;
    // Over a box of the map, a flat surface has a variance of its own, and a mean that is beyond its middle. Both per
    // square of the box's width.
    float3 ray = (fromWorld - g.lampWorld) / distanceWorld;
    float cosine = max(-dot(ray, normalWorld), 0.1);
    float receiverCodes = receiver * codesAtOne;
    float slopeCodes = texelWorld * codesAtOne * sqrt(1.0 - cosine * cosine) / cosine;
    float flatVariance = slopeCodes * slopeCodes / 12.0;
    float flatOffset = texelWorld * codesAtOne / (12.0 * g.texelsAtOne * cosine * cosine);

    // Were there two depths only, the receiver's and the nearer one of what is in the way, the latter would be
    // mean - variance / (receiver - mean). First over all that may be in the way, then over what the answer leaves of
    // it: else what is far off would blur the shadow of what is near.
    float widthTexels = FootprintPenumbra(distanceWorld, g.nearWorld, lampTexels);
    for (int narrowed = 0; narrowed < 3; narrowed++)
    {
        float square = widthTexels * widthTexels;
        SATMoments around = MomentsRound(edgeTexels, extentTexels, widthTexels);
        float below = receiverCodes + flatOffset * square - around.mean;
        float blocker = around.mean - max(around.variance - flatVariance * square, 0.0) / max(below, 1.0);
        float blockerWorld = g.nearWorld + max(blocker, 0.0) / codesAtOne;
        float narrowTexels = FootprintPenumbra(distanceWorld, blockerWorld, lampTexels);
        widthTexels = below > 0.0 ? min(widthTexels, narrowTexels) : max(0.5 * widthTexels, 1.0);
    }
    float beyondCodes = receiverCodes + flatOffset * widthTexels * widthTexels;
    float share = SATUpperShare(MomentsRound(edgeTexels, extentTexels, widthTexels), beyondCodes);
    return saturate((share - g.bleedCut) / (1.0 - g.bleedCut));
#else
    return depth.Load(int3(TexelFromEdge(edgeTexels), 0)).r * g.reachWorld < receiver ? 0.0 : 1.0;
#endif
}

// Alpha: the share of the lamp.
float4 main(QuadVertex i) : SV_Target0
{
    int3 texel = int3(TexelFromEdge(i.position.xy), 0);
    float4 at = position.Load(texel);
    float3 facing = normal.Load(texel).xyz;
    if (at.w == 0.0)
        return float4(g.skyLight, 1.0);
    float share = LampShare(at.xyz, facing);
    float3 lamp = share * saturate(dot(facing, normalize(g.lampWorld - at.xyz))) * kLampLight;
    return float4(albedo.Load(texel).rgb * (SceneLight(facing, 0.0) + lamp), share);
}
