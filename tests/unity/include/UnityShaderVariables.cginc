// A stand-in for Unity's include of this name, written for these tests.
#if defined(DIRECTIONAL) || defined(DIRECTIONAL_COOKIE) || defined(POINT) || defined(POINT_COOKIE) || defined(SPOT)
#define USING_LIGHT_MULTI_COMPILE
#endif
#ifdef STAND_IN_INSTANCES  // the runtime's object is an array of them
#define unity_ObjectToWorld objectToWorld[0]
#define unity_WorldToObject worldToObject[0]
#else
#define unity_ObjectToWorld objectToWorld
#define unity_WorldToObject worldToObject
#endif
#define UNITY_MATRIX_VP worldToClip
#define UNITY_MATRIX_V worldToView
#define _WorldSpaceCameraPos cameraPositionWS
#define _Time float4(time / 20, time, time * 2, time * 3)
#define _ScreenParams float4(screenSize, 1 + 1 / screenSize)
#define _ProjectionParams float4(1, clipPlanes.x, clipPlanes.y, 1 / clipPlanes.y)
#define unity_OrthoParams float4(0, 0, 0, viewIsOrthographic)
#define unity_WorldTransformParams float4(0, 0, 0, determinant((float3x3)unity_ObjectToWorld) < 0 ? -1 : 1)

#define _WorldSpaceLightPos0 float4(lightPosition[0].w < 0.5 ? normalize(lightPosition[0].xyz) : lightPosition[0].xyz, \
                                    lightPosition[0].w < 0.5 ? 0 : 1)
#ifndef STAND_IN_FOG
#define fogColor float4(0, 0, 0, 0)
#define fogSettings float4(0, 0, 0, 0)
#endif
#define unity_FogColor float4(handedOver(fogColor.rgb), 1)

static const float4 unity_4LightPosX0 = 0, unity_4LightPosY0 = 0, unity_4LightPosZ0 = 0, unity_4LightAtten0 = 0;
static const float4 unity_LightColor[8] = {float4(0, 0, 0, 0), float4(0, 0, 0, 0), float4(0, 0, 0, 0),
                                           float4(0, 0, 0, 0), float4(0, 0, 0, 0), float4(0, 0, 0, 0),
                                           float4(0, 0, 0, 0), float4(0, 0, 0, 0)};
static const float4 unity_LightmapST = float4(1, 1, 0, 0), unity_DynamicLightmapST = float4(1, 1, 0, 0);
static const float4 unity_SpecCube0_HDR = 1, unity_SpecCube1_HDR = 1;
static const float4 unity_SpecCube0_BoxMin = 0, unity_SpecCube0_BoxMax = 0, unity_SpecCube0_ProbePosition = 0;
static const float4 unity_SpecCube1_BoxMin = 0, unity_SpecCube1_BoxMax = 0, unity_SpecCube1_ProbePosition = 0;
