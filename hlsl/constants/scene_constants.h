// Constants of the shaders that draw scenes: one text for HLSL and C++. Order the members so that none crosses a 16-byte
// line; EffectConstants.OffsetsInCppEqualThoseInTheShaders compares them with the compiled shaders.
#ifndef BOXCAR_SCENE_CONSTANTS_H
#define BOXCAR_SCENE_CONSTANTS_H

#ifdef __cplusplus
#include "hlsl/constants/hlsl_types.h"
namespace boxcar {
#endif

// scene.vs and the pixel shaders after it: one object. Blocks that begin with it have 16 bytes for the pixel shader.
struct SceneConstants
{
    float4x4 clipFromWorld;
    float3 offsetWorld;  // of the mesh's origin
    float scale;         // world units in one of the mesh's
    float3 albedo;
    float turnCosine;    // of its turn about +y
    float3 eyeWorld;
    float turnSine;
};

// scene.ps, planar_reflected.ps, shadow_surface.ps: a matt object.
struct MattConstants
{
    SceneConstants scene;
    float checkWorld;  // side of its checks; 0 for none
};

// environment.ps: the light behind a scene.
struct BackdropConstants
{
    float3 rightWorld;  // from the middle of the picture to its right rim, one unit of depth away
    float unused0;
    float3 upWorld;  // to its upper rim
    float unused1;
    float3 forwardWorld;  // length 1
    float unused2;
};

#ifdef __cplusplus
}
#endif

#endif
