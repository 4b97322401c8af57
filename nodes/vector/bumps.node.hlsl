// Normals of heights, and Unity's form of a normal's strength.

/// Weakens or strengthens a tangent-space normal as Unity's node does: the result is not a unit vector.
///
/// formula: (strength x, strength y, lerp(1, z, saturate(strength)))
/// source: Unity Shader Graph, Normal Strength
/// test: NormalStrengthUnity(float3(0.6, 0, 0.8), 0) == float3(0, 0, 1)
/// test: NormalStrengthUnity(float3(0.6, 0, 0.8), 0.5) == float3(0.3, 0, 0.9)
/// test: NormalStrengthUnity(float3(0.6, 0, 0.8), 2) == float3(1.2, 0, 0.8)
[node("Vector/Normal/Strength Unity")] [is("normalTS")]
float3 NormalStrengthUnity(
    [is("normalTS")] float3 normal = float3(0, 0, 1),  ///< unit normal in tangent space
    [range(0, 8)] float strength = 1                   ///< 0 is flat, 1 leaves it as it is
) {
    return float3(normal.xy * strength, lerp(1, normal.z, saturate(strength)));
}

/// A normal from a height that a graph computes: the surface seems to stand out by that much.
///
/// The slope is measured from pixel to pixel, in squares of two by two; a normal map of the same heights is smoother.
///
/// formula: normalize(|d| n - strength sign(d) g), d = dot(px, cross(py, n)), g = hx cross(py, n) + hy cross(n, px); px, py, hx, hy:
/// formula: derivatives of position and height on the screen
/// source: Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU", Journal of Graphics, GPU, and Game Tools, 2010
[node("Vector/Normal/From Height")] [also("HeightToNormal", "Bump")] [inFloat]
float3 NormalFromHeight(
    float height = 0,                                ///< the height
    float strength = 0.01,                           ///< metres for a height of 1
    const SurfaceSpace space = Tangent,              ///< the coordinate system of the result
    [hidden] float3 position = positionWS,           ///< where the surface is
    [hidden] float3 normal = geometryNormalWS,       ///< the frame
    [hidden] float3 tangent = tangentWS,             ///< the frame, for tangent space
    [hidden] float3 bitangent = bitangentWS          ///< the frame, for tangent space
) {
    float3 across = ddx(position);
    float3 down = ddy(position);
    float3 crossAcross = cross(normal, across);
    float3 crossDown = cross(down, normal);
    float area = dot(across, crossDown);
    float3 slope = ddx(height) * crossDown + ddy(height) * crossAcross;
    // A pixel that sees the surface edge-on covers no area of it.
    slope = slope * (sign(area) / max(abs(area), 1e-15));
    float3 bumped = SafeNormalize(normal - strength * slope, normal);
    return space == World ? bumped : WorldToTangent(bumped, normal, tangent, bitangent);
}

/// A tangent-space normal from a texture of heights: three samples, here, to the right, and above.
///
/// formula: normalize(cross((1, 0, s (h(u + d, v) - h)), (0, 1, s (h(u, v - d) - h)))), d = 0.1 offset^3, s = strength
/// source: forward differences; the scale of the offset: Unity Shader Graph, Normal From Texture
[node("Vector/Normal/From Texture")] [also("HeightToNormalMap")] [is("normalTS")]
float3 NormalFromTexture(
    [is("data")] Texture2D texture,         ///< heights in red
    float2 uv = uv0,                        ///< texture coordinates
    [range(0, 1)] float offset = 0.5,       ///< how far apart the samples are: a tenth of its cube, in textures
    [range(0, 50)] float strength = 8,      ///< height of white over black, in distances between samples
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    float apart = offset * offset * offset * 0.1;
    float here = SampleTexture2D(texture, uv, sampler).r;
    float right = SampleTexture2D(texture, uv + float2(apart, 0), sampler).r;
    float above = SampleTexture2D(texture, uv - float2(0, apart), sampler).r;
    return normalize(float3((here - right) * strength, (here - above) * strength, 1));
}
