// A stand-in for Unity's include of this name, written for these tests.
// What each instance has is in the runtime's own block; the first is drawn.
#ifdef STAND_IN_REGISTERS
#define UNITY_INSTANCING_BUFFER_START(buf)
#define UNITY_DEFINE_INSTANCED_PROP(type, var)
#define UNITY_INSTANCING_BUFFER_END(arr)
#define UNITY_ACCESS_INSTANCED_PROP(arr, var) var[0]
#else
#define UNITY_INSTANCING_BUFFER_START(buf) cbuffer UnityInstancing_##buf { struct {
#define UNITY_DEFINE_INSTANCED_PROP(type, var) type var;
#define UNITY_INSTANCING_BUFFER_END(arr) } arr##Array[2]; };
#define UNITY_ACCESS_INSTANCED_PROP(arr, var) arr##Array[0].var
#endif
#ifdef INSTANCING_ON
#define UNITY_VERTEX_INPUT_INSTANCE_ID uint instanceID : SV_InstanceID;
#define UNITY_INSTANCING_ENABLED
static uint unity_InstanceID;
#define UNITY_SETUP_INSTANCE_ID(input) unity_InstanceID = input.instanceID
#define UNITY_TRANSFER_INSTANCE_ID(input, output) output.instanceID = input.instanceID
#else
#define UNITY_VERTEX_INPUT_INSTANCE_ID
#define UNITY_SETUP_INSTANCE_ID(input)
#define UNITY_TRANSFER_INSTANCE_ID(input, output)
#endif
#define UNITY_VERTEX_OUTPUT_STEREO
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output)
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input)

#define UNITY_PI 3.14159265359f
#define UNITY_TWO_PI 6.28318530718f
#define UNITY_FOUR_PI 12.56637061436f
#define UNITY_INV_PI 0.31830988618f
#define UNITY_INV_TWO_PI 0.15915494309f
#define UNITY_INV_FOUR_PI 0.07957747155f

struct appdata_full
{
    float4 vertex : POSITION;
    float4 tangent : TANGENT;
    float3 normal : NORMAL;
    float4 texcoord : TEXCOORD0;
    float4 texcoord1 : TEXCOORD1;
    float4 texcoord2 : TEXCOORD2;
    float4 texcoord3 : TEXCOORD3;
    fixed4 color : COLOR;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

float4 UnityObjectToClipPos(float3 position)
{
    return mul(worldToClip, mul(unity_ObjectToWorld, float4(position, 1)));
}
float3 UnityObjectToWorldNormal(float3 normal)
{
    return normalize(mul(normal, (float3x3)unity_WorldToObject));
}
float3 UnityObjectToWorldDir(float3 direction)
{
    return normalize(mul((float3x3)unity_ObjectToWorld, direction));
}
float3 UnityWorldSpaceViewDir(float3 position)
{
    return cameraPositionWS - position;
}
float3 UnityWorldSpaceLightDir(float3 position)
{
    return _WorldSpaceLightPos0.xyz - position * _WorldSpaceLightPos0.w;
}
float4 ComputeScreenPos(float4 position)
{
    return float4(0.5 * position.xy + 0.5 * position.w, position.zw);
}
float LinearEyeDepth(float depth)
{
    return clipPlanes.x * clipPlanes.y / lerp(clipPlanes.y, clipPlanes.x, depth);
}
half3 UnpackNormal(half4 packednormal)
{
    return packednormal.xyz * 2 - 1;
}
// Names that a shader must not declare again.
float2 ParallaxOffset(half h, half height, half3 viewDir) { return 0; }
half Luminance(half3 rgb) { return 0; }
half3 DecodeHDR(half4 data, half4 decodeInstructions) { return 0; }
half3 DecodeLightmap(fixed4 color) { return 0; }
float4 EncodeFloatRGBA(float v) { return 0; }
float DecodeFloatRGBA(float4 enc) { return 0; }
float2 EncodeFloatRG(float v) { return 0; }
float DecodeFloatRG(float2 enc) { return 0; }
float Linear01Depth(float z) { return 0; }
half3 ShadeSH9(half4 normal) { return 0; }
float3 WorldSpaceViewDir(float4 localPos) { return 0; }
float3 ObjSpaceViewDir(float4 v) { return 0; }
float3 Shade4PointLights(float4 x, float4 y, float4 z, float3 c0, float3 c1, float3 c2, float3 c3, float4 falloff,
                         float3 position, float3 normal)
{
    return 0;
}

// What is far fades into fog; distances count along the camera's axis.
float stand_in_fog(float distance)
{
    float linear_factor = saturate((fogSettings.w - distance) / (fogSettings.w - fogSettings.z));
    float power = fogSettings.y * distance;
    float factor = fogSettings.x < 1.5 ? linear_factor : fogSettings.x < 2.5 ? exp(-power) : exp(-power * power);
    return fogSettings.x < 0.5 ? 1 : factor;
}
#if defined(FOG_LINEAR) || defined(FOG_EXP) || defined(FOG_EXP2)
#define UNITY_FOG_COORDS(idx) float1 fogCoord : TEXCOORD##idx;
#define UNITY_TRANSFER_FOG(o, outpos) o.fogCoord = (outpos).w
#define UNITY_APPLY_FOG_COLOR(coord, col, fogCol)          \
    float unityFogFactor = stand_in_fog((coord).x); \
    col.rgb = lerp((fogCol).rgb, (col).rgb, unityFogFactor)
#else
#define UNITY_FOG_COORDS(idx)
#define UNITY_TRANSFER_FOG(o, outpos)
#define UNITY_APPLY_FOG_COLOR(coord, col, fogCol)
#endif

#ifdef SHADOWS_CUBE
#define V2F_SHADOW_CASTER float3 vec : TEXCOORD0; float4 pos : SV_POSITION
#define TRANSFER_SHADOW_CASTER_NORMALOFFSET(o)                                     \
    o.vec = mul(unity_ObjectToWorld, v.vertex).xyz - lightPosition[0].xyz; \
    o.pos = UnityObjectToClipPos(v.vertex.xyz);
#define SHADOW_CASTER_FRAGMENT(i) return length(i.vec) / lightColor[0].w;
#else
#define V2F_SHADOW_CASTER float4 pos : SV_POSITION
#define TRANSFER_SHADOW_CASTER_NORMALOFFSET(o) \
    o.pos = UnityObjectToClipPos(v.vertex.xyz - 0.001 * v.normal);
#define SHADOW_CASTER_FRAGMENT(i) return 0;
#endif
