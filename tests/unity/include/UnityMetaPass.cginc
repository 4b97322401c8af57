// A stand-in for Unity's include of this name, written for these tests. It draws the mesh over its texture coordinates.
struct UnityMetaInput
{
    half3 Albedo;
    half3 Emission;
    half3 SpecularColor;
};
float4 UnityMetaVertexPosition(float4 vertex, float2 uv1, float2 uv2, float4 lightmapST, float4 dynlightmapST)
{
    return float4(uv1 * lightmapST.xy + lightmapST.zw, 0.5, 1) * float4(2, 2, 1, 1) - float4(1, 1, 0, 0);
}
half4 UnityMetaFragment(UnityMetaInput IN)
{
#ifdef STAND_IN_EMISSION
    return half4(IN.Emission, 1);
#else
    return half4(IN.Albedo, 1);
#endif
}
