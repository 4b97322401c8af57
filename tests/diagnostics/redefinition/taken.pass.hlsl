[extern] float shadow(int index, float3 position) {
    return 0.5;
}
Light lightAt(int index, float3 position) {
    Light light;
    return light;
}
const int MAX_LIGHTS = 4;
[extern("Lights")] int PI;
enum HighlightNormalization { Nothing };
float3 direct(LightingSurface surface, Light light) {
    return float3(0);
}
[slot] [part("final", "sum.direct")]
float3 reflected(LightingSurface surface, LightSum sum);
[switch] bool shadows;
[static("slot", "indirect")] bool lightingSurface;
// What the library's pass files declare may be declared again, and so may a recipe.
const int MAX_VERTEX_LIGHTS = 2;
float3 shLinear(float3 n) {
    return n;
}
[static("surface", "cutout", "clipped")] bool alphaClip;
[semantic("pixel")] float3 viewDirWS() {
    return float3(0, 1, 0);
}

[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mineFragment(float3 position = positionWS) {
    return float4(litByAll(lightingSurface(), position), 1);
}
