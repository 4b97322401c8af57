// The normal of a material, given in each of the three spaces, on both sides of a sheet that is turned and stretched:
// lighting must read the normal in its own space. The picture shows that normal.
#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "paths/drawing/drawing.h"

namespace patina::paths {
namespace {

// Of a unit normal in its space: as the plane's mesh has it, which lies in x and y, with u along +x and v against +y.
const glm::dvec3 kGiven(0.48, 0.6, 0.64);

std::string graph(const std::string& input, const std::string& cull) {
    return written(fmt::format("{}_{}.graph.json", input, cull),
                   fmt::format(R"({{ "patina": 1, "workflow": "metallic-roughness",
  "lighting": {{ "direct": [0, 0, 0], "final": "@surface.normalWS" }},
  "surface": {{ "{}": [0.48, 0.6, 0.64] }}, "render": {{ "cull": "{}" }} }})",
                               input, cull));
}

struct Case {
    const char* what;
    glm::dmat4 object_to_world;
};
const glm::dmat4 kTurned = glm::rotate(glm::dmat4(1), 0.5, glm::normalize(glm::dvec3(1, 2, 0.5)));
const Case kCases[] = {
    {"as it is", glm::dmat4(1)}, {"turned", kTurned}, {"stretched", glm::scale(kTurned, glm::dvec3(2, 0.5, 3))}};

// The normal in the world, of the side that the mesh's own normal points out of.
glm::dvec3 in_world(const std::string& input, const glm::dmat4& object_to_world) {
    const glm::dmat3 linear(object_to_world);
    const auto of_normal = [&](const glm::dvec3& n) {
        return glm::normalize(glm::transpose(glm::inverse(linear)) * n);
    };
    if (input == "normalWS") return kGiven;
    if (input == "normalOS") return of_normal(kGiven);
    const glm::dvec3 along_u = glm::normalize(linear * glm::dvec3(1, 0, 0)), normal = of_normal({0, 0, 1});
    // In the plane, square to u, on the side that is up in the picture.
    glm::dvec3 up = glm::cross(normal, along_u);
    if (glm::dot(up, linear * glm::dvec3(0, 1, 0)) < 0) up = -up;
    return glm::normalize(kGiven.x * along_u + kGiven.y * up + kGiven.z * normal);
}

TEST(NormalInputs, AreReadInTheirSpaceOnBothSides) {
    for (const Case& each : kCases) {
        const glm::dvec3 out = in_world("normalTS", each.object_to_world);
        for (const char* input : {"normalTS", "normalOS", "normalWS"}) {
            for (const double side : {1.0, -1.0}) {
                for (const char* via : {"glsl", "hlsl", "cpu"}) {
                    SCOPED_TRACE(
                        fmt::format("{}, {} from {}, {}", input, each.what, side > 0 ? "the front" : "behind", via));
                    World world;
                    world.view.width = world.view.height = 4;
                    world.view.camera = {.position = glm::vec3(4 * side * out), .target = {0, 0, 0}, .fov = 2};
                    add_object(world, graph(input, "off"), "plane", 1, glm::mat4(each.object_to_world));
                    const Image image = draw(world, {.via = via, .exact_targets = true});
                    // A normal of the world is taken as it is; the others are the sheet's, which shows its other side.
                    const bool is_turned = side < 0 && input != std::string("normalWS");
                    const glm::dvec3 expected = in_world(input, each.object_to_world) * (is_turned ? -1.0 : 1.0);
                    for (int c = 0; c < 3; ++c)
                        EXPECT_NEAR(double(image.at(2, 2)[std::size_t(c)]), expected[c], 1e-5) << "channel " << c;
                }
            }
        }
    }
}

// Seen from one side alone, nothing is turned.
TEST(NormalInputs, AreNotTurnedWhereOneSideIsSeen) {
    for (const char* input : {"normalTS", "normalOS"}) {
        World world;
        world.view.width = world.view.height = 4;
        world.view.camera = {.position = {0, 0, 4}, .target = {0, 0, 0}, .fov = 2};
        add_object(world, graph(input, "back"), "plane", 1, glm::mat4(1));
        const Image image = draw(world, {.exact_targets = true});
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(double(image.at(2, 2)[std::size_t(c)]), kGiven[c], 1e-5) << input;
    }
}

// Without inputs, the node TangentFrame is the mesh's own frame; from behind, the whole frame is turned, as in glTF.
TEST(TangentFrame, IsTheMeshsOwnOnBothSides) {
    for (const Case& each : kCases) {
        const glm::dmat3 linear(each.object_to_world);
        const glm::dvec3 along_u = glm::normalize(linear * glm::dvec3(1, 0, 0));
        const glm::dvec3 normal = glm::normalize(glm::transpose(glm::inverse(linear)) * glm::dvec3(0, 0, 1));
        // The plane's v grows downwards, and its frame is right-handed.
        const std::pair<const char*, glm::dvec3> kOutputs[] = {
            {"out", along_u}, {"bitangent", glm::cross(normal, along_u)}, {"unitNormal", normal}};
        for (const auto& [output, in_front] : kOutputs) {
            const std::string file = written(fmt::format("frame_{}.graph.json", output), fmt::format(R"({{ "patina": 1,
  "workflow": "metallic-roughness", "nodes": [{{ "id": "frame", "node": "TangentFrame" }}],
  "surface": {{ "emission": "frame.{}" }},
  "lighting": {{ "direct": [0, 0, 0], "final": "@surface.emission" }}, "render": {{ "cull": "off" }} }})",
                                                                                                     output));
            for (const double side : {1.0, -1.0}) {
                SCOPED_TRACE(fmt::format("{}, {}, {}", output, each.what, side > 0 ? "the front" : "behind"));
                World world;
                world.view.width = world.view.height = 4;
                world.view.camera = {.position = glm::vec3(4 * side * normal), .target = {0, 0, 0}, .fov = 2};
                add_object(world, file, "plane", 1, glm::mat4(each.object_to_world));
                const Image image = draw(world, {.exact_targets = true});
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(double(image.at(2, 2)[std::size_t(c)]), side * in_front[c], 1e-5) << "channel " << c;
            }
        }
    }
}

// --- a mesh without normals or tangents

std::shared_ptr<const runtime::Mesh> bare(bool has_normals) {
    runtime::Mesh mesh = *runtime::make_mesh("plane", 2);
    for (runtime::Vertex& vertex : mesh.vertices) {
        vertex.tangent = glm::vec4(0);
        if (!has_normals) vertex.normal = glm::vec3(0);
    }
    return std::make_shared<const runtime::Mesh>(std::move(mesh));
}

World bare_world(const std::string& graph, bool has_normals) {
    World world;
    world.view.width = world.view.height = 8;
    world.view.camera = {.position = {0, 0, 4}, .target = {0, 0, 0}, .fov = 20};
    world.view.lights.push_back({.kind = LightKind::Directional, .direction = glm::normalize(glm::vec3(1, 1, 2))});
    add_object(world, graph, "plane", 2, glm::mat4(kTurned));
    world.objects.back().mesh = bare(has_normals);
    return world;
}

glm::dvec3 shown(const std::string& value, bool has_normals, const char* via) {
    const std::string graph =
        written(value + "_of_bare_mesh.graph.json", fmt::format(R"({{ "patina": 1, "workflow": "metallic-roughness",
  "lighting": {{ "direct": [0, 0, 0], "final": "@{}" }}, "surface": {{ "baseColor": 1 }} }})",
                                                                value));
    const Image image = draw(bare_world(graph, has_normals), {.via = via, .exact_targets = true});
    const auto pixel = image.at(4, 4);
    return {pixel[0], pixel[1], pixel[2]};
}

TEST(NormalInputs, OfAMeshThatLacksThemAreAFrame) {
    for (const bool has_normals : {false, true}) {
        for (const char* via : {"glsl", "hlsl", "cpu"}) {
            SCOPED_TRACE(fmt::format("{} normals, {}", has_normals ? "with" : "without", via));
            const glm::dvec3 normal = shown("geometryNormalWS", has_normals, via);
            const glm::dvec3 tangent = shown("tangentWS", has_normals, via);
            const glm::dvec3 bitangent = shown("bitangentWS", has_normals, via);
            const glm::dvec3 expected =
                has_normals ? glm::dvec3(kTurned * glm::dvec4(0, 0, 1, 0)) : glm::dvec3(0, 1, 0);
            EXPECT_LE(glm::length(normal - expected), 1e-5);
            EXPECT_NEAR(glm::length(tangent), 1, 1e-5);
            EXPECT_NEAR(glm::dot(tangent, normal), 0, 1e-5);
            EXPECT_LE(glm::length(bitangent - glm::cross(normal, tangent)), 1e-5);
        }
    }
}

// Of materials that read the frame for normal maps and for stretched highlights.
TEST(NormalInputs, OfAMeshThatLacksThemMakeNumbersOfEveryPixel) {
    for (const char* graph : {"examples/graphs/rusted_steel.graph.json", "examples/graphs/azulejo.graph.json"}) {
        for (const bool has_normals : {false, true}) {
            for (const char* path : {"forward", "deferred", "forward-add"}) {
                for (const char* via : {"glsl", "hlsl", "cpu"}) {
                    SCOPED_TRACE(fmt::format("{} along {} via {}", graph, path, via));
                    const Image image =
                        draw(bare_world(graph, has_normals), {.path = path, .via = via, .exact_targets = true});
                    for (int y = 0; y < image.height; ++y) {
                        for (int x = 0; x < image.width; ++x) {
                            const auto pixel = image.at(x, y);
                            for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(pixel[c])) << x << ", " << y;
                        }
                    }
                    EXPECT_GT(lit_pixels(image), 8);
                }
            }
        }
    }
}

}  // namespace
}  // namespace patina::paths
