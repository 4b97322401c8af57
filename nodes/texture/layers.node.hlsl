// Reading textures that are more than one flat picture: cubes, arrays of layers, and 3D textures.

/// Samples a cube: a picture of all directions.
///
/// The mip level follows from derivatives. Where there are none (in the vertex stage, for each light, inside a branch), use
/// SampleTextureCubeLevel.
[node("Texture/Sample Texture Cube")] [also("SampleCubemap", "TexCube", "Cubemap", "TextureCube")] [is("texel")]
float4 SampleTextureCube(
    TextureCube texture,                    ///< cube to read
    float3 direction = normalWS,            ///< direction in world space, of any length
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    return texture.Sample(sampler, direction);
}

/// Samples a cube at a given level of detail.
[node("Texture/Sample Texture Cube Level")] [also("SampleCubemapLod", "TexCubelod")] [is("texel")]
float4 SampleTextureCubeLevel(
    TextureCube texture,                    ///< cube to read
    float3 direction = normalWS,            ///< direction in world space, of any length
    float level = 0,                        ///< mip level: 0 is the full size, each further one half of it
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    return texture.SampleLevel(sampler, direction, level);
}

/// Samples one layer of an array of textures.
///
/// The mip level follows from derivatives. Where there are none (in the vertex stage, for each light, inside a branch), use
/// SampleTexture2DArrayLevel.
[node("Texture/Sample Texture 2D Array")] [also("Tex2DArray", "Texture2DArray")] [is("texel")]
float4 SampleTexture2DArray(
    Texture2DArray texture,                 ///< array to read
    float2 uv = uv0,                        ///< texture coordinates
    float index = 0,                        ///< layer, from 0; rounded to the nearest one that exists
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    return texture.Sample(sampler, float3(uv, index));
}

/// Samples one layer of an array of textures at a given level of detail.
[node("Texture/Sample Texture 2D Array Level")] [also("SampleTexture2DArrayLod")] [is("texel")]
float4 SampleTexture2DArrayLevel(
    Texture2DArray texture,                 ///< array to read
    float2 uv = uv0,                        ///< texture coordinates
    float index = 0,                        ///< layer, from 0; rounded to the nearest one that exists
    float level = 0,                        ///< mip level: 0 is the full size, each further one half of it
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    return texture.SampleLevel(sampler, float3(uv, index), level);
}

/// Samples a 3D texture, also between its layers.
///
/// The mip level follows from derivatives. Where there are none (in the vertex stage, for each light, inside a branch), use
/// SampleTexture3DLevel.
[node("Texture/Sample Texture 3D")] [also("Tex3D", "Texture3D", "VolumeTexture")] [is("texel")]
float4 SampleTexture3D(
    Texture3D texture,                      ///< texture to read
    float3 uvw = float3(uv0, 0.5),          ///< coordinates, from 0 to 1 along each side
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    return texture.Sample(sampler, uvw);
}

/// Samples a 3D texture at a given level of detail.
[node("Texture/Sample Texture 3D Level")] [also("SampleTexture3DLod", "Tex3Dlod")] [is("texel")]
float4 SampleTexture3DLevel(
    Texture3D texture,                      ///< texture to read
    float3 uvw = float3(uv0, 0.5),          ///< coordinates, from 0 to 1 along each side
    float level = 0,                        ///< mip level: 0 is the full size, each further one half of it
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    return texture.SampleLevel(sampler, uvw, level);
}
