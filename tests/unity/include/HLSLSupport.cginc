// A stand-in for Unity's include of this name, written for these tests: what a shader of this project uses of it, under
// its documented names. Values are those of the runtime's uniform blocks, which the test declares before.
// In a project of gamma space (UNITY_COLORSPACE_GAMMA) textures, colours and lights come encoded.
// STAND_IN_DX9: a texture and its sampler are one. STAND_IN_2017: without what came later. STAND_IN_REGISTERS: the
// test says where the runtime binds each texture.
#define fixed half
#define fixed2 half2
#define fixed3 half3
#define fixed4 half4

#ifdef STAND_IN_DX9
#define UNITY_DECLARE_TEX2D(tex) sampler2D tex
#define UNITY_DECLARE_TEX2D_NOSAMPLER(tex) sampler2D tex
#define UNITY_SAMPLE_TEX2D(tex, coord) tex2D(tex, coord)
#define UNITY_SAMPLE_TEX2D_SAMPLER(tex, samplertex, coord) tex2D(tex, coord)
#else
#define SHADER_API_D3D11 1
#ifndef STAND_IN_2017
#define UNITY_SEPARATE_TEXTURE_SAMPLER
#endif
#ifdef STAND_IN_REGISTERS
#define UNITY_DECLARE_TEX2D(tex)        \
    Texture2D tex : REGISTER_##tex; \
    SamplerState sampler##tex : REGISTER_sampler##tex
#define UNITY_SAMPLE_TEX2D(tex, coord) TEXEL_##tex(tex.Sample(sampler##tex, coord))
#define UNITY_SAMPLE_TEX2D_SAMPLER(tex, samplertex, coord) TEXEL_##tex(tex.Sample(sampler##samplertex, coord))
#else
#define UNITY_DECLARE_TEX2D(tex) Texture2D tex; SamplerState sampler##tex
#define UNITY_DECLARE_TEX2D_NOSAMPLER(tex) Texture2D tex
#define UNITY_SAMPLE_TEX2D(tex, coord) tex.Sample(sampler##tex, coord)
#define UNITY_SAMPLE_TEX2D_SAMPLER(tex, samplertex, coord) tex.Sample(sampler##samplertex, coord)
#endif
#ifdef STAND_IN_REGISTERS
#define STAND_IN_TEXTURE(type, tex)   \
    type tex : REGISTER_##tex; \
    SamplerState sampler##tex : REGISTER_sampler##tex
#define STAND_IN_TEXEL(tex, texel) TEXEL_##tex(texel)
#else
#define STAND_IN_TEXTURE(type, tex) type tex; SamplerState sampler##tex
#define STAND_IN_TEXEL(tex, texel) texel
#endif
#define UNITY_DECLARE_TEXCUBE(tex) STAND_IN_TEXTURE(TextureCube, tex)
#define UNITY_SAMPLE_TEXCUBE(tex, coord) STAND_IN_TEXEL(tex, tex.Sample(sampler##tex, coord))
#define UNITY_SAMPLE_TEXCUBE_LOD(tex, coord, lod) STAND_IN_TEXEL(tex, tex.SampleLevel(sampler##tex, coord, lod))
#define UNITY_DECLARE_TEX2DARRAY(tex) STAND_IN_TEXTURE(Texture2DArray, tex)
#define UNITY_SAMPLE_TEX2DARRAY(tex, coord) STAND_IN_TEXEL(tex, tex.Sample(sampler##tex, coord))
#define UNITY_SAMPLE_TEX2DARRAY_LOD(tex, coord, lod) STAND_IN_TEXEL(tex, tex.SampleLevel(sampler##tex, coord, lod))
#define UNITY_DECLARE_TEX3D(tex) STAND_IN_TEXTURE(Texture3D, tex)
#define UNITY_SAMPLE_TEX3D(tex, coord) STAND_IN_TEXEL(tex, tex.Sample(sampler##tex, coord))
#define UNITY_SAMPLE_TEX3D_LOD(tex, coord, lod) STAND_IN_TEXEL(tex, tex.SampleLevel(sampler##tex, coord, lod))
#endif
// What Unity fills beside a texture.
#ifdef STAND_IN_REGISTERS
float4 size_of(Texture2D tex)
{
    uint width, height;
    tex.GetDimensions(width, height);
    return float4(1.0 / width, 1.0 / height, width, height);
}
#endif
#define UNITY_INITIALIZE_OUTPUT(type, name) name = (type)0;
#define UNITY_POSITION(pos) float4 pos : SV_POSITION
#define UNITY_ALLOWED_MRT_COUNT 8
#define UNITY_UV_STARTS_AT_TOP 1
#define UNITY_DECLARE_DEPTH_TEXTURE(tex) sampler2D tex
#define SAMPLE_DEPTH_TEXTURE_LOD(sampler, uv) (tex2Dlod(sampler, uv).r)

// IEC 61966-2-1, both ways.
float encoded_component(float c)
{
    return c <= 0.0031308 ? 12.92 * c : 1.055 * pow(abs(c), 1 / 2.4) - 0.055;
}
float decoded_component(float c)
{
    return c <= 0.04045 ? c / 12.92 : pow(abs(c + 0.055) / 1.055, 2.4);
}
half3 LinearToGammaSpace(half3 c)
{
    return half3(encoded_component(c.r), encoded_component(c.g), encoded_component(c.b));
}
half3 GammaToLinearSpace(half3 c)
{
    return half3(decoded_component(c.r), decoded_component(c.g), decoded_component(c.b));
}
// A colour as the project hands it over.
float3 handedOver(float3 c)
{
#ifdef UNITY_COLORSPACE_GAMMA
    c = LinearToGammaSpace(c);
#endif
    return c;
}
float4 handedOver(float4 c)
{
    return float4(handedOver(c.rgb), c.a);
}
float4 as_it_is(float4 c)
{
    return c;
}
