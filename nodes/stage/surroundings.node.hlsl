// Light from all around: part of the engine's interface. An engine may replace the [extern] functions; the runtime and
// the CPU reference use the bodies here.
// Units: radiance; the ambient irradiance is E/pi, the radiance of a white Lambert surface.

/// Ambient light as nine coefficients of spherical harmonics, order l(l+1)+m, red, green and blue in xyz: the
/// polynomials of Ramamoorthi and Hanrahan (2001), evaluated on world x, y and z unchanged.
/// unit: linear radiance
/// space: world
/// block: Light from all around. The engine fills it for each object, or once for all that see the same surroundings.
[extern("Ambient")] float4 ambientSH[9];

const float ENVIRONMENT_STEPS = 5;  // level of the map for a roughness of 1

/// What mirrors reflect. Each of the levels 0 to 5 is blurred for a rougher surface: level l for the perceptual roughness
/// r with 5 r (1.7 - 0.7 r) = l.
/// unit: linear radiance
/// space: world
/// block: The engine binds lightmaps, shadow masks and probes for each object, and the other textures once.
[extern] TextureCube environmentMap;
/// x: square root of n.v, y: perceptual roughness, from 0 to 1 between the centres of the outer texels of 64 x 64; red:
/// scale of f0, green: offset. It is the same for all environments.
[extern] Texture2D splitSumTable;

/// Objects reflect the probes near them instead of the environment.
[switch] bool reflectionProbes;
/// The map of the object's first probe, blurred as environmentMap is. environmentMap is then that of the second one, or
/// what is around.
/// unit: linear radiance
/// space: world
[extern] [with("reflectionProbes")] TextureCube probeMap;
/// Of the two probes: xyz: where the map was taken; w: 1 if what it shows is at the walls of its box, 0 if it is far away.
/// unit: m (xyz)
/// space: world
[extern("Ambient")] [with("reflectionProbes")] float4 probeCenter[2];
/// The lowest corner of each probe's box, in xyz; w: the distance outside of it over which the probe fades.
/// unit: m
/// space: world
[extern("Ambient")] [with("reflectionProbes")] float4 probeBoxMin[2];
/// The highest corner of each probe's box, in xyz.
/// unit: m
/// space: world
[extern("Ambient")] [with("reflectionProbes")] float4 probeBoxMax[2];
/// The share of the first probe, 0 to 1; the second one has the rest.
[extern("Ambient")] [with("reflectionProbes")] float probeShare;

/// Ambient irradiance divided by pi: a diffuse colour times it is radiance.
///
/// source: Ramamoorthi & Hanrahan, "An Efficient Representation for Irradiance Environment Maps", SIGGRAPH 2001
[node("Lighting/Ambient/Ambient Irradiance")] [also("ShadeSH9", "BakedGI")] [extern]
float3 AmbientIrradiance(
    float3 normal = normalWS  ///< unit normal in world space
) {
    return EvaluateSH9(normal, ambientSH[0].rgb, ambientSH[1].rgb, ambientSH[2].rgb, ambientSH[3].rgb,
                       ambientSH[4].rgb, ambientSH[5].rgb, ambientSH[6].rgb, ambientSH[7].rgb, ambientSH[8].rgb);
}

/// Radiance that a surface of a given roughness reflects from a direction: the environment, blurred by its GGX lobe.
///
/// source: Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013; mip levels as in Unity's reflection probes
[node("Lighting/Ambient/Environment Radiance")] [extern]
float3 EnvironmentRadiance(
    float3 direction = normalWS,        ///< unit direction in world space
    [range(0, 1)] float roughness = 0.5  ///< perceptual roughness
) {
    return environmentMap.SampleLevel(direction, MipFromRoughness(saturate(roughness), ENVIRONMENT_STEPS)).rgb;
}

// Scale and offset at a place of the table. The root gives most of the table to grazing views, where both change most.
float2 splitSumShare(float roughness, float ndotv) {
    return splitSumTable.SampleLevel(float2(sqrt(ndotv), roughness) * (63.0 / 64) + 0.5 / 64, 0).xy;
}

/// The table of the split sum: how strongly a rough surface reflects a uniform environment.
///
/// The reflectance is f0 scale + f90 offset, for GGX with Smith's exact joint visibility. scale + offset is the share of
/// light that perfectly reflecting facets send back after one bounce: the rest bounces between facets more than once.
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

/// Where to look in the map of a probe. Where it fades, there need be no wall.
float3 directionInProbe(int probe, float3 direction, float3 position) {
    float3 corrected = BoxProjectedDirection(direction, position, probeCenter[probe].xyz, probeBoxMin[probe].xyz,
                                             probeBoxMax[probe].xyz, probeBoxMin[probe].w);
    return probeCenter[probe].w > 0 ? corrected : direction;
}

/// EnvironmentRadiance of the probes near an object.
///
/// source: Lagarde and Zanuttini, "Local Image-based Lighting With Parallax-corrected Cubemaps", SIGGRAPH 2012
float3 radianceOfProbes(float3 direction, float roughness, float3 position) {
    float level = MipFromRoughness(saturate(roughness), ENVIRONMENT_STEPS);
    float3 first = probeMap.SampleLevel(directionInProbe(0, direction, position), level).rgb;
    float3 second = environmentMap.SampleLevel(directionInProbe(1, direction, position), level).rgb;
    return lerp(second, first, probeShare);
}
