// Lists the words that some language reserves. There is one list for all languages, so that a name is the same in each
// of them. It is complete for what glslang, DXC and fxc refuse, but not for the dialects of single vendors.
#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_set>

#include "compiler/languages/print.h"

namespace patina::languages {
namespace {

constexpr std::string_view kLists[] = {
    // Keywords that GLSL and HLSL share, and those of C that both reserve.
    R"(asm auto bool break case cast catch char class const const_cast continue default delete discard do double
    dynamic_cast else enum explicit extern external false float for friend goto half if in inline inout int
    interface invariant long mutable namespace new operator out precise private protected public register
    reinterpret_cast return short signed sizeof static static_cast struct switch template this throw true try
    typedef typename uint union unsigned using virtual void volatile while concept requires nullptr NULL main
    alignas alignof and and_eq bitand bitor compl constexpr decltype export final noexcept not not_eq or or_eq
    override static_assert thread_local typeid wchar_t xor xor_eq)",
    // GLSL: keywords, and words reserved for the future.
    R"(attribute uniform varying buffer shared coherent restrict readonly writeonly layout centroid flat smooth
    noperspective patch sample subroutine lowp mediump highp precision common partition active filter resource
    atomic_uint fixed unsigned superp noinline input output hvec2 hvec3 hvec4 fvec2 fvec3 fvec4 sampler3DRect demote
    vec2 vec3 vec4 dvec2 dvec3 dvec4 bvec2 bvec3 bvec4 ivec2 ivec3 ivec4 uvec2 uvec3 uvec4 mat2 mat3 mat4 mat2x2
    mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 dmat2 dmat3 dmat4 dmat2x2 dmat2x3 dmat2x4 dmat3x2
    dmat3x3 dmat3x4 dmat4x2 dmat4x3 dmat4x4 float16_t f16vec2 f16vec3 f16vec4 f16mat2 f16mat3 f16mat4 float32_t
    float64_t int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t sampler sampler1D sampler2D
    sampler3D samplerCube sampler1DShadow sampler2DShadow samplerCubeShadow sampler1DArray sampler2DArray
    samplerCubeArray sampler2DRect samplerBuffer sampler2DMS samplerShadow isampler2D isampler3D isamplerCube
    usampler2D usampler3D usamplerCube texture1D texture2D texture3D textureCube texture1DArray texture2DArray
    textureCubeArray textureBuffer texture2DMS texture2DRect itexture2D utexture2D image1D image2D image3D imageCube
    image2DArray imageBuffer iimage2D uimage2D subpassInput)",
    // GLSL: built-in functions.
    R"(radians degrees sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh pow exp log exp2 log2 sqrt
    inversesqrt abs sign floor trunc round roundEven ceil fract mod modf min max clamp mix step smoothstep isnan
    isinf floatBitsToInt floatBitsToUint intBitsToFloat uintBitsToFloat fma frexp ldexp packUnorm2x16 packSnorm2x16
    unpackUnorm2x16 unpackSnorm2x16 packHalf2x16 unpackHalf2x16 packDouble2x32 unpackDouble2x32 length distance dot
    cross normalize ftransform faceforward reflect refract matrixCompMult outerProduct transpose determinant inverse
    lessThan lessThanEqual greaterThan greaterThanEqual equal notEqual any all not bitfieldExtract bitfieldInsert
    bitfieldReverse bitCount findLSB findMSB texture textureSize textureLod textureGrad textureProj textureOffset
    textureGather textureQueryLod textureQueryLevels texelFetch texelFetchOffset texture2DLod imageLoad imageStore
    imageSize dFdx dFdy dFdxFine dFdyFine dFdxCoarse dFdyCoarse fwidth fwidthFine fwidthCoarse interpolateAtCentroid
    interpolateAtSample interpolateAtOffset noise1 noise2 noise3 noise4 barrier memoryBarrier allInvocations
    anyInvocation subpassLoad)",
    // HLSL: keywords.
    R"(AppendStructuredBuffer BlendState Buffer ByteAddressBuffer CompileShader ComputeShader ConsumeStructuredBuffer
    ConstantBuffer FeedbackTexture2D FeedbackTexture2DArray RasterizerOrderedBuffer RasterizerOrderedByteAddressBuffer
    RasterizerOrderedStructuredBuffer RasterizerOrderedTexture1D RasterizerOrderedTexture1DArray
    RasterizerOrderedTexture2D RasterizerOrderedTexture2DArray RasterizerOrderedTexture3D RWTexture1DArray
    RWTexture2DArray RaytracingAccelerationStructure RayDesc RayQuery SubpassInput SubpassInputMS DepthStencilState DepthStencilView DomainShader GeometryShader Hullshader HullShader InputPatch
    LineStream OutputPatch PixelShader PointStream RWBuffer RWByteAddressBuffer RWStructuredBuffer RWTexture1D
    RWTexture2D RWTexture3D RasterizerState RenderTargetView SamplerComparisonState SamplerState StructuredBuffer
    Texture1D Texture1DArray Texture2D Texture2DArray Texture2DMS Texture2DMSArray Texture3D TextureCube
    TextureCubeArray Texture TextureBuffer TriangleStream VertexShader cbuffer tbuffer column_major row_major
    compile compile_fragment export fxgroup globallycoherent groupshared line lineadj linear matrix min10float
    min12int min16float min16int min16uint nointerpolation packoffset pass Pass pixelfragment point vertexfragment
    snorm unorm stateblock stateblock_state string technique Technique technique10 technique11 triangle triangleadj
    vector sampler_state dword DWORD FLOAT VECTOR MATRIX STRING TEXTURE SAMPLER VERTEXSHADER PIXELSHADER decl Decl
    asm_fragment samplerCUBE samplerRECT textureCUBE textureRECT int8_t4_packed uint8_t4_packed
    uniform unsigned register vertexshader pixelshader in inout)",
    // HLSL: intrinsic functions.
    R"(abort all AllMemoryBarrier asdouble asfloat asint asuint asfloat16 atan2 CheckAccessFullyMapped clip countbits
    D3DCOLORtoUBYTE4 ddx ddx_coarse ddx_fine ddy ddy_coarse ddy_fine DeviceMemoryBarrier dst errorf
    EvaluateAttributeAtCentroid EvaluateAttributeAtSample EvaluateAttributeSnapped f16tof32 f32tof16 firstbithigh
    firstbitlow fmod frac GetRenderTargetSampleCount GetRenderTargetSamplePosition GroupMemoryBarrier InterlockedAdd
    InterlockedAnd InterlockedMax InterlockedMin InterlockedOr InterlockedXor isfinite isnormal lerp lit log10 mad
    msad4 mul noise NonUniformResourceIndex printf rcp reversebits rsqrt saturate select sincos tex1D tex1Dbias
    tex1Dgrad tex1Dlod tex1Dproj tex2D tex2Dbias tex2Dgrad tex2Dlod tex2Dproj tex3D tex3Dbias tex3Dgrad tex3Dlod
    tex3Dproj texCUBE texCUBEbias texCUBEgrad texCUBElod texCUBEproj texRECT texRECTproj AllMemoryBarrierWithGroupSync
    DeviceMemoryBarrierWithGroupSync GroupMemoryBarrierWithGroupSync InterlockedCompareExchange
    InterlockedCompareStore InterlockedExchange WaveGetLaneIndex
    QuadReadAcrossX QuadReadAcrossY dot2add dot4add_i8packed)",
};

// Types of HLSL that have vectors and matrices: "half" for "half3" and "half4x4".
constexpr std::string_view kScalars[] = {"bool",      "int",       "uint",     "dword",     "half",       "float",
                                         "double",    "min16int",  "min12int", "min16uint", "min16float", "min10float",
                                         "int16_t",   "int32_t",   "int64_t",  "uint16_t",  "uint32_t",   "uint64_t",
                                         "float16_t", "float32_t", "float64_t"};

bool is_size(char c) {
    return c >= '1' && c <= '4';
}

bool is_vector_or_matrix(std::string_view word) {
    if (word.size() < 4 || !is_size(word.back())) return false;
    word.remove_suffix(1);
    if (word.back() == 'x' && is_size(word[word.size() - 2])) word.remove_suffix(2);
    return std::find(std::begin(kScalars), std::end(kScalars), word) != std::end(kScalars);
}

class ReservedWords {
public:
    ReservedWords() {
        constexpr std::string_view kSpace = " \n";
        for (std::string_view list : kLists) {
            while (!list.empty()) {
                const std::size_t begin = std::min(list.find_first_not_of(kSpace), list.size());
                const std::size_t end = std::min(list.find_first_of(kSpace, begin), list.size());
                if (begin < end) add(list.substr(begin, end - begin));
                list.remove_prefix(end);
            }
        }
    }

    bool contains(std::string_view word) const {
        if (word.empty() || (lengths_[first(word)] & bit(word)) == 0) return false;
        return words_.contains(word);
    }

private:
    static unsigned char first(std::string_view word) { return static_cast<unsigned char>(word[0]); }
    static std::uint32_t bit(std::string_view word) { return 1u << std::min<std::size_t>(word.size(), 31); }

    void add(std::string_view word) {
        words_.insert(word);
        lengths_[first(word)] |= bit(word);
    }

    std::unordered_set<std::string_view> words_;
    // The lengths of the words, by first letter. This excludes most identifiers without a look at the words.
    std::array<std::uint32_t, 256> lengths_{};
};

}  // namespace

bool is_reserved_word(std::string_view word) {
    static const ReservedWords words;
    return words.contains(word) || is_vector_or_matrix(word);
}

}  // namespace patina::languages
