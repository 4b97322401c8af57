// Textures without texture coordinates: a surface gets the texture from three sides, and each side counts where the surface faces
// it. The texture stands upright on walls: its top is up (+y). From above, its top is towards +z.

/// How much each of the three sides counts, x, y and z; their sum is 1.
///
/// formula: |n|^blend / (sum of |n|^blend)
/// source: Geiss, "Generating Complex Procedural Terrains Using the GPU", GPU Gems 3, 2007, chapter 1
/// test: TriplanarWeights(float3(0, 1, 0), 4) == float3(0, 1, 0)
/// test: TriplanarWeights(float3(0.6, 0, -0.8), 1) == float3(0.42857142857142855, 0, 0.5714285714285714)
/// test: TriplanarWeights(float3(0.5, 0.5, 0.5), 8) == float3(0.3333333333333333, 0.3333333333333333, 0.3333333333333333)
/// test: TriplanarWeights(float3(0.6, 0, -0.8), 2) == float3(0.36, 0, 0.64)
[node("UV/Triplanar Weights")]
float3 TriplanarWeights(
    float3 normal = normalWS,       ///< direction that the surface faces; not zero
    [range(1, 64)] float blend = 4  ///< 1: soft transitions; the larger, the sharper
) {
    float3 weights = pow(abs(normal), blend);
    return weights / max(dot(weights, 1), 1e-6);
}

// Coordinates of a point on the sides that face x, y and z.
float2 SideX(float3 p) { return float2(p.z, -p.y); }
float2 SideY(float3 p) { return float2(p.x, -p.z); }
float2 SideZ(float3 p) { return float2(p.x, -p.y); }

/// Samples a texture from three sides, without texture coordinates.
///
/// formula: wx t(z, y) + wy t(x, z) + wz t(x, y), w: TriplanarWeights
/// source: Geiss, GPU Gems 3, 2007, chapter 1
[node("UV/Triplanar")] [also("TriplanarMapping", "TriplanarProjection", "WorldAlignedTexture")] [is("texel")]
float4 Triplanar(
    Texture2D texture,                      ///< texture to read
    float3 position = positionWS,           ///< where, in any space
    float3 normal = normalWS,               ///< direction that the surface faces, in the same space; not zero
    [also("tile")] float tiling = 1,        ///< textures in one unit of length
    [range(1, 64)] float blend = 1,         ///< 1: soft transitions; the larger, the sharper
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    float3 weights = TriplanarWeights(normal, blend);
    float3 p = position * tiling;
    return SampleTexture2D(texture, SideX(p), sampler) * weights.x + SampleTexture2D(texture, SideY(p), sampler) * weights.y +
           SampleTexture2D(texture, SideZ(p), sampler) * weights.z;
}

/// Samples a normal map from three sides, without texture coordinates: a unit normal.
///
/// The bumps of each side are added to the slopes of the surface (whiteout blending), so no side needs a tangent.
///
/// formula: normalize(wx (|a.z| n.x, a.y + n.y, a.x + n.z) + wy (b.x + n.x, |b.z| n.y, b.y + n.z) + wz (c.xy + n.xy, |c.z| n.z))
/// source: Golus, "Normal Mapping for a Triplanar Shader", 2017; Barré-Brisebois and Hill, "Blending in Detail", 2012 (whiteout)
[node("UV/Triplanar Normal")] [also("TriplanarNormalMap", "WorldAlignedNormal")] [is("direction", "space")]
float3 TriplanarNormal(
    [is("normalMap")] Texture2D texture,           ///< a normal map
    float3 position = positionWS,                  ///< where, in world space
    float3 normal = geometryNormalWS,              ///< unit normal of the surface, in world space
    [also("tile")] float tiling = 1,               ///< textures in one metre
    [range(1, 64)] float blend = 1,                ///< 1: soft transitions; the larger, the sharper
    [range(-2, 2)] float strength = 1,             ///< strength of the bumps
    const SurfaceSpace space = Tangent,            ///< the coordinate system of the result
    SamplerState sampler = texture.sampler,        ///< how it is read; default: as the texture says
    [hidden] float3 tangent = tangentWS,           ///< the frame, for tangent space
    [hidden] float3 bitangent = bitangentWS,       ///< the frame, for tangent space
    [hidden] float3 meshNormal = geometryNormalWS  ///< the frame, for tangent space
) {
    float3 weights = TriplanarWeights(normal, blend);
    float3 p = position * tiling;
    float3 a = SampleNormalMap(texture, SideX(p), strength, sampler);
    float3 b = SampleNormalMap(texture, SideY(p), strength, sampler);
    float3 c = SampleNormalMap(texture, SideZ(p), strength, sampler);
    float3 world = weights.x * float3(abs(a.z) * normal.x, a.y + normal.y, a.x + normal.z) +
                   weights.y * float3(b.x + normal.x, abs(b.z) * normal.y, b.y + normal.z) +
                   weights.z * float3(c.xy + normal.xy, abs(c.z) * normal.z);
    world = SafeNormalize(world, normal);
    return space == World ? world : WorldToTangent(world, meshNormal, tangent, bitangent);
}
