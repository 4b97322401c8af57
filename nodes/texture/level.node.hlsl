// Reading textures with a mip level that the caller influences, and what a sampler would do.

/// Samples a texture sharper or softer than its distance asks for.
[node("Texture/Sample Texture 2D Bias")] [also("Tex2Dbias", "TextureBias", "SampleTexture2DMipBias")] [is("texel")]
float4 SampleTexture2DBias(
    Texture2D texture,                      ///< texture to read
    float2 uv = uv0,                        ///< texture coordinates, before the texture's own tiling
    [range(-16, 16)] float bias = 0,        ///< added to the mip level: below 0 sharper, above 0 softer
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    return texture.SampleBias(sampler, uv * texture.tiling.xy + texture.tiling.zw, bias);
}

/// Samples a texture with given derivatives, from which the mip level and the direction of anisotropic filtering follow.
///
/// It works everywhere, also in a branch and for each light. SampleTexture2DMoved takes the derivatives from coordinates.
[node("Texture/Sample Texture 2D Grad")] [also("Tex2Dgrad", "TextureGrad", "SampleTexture2DGradient", "SampleTexture2DDerivatives")] [is("texel")]
float4 SampleTexture2DGrad(
    Texture2D texture,                      ///< texture to read
    float2 uv = uv0,                        ///< texture coordinates, before the texture's own tiling
    float2 right,                           ///< change of uv from this pixel to the next one on the right
    float2 down,                            ///< change of uv from this pixel to the next one below
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    float2 tiling = texture.tiling.xy;
    return texture.SampleGrad(sampler, uv * tiling + texture.tiling.zw, right * tiling, down * tiling);
}

/// Samples one layer of an array of textures sharper or softer than its distance asks for.
[node("Texture/Sample Texture 2D Array Bias")] [is("texel")]
float4 SampleTexture2DArrayBias(
    Texture2DArray texture,                 ///< array to read
    float2 uv = uv0,                        ///< texture coordinates
    float index = 0,                        ///< layer, from 0; rounded to the nearest one that exists
    [range(-16, 16)] float bias = 0,        ///< added to the mip level: below 0 sharper, above 0 softer
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    return texture.SampleBias(sampler, float3(uv, index), bias);
}

/// Samples one layer of an array of textures with given derivatives.
[node("Texture/Sample Texture 2D Array Grad")] [also("SampleTexture2DArrayDerivatives")] [also("SampleTexture2DArrayGradient")] [is("texel")]
float4 SampleTexture2DArrayGrad(
    Texture2DArray texture,                 ///< array to read
    float2 uv = uv0,                        ///< texture coordinates
    float index = 0,                        ///< layer, from 0; rounded to the nearest one that exists
    float2 right = 0,                       ///< change of uv from this pixel to the next one on the right
    float2 down = 0,                        ///< change of uv from this pixel to the next one below
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    return texture.SampleGrad(sampler, float3(uv, index), right, down);
}

/// Samples a cube in the direction in which a surface mirrors the viewer.
///
/// formula: cube(reflect(-view, normal))
/// source: Blinn and Newell, "Texture and Reflection in Computer Generated Images", CACM 19(10), 1976
[node("Texture/Sample Reflected Cubemap")] [also("SampleReflectedTextureCube")] [is("texel")]
float4 SampleReflectedCubemap(
    TextureCube texture,                    ///< cube to read
    float3 view = viewDirWS,                ///< direction to the viewer
    float3 normal = normalWS,               ///< unit normal, in the same space
    [range(0, 14)] float level = 0,         ///< mip level: 0 is the full size, each further one half of it
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    return texture.SampleLevel(sampler, reflect(-view, normal), level);
}

/// The four texels that bilinear filtering would blend, red of each: lower left, lower right, upper right, upper left.
///
/// formula: x (0, 1), y (1, 1), z (1, 0), w (0, 0): columns and rows from the upper left one of the four
/// source: the order of Gather in Direct3D 11 and of textureGather in GLSL
[node("Texture/Gather Texture 2D")] [also("TextureGather", "GatherRed")] [is("texel")]
float4 GatherTexture2D(
    Texture2D texture,                      ///< texture to read; its filter may be bilinear or point
    float2 uv = uv0,                        ///< texture coordinates, before the texture's own tiling
    float2 offset = 0,                      ///< whole texels to the right and down
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    float2 size = texture.texelSize.zw;
    float2 place = uv * texture.tiling.xy + texture.tiling.zw;
    // The centre of the upper left texel; at a centre, filtering returns the texel itself.
    float2 corner = (floor(place * size - 0.5) + 0.5 + round(offset)) / size;
    float2 next = 1 / size;
    float lowerLeft = texture.SampleLevel(sampler, corner + float2(0, next.y), 0).r;
    float lowerRight = texture.SampleLevel(sampler, corner + next, 0).r;
    float upperRight = texture.SampleLevel(sampler, corner + float2(next.x, 0), 0).r;
    float upperLeft = texture.SampleLevel(sampler, corner, 0).r;
    return float4(lowerLeft, lowerRight, upperRight, upperLeft);
}

/// Whether a mip level is limited to those that a texture has.
enum LevelLimit {
    Clamped,   ///< from 0 to the smallest level
    Unclamped  ///< below 0 where a texel is larger than a pixel
};

/// The mip level of a square texel grid whose texels change by `right` and `down` from pixel to pixel.
///
/// formula: log2 max(|right|, |down|)
/// source: Williams, "Pyramidal Parametrics", SIGGRAPH 1983; Vulkan specification, "Scale Factor Operation"
/// test: LevelOfTexels(float2(4, 0), float2(0, 1)) == 2
/// test: LevelOfTexels(float2(0, 0.5), float2(0.25, 0)) == -1
/// test: LevelOfTexels(float2(3, 4), float2(6, 8)) == 3.321928094887362
[node("Texture/Level of Texels")]
float LevelOfTexels(
    float2 right,  ///< change from this pixel to the next one on the right, in texels
    float2 down    ///< change from this pixel to the next one below, in texels
) {
    return 0.5 * log2(max(max(dot(right, right), dot(down, down)), 1e-12));
}

/// The mip level that SampleTexture2D reads a texture with, as a filter without anisotropy chooses it.
///
/// formula: LevelOfTexels of the change of uv; the smallest level is log2 of the larger side
[node("Texture/Calculate Level")] [also("CalculateLevelOfDetail", "CalculateLevelOfDetailTexture2D", "TextureQueryLod", "MipLevel")]
float CalculateLevel(
    Texture2D texture,                  ///< texture that would be read
    float2 uv = uv0,                    ///< texture coordinates, before the texture's own tiling
    const LevelLimit limit = Clamped    ///< whether the result is limited
) {
    float2 size = texture.texelSize.zw;
    float2 place = uv * texture.tiling.xy * size;
    float level = LevelOfTexels(ddx(place), ddy(place));
    if (limit == Unclamped) { return level; }
    return clamp(level, 0, floor(log2(max(size.x, size.y)) + 1e-4));
}

/// The tiling and the offset that the material sets for a texture.
///
/// Nodes that sample apply them by themselves.
[node("Texture/Split Texture Transform")] [also("TextureTransform", "TextureTiling", "TextureST")]
float2 SplitTextureTransform(
    Texture2D texture,  ///< any texture
    out float2 offset   ///< translation, in textures
) {
    offset = texture.tiling.zw;
    return texture.tiling.xy;
}
