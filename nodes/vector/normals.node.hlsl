// Normals: decoded from a normal map, scaled, blended, and transformed between tangent space and world space. In
// tangent space, x follows the texture's u, y points up in the texture and z out of the surface; the flat normal is
// (0, 0, 1).

/// How NormalBlend combines two normals.
enum NormalBlendMode {
    Whiteout,           ///< adds x and y, multiplies z: cheap, and independent of the order of the layers
    Reoriented,         ///< rotates the detail onto the base: keeps both at full strength
    Linear,             ///< the direction half-way between: each layer loses strength, even to a flat one
    Unreal,             ///< adds x and y, keeps the z of the base: the detail fades where the base is steep
    PartialDerivative   ///< adds the slopes, as if the heights were added
};

/// Computes the z of a unit normal from its x and y.
///
/// formula: z = sqrt(1 - x^2 - y^2)
/// test: NormalReconstructZ(float2(0.6, 0)) == float3(0.6, 0, 0.8)
/// test: NormalReconstructZ(float2(2 / 7, 3 / 7)) == float3(2 / 7, 3 / 7, 6 / 7)
/// test: NormalReconstructZ(float2(1, 1)) == float3(1, 1, 0)
[node("Vector/Normal/Reconstruct Z")]
float3 NormalReconstructZ(
    float2 xy = 0  ///< inside the unit circle; outside it z is 0
) {
    return float3(xy, sqrt(saturate(1 - dot(xy, xy))));
}

/// Which channels of a normal map hold x, y and z.
enum NormalEncoding {
    RedGreen,      ///< x and y; z is computed, so two channels are enough
    RedAlphaGreen, ///< x is red times alpha: also reads formats that keep x in alpha and leave red at 1
    AlphaGreen,    ///< x in alpha, y in green: block compression keeps these best
    RedGreenBlue   ///< x, y and z; a scale then leaves it shorter or longer than 1
};

/// Decodes a tangent-space normal from the texel of a normal map.
///
/// formula: xy = (2 texel - 1) scale, z = sqrt(1 - x^2 - y^2), or 2 blue - 1
/// source: the encodings: Unity built-in shaders, UnpackScaleNormal
/// test: UnpackNormal(float4(0.5, 0.5, 1, 1)) == float3(0, 0, 1)
/// test: UnpackNormal(float4(0.8, 0.7, 0, 1)) == float3(0.6, 0.4, 0.6928203230275509)
/// test: UnpackNormal(float4(0.8, 0.7, 1, 1), 0.5) == float3(0.3, 0.2, 0.9327379053088815)
/// test: UnpackNormal(float4(1, 0.7, 1, 0.8), 0.5, RedAlphaGreen) == float3(0.3, 0.2, 0.9327379053088815)
/// test: UnpackNormal(float4(0.8, 0.7, 0, 1), 1, RedAlphaGreen) == float3(0.6, 0.4, 0.6928203230275509)
/// test: UnpackNormal(float4(1, 0.7, 1, 0.8), 0.5, AlphaGreen) == float3(0.3, 0.2, 0.9327379053088815)
/// test: UnpackNormal(float4(0.8, 0.3, 0.9, 1), 0.5, RedGreenBlue) == float3(0.3, -0.2, 0.8)
[node("Vector/Normal/Unpack")] [also("NormalUnpack", "UnpackNormalWithScale", "UnpackScaleNormal")] [is("normalTS")]
float3 UnpackNormal(
    [is("texel")] float4 encoded = float4(0.5, 0.5, 1, 1),  ///< the texel, not decoded from sRGB
    [range(-2, 2)] float scale = 1,           ///< strength of the bumps; a negative scale turns them into dents
    const NormalEncoding encoding = RedGreen  ///< which channels hold x, y and z
) {
    float2 xy = encoded.rg;
    if (encoding == RedAlphaGreen) { xy = float2(encoded.r * encoded.a, encoded.g); }
    if (encoding == AlphaGreen) { xy = encoded.ag; }
    xy = (xy * 2 - 1) * scale;
    if (encoding == RedGreenBlue) { return float3(xy, encoded.b * 2 - 1); }
    return NormalReconstructZ(xy);
}

/// Weakens or strengthens the slope of a tangent-space normal.
///
/// formula: normalize(strength x, strength y, z)
/// test: NormalStrength(float3(0.6, 0, 0.8), 0) == float3(0, 0, 1)
/// test: NormalStrength(float3(0.6, 0, 0.8), 1) == float3(0.6, 0, 0.8)
/// test: NormalStrength(float3(0.6, 0, 0.8), 2) == float3(0.8320502943378437, 0, 0.5547001962252291)
[node("Vector/Normal/Strength")] [is("normalTS")]
float3 NormalStrength(
    [is("normalTS")] float3 normal = float3(0, 0, 1),  ///< unit normal in tangent space
    [range(0, 2)] float strength = 1  ///< 0 is flat, 1 leaves it as it is
) {
    // The slope of a normal in the surface's plane is infinite: the normal counts as almost in the plane.
    return normalize(float3(normal.xy * strength, max(normal.z, 0.001)));
}

/// Blends a detail normal over a base normal, both in tangent space.
///
/// formula: reoriented: t dot(t, u) / t.z - u, t = base + (0, 0, 1), u = detail (-1, -1, 1)
/// formula: whiteout: normalize(b.xy + d.xy, b.z d.z); linear: normalize(b + d); Unreal: normalize(b.xy + d.xy, b.z)
/// formula: partial derivative: normalize(b.xy d.z + d.xy b.z, b.z d.z)
/// source: Barré-Brisebois and Hill, "Blending in Detail", 2012, where all five stand side by side; whiteout: Oat,
/// source: "Animated Wrinkle Maps", SIGGRAPH 2007 course, and Unity built-in shaders, BlendNormals
/// test: NormalBlend(float3(0.6, 0, 0.8), float3(0.6, 0, 0.8), Reoriented) == float3(0.96, 0, 0.28)
/// test: NormalBlend(float3(0, 0, 1), float3(0.48, 0.6, 0.64), Reoriented) == float3(0.48, 0.6, 0.64)
/// test: NormalBlend(float3(0.48, 0.6, 0.64), float3(0, 0, 1), Reoriented) == float3(0.48, 0.6, 0.64)
/// test: NormalBlend(float3(0.6, 0, 0.8), float3(0, 0, 1), Whiteout) == float3(0.6, 0, 0.8)
/// test: NormalBlend(float3(2, 3, 6) / 7, float3(-2, 3, 6) / 7, Whiteout) == float3(0, 7, 6) / 9.219544457292887
/// test: NormalBlend(float3(0.6, 0, 0.8), float3(0, 0.6, 0.8), Linear) == float3(3, 3, 8) / 9.055385138137417
/// test: NormalBlend(float3(0, 0, 1), float3(0.48, 0.6, 0.64), Unreal) == float3(12, 15, 25) / 31.52776554086889
/// test: NormalBlend(float3(2, 3, 6) / 7, float3(-2, 3, 6) / 7, Unreal) == float3(0, 1, 1) * 0.7071067811865476
/// test: NormalBlend(float3(0.6, 0, 0.8), float3(0.6, 0, 0.8), PartialDerivative) == float3(3, 0, 2) / 3.605551275463989
/// test: NormalBlend(float3(0.6, 0, 0.8), float3(0, -0.8, 0.6), PartialDerivative) == float3(9, -16, 12) / 21.93171219946131
[node("Vector/Normal/Blend")] [also("BlendNormals")] [is("normalTS")]
float3 NormalBlend(
    [is("normalTS")] float3 base = float3(0, 0, 1),    ///< unit normal of the layer below
    [is("normalTS")] float3 detail = float3(0, 0, 1),  ///< unit normal of the layer above
    const NormalBlendMode mode = Reoriented  ///< how they are combined
) {
    if (mode == Reoriented) {
        float3 tilted = base + float3(0, 0, 1);
        float3 mirrored = detail * float3(-1, -1, 1);
        // If the base points straight into the surface, its tilt is not defined.
        return tilted * (dot(tilted, mirrored) / max(tilted.z, 1e-4)) - mirrored;
    }
    float3 sum = base + detail;
    if (mode == Whiteout) { sum.z = base.z * detail.z; }
    if (mode == Unreal) { sum.z = base.z; }
    if (mode == PartialDerivative) { sum = float3(base.xy * detail.z + detail.xy * base.z, base.z * detail.z); }
    return sum * rsqrt(max(dot(sum, sum), 1e-7));
}

/// Blends a detail normal over a base normal through a mask, both in tangent space.
///
/// If the mask is between 0 and 1, the result is a little shorter than 1; NormalTangentToWorld normalizes it.
///
/// formula: lerp(base, NormalBlend(base, detail), mask)
/// source: Unity built-in shaders, NormalInTangentSpace (Whiteout)
/// test: DetailNormal(float3(0.6, 0, 0.8), float3(0.6, 0, 0.8), 1, Reoriented) == float3(0.96, 0, 0.28)
/// test: DetailNormal(float3(0.6, 0, 0.8), float3(0.6, 0, 0.8), 0.5, Reoriented) == float3(0.78, 0, 0.54)
/// test: DetailNormal(float3(0.6, 0, 0.8), float3(0, 0.6, 0.8), 0, Whiteout) == float3(0.6, 0, 0.8)
/// test: DetailNormal(float3(0.6, 0, 0.8), float3(0, 0.6, 0.8), 1, Linear) == float3(3, 3, 8) / 9.055385138137417
/// test: DetailNormal(float3(0, 0, 1), float3(0.48, 0.6, 0.64), 1, Unreal) == float3(12, 15, 25) / 31.52776554086889
/// test: DetailNormal(float3(0.6, 0, 0.8), float3(0.6, 0, 0.8), 1, PartialDerivative) == float3(3, 0, 2) / 3.605551275463989
[node("Vector/Normal/Detail")] [is("normalTS")]
float3 DetailNormal(
    [is("normalTS")] float3 base = float3(0, 0, 1),    ///< unit normal of the layer below
    [is("normalTS")] float3 detail = float3(0, 0, 1),  ///< unit normal of the layer above
    [range(0, 1)] float mask = 1,          ///< 0: the base alone
    const NormalBlendMode mode = Whiteout  ///< how they are combined
) {
    return lerp(base, NormalBlend(base, detail, mode), mask);
}

/// Transforms a normal from tangent space to world space.
///
/// The frame may be interpolated and slightly skewed; the result is unit length.
///
/// formula: normalize(tangent x + bitangent y + normal z)
/// test: NormalTangentToWorld(float3(3, 0, 4), float3(0, 0, 1), float3(1, 0, 0), 0) == float3(0.6, 0, 0.8)
/// test: NormalTangentToWorld(float3(0, 3, 4), float3(0, 0, 1), 0, float3(0, 1, 0)) == float3(0, 0.6, 0.8)
/// test: NormalTangentToWorld(float3(0, 2, 0), float3(0, 1, 0), float3(0, 0, 1), float3(1, 0, 0)) == float3(1, 0, 0)
[node("Vector/Normal/Tangent to World")] [also("TangentToWorld")] [is("normalWS")]
float3 NormalTangentToWorld(
    float3 normalTS = float3(0, 0, 1),  ///< unit normal in tangent space
    float3 normal = geometryNormalWS,  ///< unit normal of the mesh, in the world
    float3 tangent = tangentWS,         ///< unit direction of growing u
    float3 bitangent = bitangentWS      ///< unit direction that points up in the texture
) {
    return normalize(tangent * normalTS.x + bitangent * normalTS.y + normal * normalTS.z);
}

/// Transforms a direction from world space to tangent space: its parts along the surface and away from it.
///
/// formula: (dot(tangent, d), dot(bitangent, d), dot(normal, d))
/// test: WorldToTangent(float3(0, 1, 0), float3(0, 1, 0), float3(1, 0, 0), float3(0, 0, -1)) == float3(0, 0, 1)
/// test: WorldToTangent(float3(1, 2, 3), float3(-1, 2, 2), float3(2, -1, 2), float3(2, 2, -1)) == float3(6, 3, 9)
[node("Vector/Normal/World to Tangent")] [is("directionTS")]
float3 WorldToTangent(
    [is("directionWS")] float3 direction = viewDirWS,  ///< any vector in the world
    float3 normal = geometryNormalWS,  ///< unit normal of the mesh, in the world
    float3 tangent = tangentWS,         ///< unit direction of growing u
    float3 bitangent = bitangentWS      ///< unit direction that points up in the texture
) {
    return float3(dot(tangent, direction), dot(bitangent, direction), dot(normal, direction));
}

// The distance from the centre of the stereographic projection that is stored as 1: 121 degrees from the viewer.
const float STEREOGRAPHIC_SCALE = 1.7777;

/// Stores a view-space normal in two numbers, by stereographic projection.
///
/// Normals up to 121 degrees from the direction to the viewer lie between 0 and 1: more than a perspective view shows.
/// A normal that points straight away cannot be stored.
///
/// formula: 0.5 + 0.5 n.xy / (1.7777 (1 + n.z))
/// source: Unity built-in shaders, EncodeViewNormalStereo
/// test: EncodeNormalStereographic(float3(0, 0, 1)) == float2(0.5, 0.5)
/// test: EncodeNormalStereographic(float3(0.6, 0, 0.8)) == float2(0.5937541017419512, 0.5)
/// test: EncodeNormalStereographic(float3(-0.48, 0.6, 0.64)) == float2(0.41767932529975016, 0.6029008433753122)
/// test: EncodeNormalStereographic(float3(0, 0, -1)) == float2(0.5, 0.5)
[node("Vector/Normal/Encode Stereographic")]
float2 EncodeNormalStereographic(
    float3 normalVS = normalVS  ///< unit normal in view space: x right, y up, z to the viewer
) {
    return normalVS.xy * (0.5 / STEREOGRAPHIC_SCALE / max(1 + normalVS.z, 1e-4)) + 0.5;
}

/// Reads the view-space normal that EncodeNormalStereographic stored.
///
/// formula: p = 1.7777 (2 e - 1), g = 2 / (dot(p, p) + 1), n = (g p, g - 1)
/// source: Unity built-in shaders, DecodeViewNormalStereo
/// test: DecodeNormalStereographic(float2(0.5, 0.5)) == float3(0, 0, 1)
/// test: DecodeNormalStereographic(float2(0.5937541017419512, 0.5)) == float3(0.6, 0, 0.8)
/// test: DecodeNormalStereographic(float2(0.41767932529975016, 0.6029008433753122)) == float3(-0.48, 0.6, 0.64)
[node("Vector/Normal/Decode Stereographic")] [range(-1, 1)]
float3 DecodeNormalStereographic(
    [range(0, 1)] float2 encoded = 0.5  ///< the two numbers
) {
    float2 p = STEREOGRAPHIC_SCALE * (2 * encoded - 1);
    float g = 2 / (dot(p, p) + 1);
    return float3(g * p, g - 1);
}
