// Reading textures. `texture.tiling` holds the scale (xy) and offset (zw) that the material sets for the texture.

/// Samples a texture with filtering.
///
/// The mip level follows from derivatives. Where there are none (in the vertex stage, for each light, inside a branch), use
/// SampleTexture2DLevel.
[node("Texture/Sample Texture 2D")] [also("Image", "TiledImage", "Tex2D", "Texture", "Texture2D", "TextureSample", "UNITY_SAMPLE_TEX2D")] [is("texel")]
float4 SampleTexture2D(
    Texture2D texture,                      ///< texture to read
    float2 uv = uv0,                        ///< texture coordinates, before the texture's own tiling
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    return texture.Sample(sampler, uv * texture.tiling.xy + texture.tiling.zw);
}

/// Samples a texture at a given level of detail.
[node("Texture/Sample Texture 2D Level")] [also("SampleTexture2DLod", "Tex2Dlod", "TextureLod", "UNITY_SAMPLE_TEX2D_LOD")] [is("texel")]
float4 SampleTexture2DLevel(
    Texture2D texture,                      ///< texture to read
    float2 uv = uv0,                        ///< texture coordinates, before the texture's own tiling
    float level = 0,                        ///< mip level: 0 is the full size, each further one half of it
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    return texture.SampleLevel(sampler, uv * texture.tiling.xy + texture.tiling.zw, level);
}

/// Samples a texture where coordinates jump from pixel to pixel, as behind the edges of a relief (ParallaxOcclusion).
///
/// The mip level is derived from other coordinates, which do not jump. SampleTexture2D would treat an edge as a
/// texture seen from far away, and draw a seam of its smallest mip levels along the edge. If the texture is a normal map,
/// UnpackNormal decodes the normal.
[node("Texture/Sample Texture 2D Moved")] [is("texel")]
float4 SampleTexture2DMoved(
    Texture2D texture,                      ///< texture to read
    float2 uv = uv0,                        ///< texture coordinates, before the texture's own tiling
    float2 smoothUV = uv0,                  ///< the coordinates before they were moved: their change between pixels selects the mip level
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    float2 unmoved = smoothUV * texture.tiling.xy;
    return texture.SampleGrad(sampler, uv * texture.tiling.xy + texture.tiling.zw, ddx(unmoved), ddy(unmoved));
}

/// Samples a normal map: a normal in tangent space.
///
/// Give the texture the usage "normal", so that it is not decoded as a colour.
[node("Texture/Sample Normal Map")] [also("NormalMap", "BumpMap")] [is("normalTS")]
float3 SampleNormalMap(
    [is("normalMap")] Texture2D texture,    ///< a normal map; its property says if its green is down
    float2 uv = uv0,                        ///< texture coordinates, before the texture's own tiling
    [range(-2, 2)] float scale = 1,         ///< strength of the bumps
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    return UnpackNormal(SampleTexture2D(texture, uv, sampler), scale);
}

/// Reads one texel without filtering.
///
/// Neither tiling nor wrapping applies: keep the texel inside the texture.
[node("Texture/Load Texture 2D")] [also("TexelFetch")] [is("texel")]
float4 LoadTexture2D(
    Texture2D texture,            ///< texture to read
    float2 texel = 0,             ///< column and row, counted from 0 at the upper left; a fraction is dropped
    [range(0, 14)] int level = 0  ///< mip level
) {
    return texture.Load(int2(floor(texel)), level);
}

/// The size of one texel, and of the whole texture.
[node("Texture/Texel Size")] [also("TextureSize")]
float2 TexelSize(
    Texture2D texture,  ///< any texture
    out float2 size     ///< width and height in texels
) {
    size = texture.texelSize.zw;
    return texture.texelSize.xy;
}
