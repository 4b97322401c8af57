// Members of the lighting surface: "ink" may be another lighting model's, "roughnes" is nobody's. A part that no pass
// goes without has to be there.
[slot] [part("direct", "surface.difuseColor")]
float3 byDiffuse(LightingSurface surface, [perLight] Light light);
[slot] [part("direct", "surface.thicknessOfTheRind")]
float3 byRind(LightingSurface surface, [perLight] Light light);
[slot] [part("direct", "surface.warmthOfTheCore")]
float3 byCore(LightingSurface surface, [perLight] Light light);
[static("slot", "byCore")] bool hasCore;

[pass("surface-members")] [vertex]
float4 membersVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("surface-members")] [fragment] [lights("none")] [holds("f0", "roughnes", "thicknessOfTheRind", "packSurface")]
float4 membersFragment() {
    return float4(lightingSurface().diffuseColor, 1);
}
