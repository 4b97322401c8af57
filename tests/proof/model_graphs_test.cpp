// No lighting model is one node: each that is made of microfacets has at least a distribution, a visibility, a Fresnel
// and a diffuse node, and exchanging any of them for another of its family changes what is seen.
#include <gtest/gtest.h>
#include <rapidjson/document.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <fstream>
#include <set>

#include "compiler/nodelang/embedded.h"
#include "proof/term.h"
#include "runtime/lighting/model.h"

namespace patina::proof {
namespace {

using nodelang::FunctionDecl;
using runtime::Triple;

constexpr const char* kMicrofacet[] = {"cl-pbr-specular",     "cook-torrance", "disney-principled",
                                       "energy-conserving",   "gltf",          "openpbr",
                                       "pbr-direct-indirect", "unity-brdf1",   "unity-brdf2"};
constexpr const char* kFamilies[] = {"Distribution", "Visibility", "Fresnel", "Diffuse"};

const Compiler& compiler() {
    static const Compiler made;
    return made;
}

// "Distribution" of a node listed as "Lighting/Distribution/GGX"; empty for what is not lighting.
std::string_view family_of(std::string_view node) {
    const FunctionDecl* function = library().declarations.function(node);
    if (!function || !function->attribute("node")) return {};
    std::string_view path = nodelang::attribute_text(*function->attribute("node"));
    if (!path.starts_with("Lighting/")) return {};
    path.remove_prefix(9);
    return path.substr(0, path.find('/'));
}

const format::Graph& graph_of(const std::string& model) {
    return *library().lighting_models.find(model)->second.get();
}

std::string text_of(const std::string& model) {
    for (const nodelang::EmbeddedFile& file : nodelang::embedded_files()) {
        if (file.path.ends_with("/" + model + ".lighting.json")) return std::string(file.text);
    }
    return {};
}

// The model with one node exchanged. Inputs that the other does not know are left out, and one that it needs besides is
// read from the node of that name. Empty if there is none.
std::string exchanged(const std::string& model, const std::string& id, const FunctionDecl& other) {
    rapidjson::Document document;
    document.Parse<rapidjson::kParseCommentsFlag>(text_of(model).c_str());
    auto& memory = document.GetAllocator();
    const auto word = [&](std::string_view text) {
        return rapidjson::Value(text.data(), static_cast<rapidjson::SizeType>(text.size()), memory);
    };
    std::set<std::string_view> ids;
    for (const format::Node& node : graph_of(model).nodes) ids.insert(node.id);
    for (rapidjson::Value& node : document["nodes"].GetArray()) {
        if (node["id"].GetString() != id) continue;
        node["node"] = word(other.name);
        rapidjson::Value in(rapidjson::kObjectType);
        for (const nodelang::ParamDecl& param : other.params) {
            const std::string name(param.name);
            if (param.is_out) continue;
            if (node.HasMember("in") && node["in"].HasMember(name.c_str())) {
                in.AddMember(word(name), node["in"][name.c_str()], memory);
            } else if (!param.initial) {
                if (!ids.contains(name)) return {};
                in.AddMember(word(name), word(name), memory);
            }
        }
        node.RemoveMember("in");
        node.AddMember("in", in, memory);
    }
    rapidjson::StringBuffer buffer;
    rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
    document.Accept(writer);
    return buffer.GetString();
}

using Words = std::vector<std::pair<std::string, std::string>>;

bool is_given_by_a_workflow(const std::string& input) {
    return std::any_of(library().workflows.begin(), library().workflows.end(), [&](const auto& workflow) {
        const std::vector<format::PortValue>& given = workflow.second.get()->surface;
        return std::any_of(given.begin(), given.end(), [&](const auto& port) { return port.name == input; });
    });
}

// Everything a model has to choose from, one choice at a time, and all that it declares of the surface away from zero,
// but for what another workflow gives.
std::vector<Words> settings_of(const format::Graph& graph) {
    Words surface = {{"baseColor", "0.8,0.5,0.3"}, {"metallic", "0.3"}, {"roughness", "0.6"}};
    for (const format::Input& input : graph.inputs)
        if (!is_given_by_a_workflow(input.name))
            surface.push_back({input.name, input.type == "color3" ? "0.6,0.7,0.8" : "0.6"});
    // And with none of that: what is chosen instead of it.
    std::vector<Words> settings = {surface, Words(surface.begin(), surface.begin() + 3)};
    for (const format::Property& property : graph.properties) {
        for (const std::string& word : property.values) {
            settings.push_back(surface);
            settings.back().push_back({property.name, word});
        }
    }
    return settings;
}

// Lamps and surroundings at a few points.
std::vector<Triple> seen(const std::string& model, const Words& values) {
    runtime::Model made(compiler(), {.model = model, .values = values});
    EXPECT_TRUE(made.ok()) << model << (made.ok() ? "" : to_text(made.diagnostics().at(0)));
    if (!made.ok()) return {};
    std::vector<Triple> colors;
    for (const double x : {-0.6, 0.1, 0.7}) {
        for (const double z : {-0.6, 0.1, 0.5, 1.0}) {
            const runtime::ModelPoint point{.l = {x, 0.3, z}, .v = {0.4, -0.2, 0.6}};
            colors.push_back(made.direct(point));
            colors.push_back(made.color(point, {.light = {}, .ambient = {1, 1, 1}, .environment = {1, 1, 1}}));
        }
    }
    return colors;
}

double difference(const std::vector<Triple>& a, const std::vector<Triple>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a[i][c] - b[i][c]));
    }
    return largest;
}

class MicrofacetModel : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, MicrofacetModel, testing::ValuesIn(kMicrofacet), [](const auto& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST_P(MicrofacetModel, HasANodeOfEachFamily) {
    std::map<std::string_view, int> count;
    for (const format::Node& node : graph_of(GetParam()).nodes) count[family_of(node.type)] += 1;
    std::printf("%-24s", GetParam());
    for (const char* family : kFamilies) {
        std::printf(" %s %d", family, count[family]);
        EXPECT_GE(count[family], 1) << family;
    }
    std::printf("\n");
}

TEST_P(MicrofacetModel, ChangesWithEachOfThem) {
    const format::Graph& graph = graph_of(GetParam());
    const std::vector<Words> settings = settings_of(graph);
    std::vector<std::vector<Triple>> original;
    for (const Words& values : settings) original.push_back(seen(GetParam(), values));
    for (const format::Node& node : graph.nodes) {
        const std::string_view family = family_of(node.type);
        if (std::find(std::begin(kFamilies), std::end(kFamilies), family) == std::end(kFamilies)) continue;
        const FunctionDecl* own = library().declarations.function(node.type);
        double most = 0;
        for (const FunctionDecl* each : resolve::all_functions(library())) {
            const FunctionDecl& other = *each;
            // Of the same type, as the rest of the graph reads it.
            if (other.name == node.type || family_of(other.name) != family || other.result.name != own->result.name)
                continue;
            const std::string text = exchanged(GetParam(), node.id, other);
            if (text.empty()) continue;
            const std::string path = testing::TempDir() + GetParam() + "-exchanged.lighting.json";
            std::ofstream(path) << text;
            for (std::size_t i = 0; i < settings.size() && most <= 0.01; ++i)
                most = std::max(most, difference(original[i], seen(path, settings[i])));
            if (most > 0.01) break;
        }
        EXPECT_GT(most, 0.01) << node.id;
    }
}

TEST(Models, MicrofacetModelsAreAllListed) {
    for (const auto& [name, unread] : library().lighting_models) {
        const std::vector<format::Node>& nodes = graph_of(name).nodes;
        const bool has_visibility = std::any_of(
            nodes.begin(), nodes.end(), [](const format::Node& node) { return family_of(node.type) == "Visibility"; });
        const bool is_listed = std::find(std::begin(kMicrofacet), std::end(kMicrofacet), name) != std::end(kMicrofacet);
        // The plain highlight of Blinn and Phong has a visibility of one fourth and no Fresnel.
        EXPECT_EQ(has_visibility && name != "blinn-phong", is_listed) << name;
    }
}

}  // namespace
}  // namespace patina::proof
