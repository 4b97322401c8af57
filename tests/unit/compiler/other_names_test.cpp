// Advice for names of other languages: what it names exists, and people's names lead to what they mean.
#include "compiler/nodelang/other_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "compiler/base/text.h"
#include "compiler/emit/operations/operations.h"
#include "compiler/nodelang/embedded.h"
#include "compiler/nodelang/parse.h"
#include "compiler/resolve/library.h"
#include "compiler/writers/writers.h"

namespace patina::nodelang {
namespace {

const resolve::Library& library() {
    static const auto kLibrary = resolve::load_library(embedded_files(), writers::printable());
    return *kLibrary;
}

bool is_function(std::string_view name) {
    const std::vector<std::string_view> own = emit::intrinsic_names();
    return library().declarations.function(name) || std::find(own.begin(), own.end(), name) != own.end();
}

bool is_type(std::string_view name) {
    return name.starts_with("float") || name.starts_with("int") || name.starts_with("uint") ||
           name.starts_with("bool") || name.starts_with("half") || name.starts_with("Texture");
}

// A name that the advice leaves to the reader: a, b, ...
bool is_placeholder(std::string_view name) {
    constexpr std::array<std::string_view, 5> kWords = {"left", "right", "top", "bottom", "center"};
    return name.size() == 1 || std::find(kWords.begin(), kWords.end(), name) != kWords.end();
}

void expect_known(const Expr& expr, std::string_view other) {
    const std::string text(expr.text);
    if (expr.kind == Expr::Kind::Call) {
        EXPECT_TRUE(is_function(text) || is_type(text)) << other << ": " << text;
    }
    if (expr.kind == Expr::Kind::Semantic) {
        EXPECT_TRUE(library().paths.semantic(text)) << other << ": @" << text;
    }
    if (expr.kind == Expr::Kind::Name) {
        EXPECT_TRUE(is_placeholder(text) || is_function(text) || is_type(text) || library().declarations.variable(text))
            << other << ": " << text;
    }
    for (const Expr* arg : expr.args) expect_known(*arg, other);
}

bool is_blend_mode(std::string_view name) {
    return name == "Screen" || name == "Overlay" || name == "Burn" || name == "Dodge";
}

// The words between quotation marks that can be names.
std::vector<std::string_view> quoted_names(std::string_view remark) {
    std::vector<std::string_view> names;
    for (std::size_t open = remark.find('\''); open != remark.npos;) {
        const std::size_t close = remark.find('\'', open + 1);
        if (close == remark.npos) break;
        names.push_back(remark.substr(open + 1, close - open - 1));
        open = remark.find('\'', close + 1);
    }
    return names;
}

TEST(OtherNames, NameWhatExists) {
    ASSERT_GT(other_names().size(), 100u);
    for (const OtherName& row : other_names()) {
        Ast ast;
        Diagnostics diagnostics;
        for (const std::string_view own : patina::split(row.own, " and ")) {
            if (own.empty()) continue;
            const Expr* expr = parse_expression({.text = own}, ast, diagnostics);
            ASSERT_TRUE(expr) << row.other << ": " << own;
            expect_known(*expr, row.other);
        }
        for (const std::string_view name : quoted_names(row.remark)) {
            if (name.starts_with('@')) {
                EXPECT_TRUE(library().paths.semantic(name.substr(1))) << row.other << ": " << name;
            } else if (std::isupper(static_cast<unsigned char>(name[0])) != 0 && !is_blend_mode(name)) {
                EXPECT_TRUE(library().declarations.function(name)) << row.other << ": " << name;
            }
        }
    }
}

std::string advice_for(std::string_view word) {
    std::vector<std::string_view> known = emit::intrinsic_names();
    for (const std::string_view name : library().declarations.function_names()) known.push_back(name);
    return advice(word, known, library().declarations);
}

TEST(OtherNames, LeadToWhatTheyMean) {
    const std::pair<std::string_view, std::string_view> kMeant[] = {
        // Unity: SmoothnessToRoughness gives (1 - smoothness)^2.
        {"SmoothnessToRoughness", "'AlphaFromSmoothness'"},
        {"SmoothnessToPerceptualRoughness", "'RoughnessFromSmoothness'"},
        {"PerceptualRoughnessToRoughness", "'AlphaFromRoughness'"},
        {"RoughnessToPerceptualRoughness", "'RoughnessFromAlpha'"},
        {"BlendNormals", "'NormalBlend'"},
        {"FresnelTerm", "'FresnelSchlick'"},
        {"GGXTerm", "'DistributionGGXUnity'"},
        {"SmithJointGGXVisibilityTerm", "'VisibilitySmithJointApproximate'"},
        {"LambertTerm", "'NdotL'"},
        {"DotClamped", "'saturate(dot(a, b))'"},
        {"LerpWhiteTo", "'lerp(1, b, t)'"},
        {"LerpOneTo", "'lerp(1, b, t)'"},
        {"UNITY_LIGHT_ATTENUATION", "'@light.attenuation"},
        {"UNITY_SAMPLE_TEX2D", "'SampleTexture2D'"},
        {"UnpackNormalWithScale", "'UnpackNormal'"},
        {"ComputeScreenPos", "'@screenUV'"},
        // MaterialX
        {"screen", "'BlendColors'"},
        {"overlay", "'BlendColors'"},
        {"burn", "'BlendColors'"},
        {"dodge", "'BlendColors'"},
        {"difference", "'abs(a - b)'"},
        {"over", "'a + b * (1 - a.a)'"},
        {"plus", "'a + b'"},
        {"minus", "'b - a'"},
        {"premult", "'float4(c.rgb * c.a, c.a)'"},
        {"splitlr", "'@uv0.x < center ? left : right'"},
        {"heighttonormal", "'NormalFromTexture'"},
        {"triplanarprojection", "'@positionWS'"},
        {"rotate3d", "'RotateAboutAxis'"},
        // Shader Graph
        {"NormalVector", "'Normal'"},
        {"Normal Vector", "'Normal'"},
        {"Blend", "'BlendColors'"},
        {"Reflection", "'Reflect'"},
        // GLSL and HLSL
        {"faceforward", "'dot(i, g) < 0 ? n : -n'"},
        {"modf", "'x - trunc(x)'"},
        {"matrixCompMult", "a[0] * b[0]"},
        {"acosh", "sqrt(x * x - 1)"},
        {"asinh", "sqrt(x * x + 1)"},
        {"atanh", "(1 + x) / (1 - x)"},
        {"dst", "'float4(1, a.y * b.y, a.z, b.w)'"},
        {"if", "'c ? a : b'"},
    };
    for (const auto& [word, meant] : kMeant)
        EXPECT_NE(advice_for(word).find(meant), std::string::npos) << word << ": " << advice_for(word);
}

// Nodes of other programs that are no nodes here, however their names are written.
TEST(OtherNames, OfNodesLeadToWhatStandsForThem) {
    const std::pair<std::string_view, std::string_view> kMeant[] = {{"Matrix Transpose", "transpose(m)"},
                                                                    {"matrix_determinant", "determinant(m)"},
                                                                    {"Boolean", "'true' or 'false'"},
                                                                    {"Sub-graph", "./name.subgraph.json"},
                                                                    {"Sub Graph", "./name.subgraph.json"},
                                                                    {"Custom Function", "./name.node.hlsl"},
                                                                    {"Texture 2D Asset", "'texture2d'"},
                                                                    {"Keyword", "\"as\": \"variant\""},
                                                                    {"Sampler State", "\"nearestClamp\""},
                                                                    {"Sample Virtual Texture", "virtual texture"},
                                                                    {"Integer", "'Constant'"},
                                                                    {"Matrix 4x4", "'MatrixConstruction'"}};
    const std::vector<std::string_view> known = library().declarations.function_names();
    for (const auto& [word, meant] : kMeant) {
        const std::string said = node_advice(word, known, library().declarations);
        EXPECT_NE(said.find(meant), std::string::npos) << word << ": " << said;
    }
}

}  // namespace
}  // namespace patina::nodelang
