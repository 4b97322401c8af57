// Light from all around: the engine seam. An engine may replace the [extern] functions; their bodies are what the runtime
// and the CPU reference use.
// Units: radiance; the ambient irradiance is E/pi, what a white Lambert surface sends out.

[extern("Ambient")] float4 ambientSH[9];  // radiance coefficients, order l(l+1)+m, z up as in Ramamoorthi & Hanrahan 2001

const float ENVIRONMENT_STEPS = 5;  // level of the map that is blurred for a roughness of 1

[extern] TextureCube environmentMap;  // radiance; each level is blurred as a rougher surface mirrors it
// x: square root of n.v, y: perceptual roughness, from 0 to 1 at the centres of the outer of 64 x 64 texels; red: scale of
// f0, green: offset
[extern] Texture2D splitSumTable;

/// Light that arrives at a surface from all around, divided by pi: a colour times it is radiance.
///
/// source: Ramamoorthi & Hanrahan, "An Efficient Representation for Irradiance Environment Maps", SIGGRAPH 2001
[node("Lighting/Ambient/Ambient Irradiance")] [extern]
float3 AmbientIrradiance(
    float3 normal = normalWS  ///< unit normal in world space
) {
    return EvaluateSH9(normal, ambientSH[0].rgb, ambientSH[1].rgb, ambientSH[2].rgb, ambientSH[3].rgb,
                       ambientSH[4].rgb, ambientSH[5].rgb, ambientSH[6].rgb, ambientSH[7].rgb, ambientSH[8].rgb);
}

/// Radiance that arrives from a direction, as a surface of that roughness reflects it: the surroundings, blurred by the
/// surface's GGX lobe.
///
/// source: Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013; levels as in Unity's reflection probes
[node("Lighting/Ambient/Environment Radiance")] [extern]
float3 EnvironmentRadiance(
    float3 direction = normalWS,        ///< unit direction in world space
    [range(0, 1)] float roughness = 0.5  ///< perceptual roughness
) {
    return environmentMap.SampleLevel(direction, MipFromRoughness(saturate(roughness), ENVIRONMENT_STEPS)).rgb;
}

// Scale and offset at a place of the table. The root gives grazing views, where both change fastest, most of it.
float2 splitSumShare(float roughness, float ndotv) {
    return splitSumTable.SampleLevel(float2(sqrt(ndotv), roughness) * (63.0 / 64) + 0.5 / 64, 0).xy;
}

/// The table of the split sum: how strongly a rough surface mirrors light that comes from everywhere alike.
///
/// The reflectance is f0 scale + f90 offset, for GGX with Smith's exact joint visibility. scale + offset is the share of
/// light that one reflection of a perfect mirror's facets sends back: what is missing has bounced between them.
///
/// formula: scale = mean of (1 - F) w, offset = mean of F w, F = (1 - v.h)^5, w = 4 V (n.l) (v.h) / (n.h)
/// source: Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013
[node("Lighting/Ambient/Split Sum Table")] [extern]
void SplitSumTable(
    [range(0, 1)] float roughness = 0.5,  ///< perceptual roughness
    [range(0, 1)] float ndotv,            ///< cosine of normal and view
    out float scale,                      ///< of f0
    out float offset                      ///< of f90
) {
    float2 share = splitSumShare(saturate(roughness), saturate(ndotv));
    scale = share.x;
    offset = share.y;
}
