// glTF files that the test writes itself, one for each feature, with their values in closed form; and broken ones,
// which are refused with the place of the mistake.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "runtime/gltf/gltf_file.h"
#include "runtime/gltf/gltf_model.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

std::string base64(const std::vector<unsigned char>& bytes) {
    constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = std::uint32_t{bytes[i]} << 16;
        if (i + 1 < bytes.size()) three |= std::uint32_t{bytes[i + 1]} << 8;
        if (i + 2 < bytes.size()) three |= bytes[i + 2];
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kLetters[(three >> (18 - 6 * k)) & 63];
    }
    return text;
}

// A file in the making: accessors over one buffer, each in a view of its own.
class File {
public:
    template <class T>
    int add(const std::vector<T>& numbers, int component_type, const std::string& type, std::size_t width,
            const std::string& more = "") {
        while (bytes_.size() % 4 != 0) bytes_.push_back(0);
        const std::size_t offset = bytes_.size();
        bytes_.resize(offset + numbers.size() * sizeof(T));
        std::memcpy(bytes_.data() + offset, numbers.data(), numbers.size() * sizeof(T));
        views_ += (count_ ? "," : "") + std::string("{\"buffer\":0,\"byteOffset\":") + std::to_string(offset) +
                  ",\"byteLength\":" + std::to_string(numbers.size() * sizeof(T)) + "}";
        accessors_ += (count_ ? "," : "") + std::string("{\"bufferView\":") + std::to_string(count_) +
                      ",\"componentType\":" + std::to_string(component_type) + ",\"type\":\"" + type +
                      "\",\"count\":" + std::to_string(numbers.size() / width) + more + "}";
        return count_++;
    }
    int floats(const std::vector<float>& numbers, const std::string& type, std::size_t width) {
        return add(numbers, 5126, type, width);
    }
    int points(const std::vector<float>& numbers) { return floats(numbers, "VEC3", 3); }

    // `rest`: meshes, nodes and all else.
    std::string save(const std::string& rest) const { return save_with("", rest); }
    // `last`: one more accessor.
    std::string save_with(const std::string& last, const std::string& rest) const {
        return save_text(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" + std::to_string(bytes_.size()) +
                         R"(,"uri":"data:application/octet-stream;base64,)" + base64(bytes_) +
                         R"("}],"bufferViews":[)" + views_ + R"(],"accessors":[)" + accessors_ +
                         (last.empty() ? "" : ",") + last + "]," + rest + "}");
    }
    static std::string save_text(const std::string& text) {
        static int number = 0;
        const fs::path path = fs::path(testing::TempDir()) / ("gltf_test_" + std::to_string(number++) + ".gltf");
        std::ofstream(path, std::ios::binary) << text;
        return path.string();
    }

private:
    std::vector<unsigned char> bytes_;
    std::string views_, accessors_;
    int count_ = 0;
};

const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};

std::string at(const std::string& name, int accessor) {
    return "\"" + name + "\":" + std::to_string(accessor);
}
std::string mesh(const std::string& attributes, const std::string& more = "") {
    return R"("meshes":[{"primitives":[{"attributes":{)" + attributes + "}" + more + "}]}]";
}

Mesh read(const std::string& path, const std::string& node = "") {
    Outcome<Mesh> made = read_mesh(path, node);
    EXPECT_TRUE(made) << made.error;
    return made.value;
}

// Where the vertices of the first part are, read without the rest.
std::vector<Vertex> places(const std::string& path) {
    const Outcome<tinygltf::Model> file = open_gltf(path);
    EXPECT_TRUE(file) << file.error;
    const Outcome<GltfModel> model = model_of(file.value, MeshDetail::Places);
    EXPECT_TRUE(model) << model.error;
    EXPECT_TRUE(model.value.parts.at(0).mesh->indices.empty());
    return model.value.parts.at(0).mesh->vertices;
}

void expect_near(const glm::vec3& a, const glm::vec3& b) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-6) << i;
}

TEST(Gltf, TrianglesWithoutNormalsAreFlat) {
    File file;
    const int positions = file.points({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    const int indices = file.add<std::uint8_t>({0, 1, 2, 0, 3, 1}, 5121, "SCALAR", 1);
    const Mesh made =
        read(file.save(mesh(at("POSITION", positions), "," + at("indices", indices)) + R"(,"nodes":[{"mesh":0}])"));
    ASSERT_EQ(made.indices.size(), 6u);
    for (std::size_t i = 0; i < 3; ++i) expect_near(made.vertices[made.indices[i]].normal, {0, 0, 1});
    for (std::size_t i = 3; i < 6; ++i) expect_near(made.vertices[made.indices[i]].normal, {0, 1, 0});
    for (const Vertex& v : made.vertices) EXPECT_NEAR(glm::length(glm::vec3(v.tangent)), 1, 1e-6);
}

// A strip and a fan of the same square: each triangle faces +z.
TEST(Gltf, StripsAndFansAreTriangles) {
    const std::vector<float> square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0},
                             around = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    for (const bool is_strip : {true, false}) {
        File file;
        const int positions = file.points(is_strip ? square : around);
        const Mesh made = read(file.save(mesh(at("POSITION", positions), is_strip ? ",\"mode\":5" : ",\"mode\":6") +
                                         R"(,"nodes":[{"mesh":0}])"));
        ASSERT_EQ(made.indices.size(), 6u);
        for (const Vertex& v : made.vertices) expect_near(v.normal, {0, 0, 1});
    }
}

TEST(Gltf, NumbersAreNormalisedAndSparse) {
    File file;
    const int positions = file.add<std::int16_t>({0, 0, 0, 32767, 0, 0, 0, -32768, 0}, 5122, "VEC3", 3,  // padded below
                                                 ",\"normalized\":true");
    const int colors = file.add<std::uint8_t>({255, 0, 0, 51, 0, 255, 0, 255, 0, 0, 255, 255}, 5121, "VEC4", 4,
                                              ",\"normalized\":true");
    const Mesh made =
        read(file.save(R"("extensionsRequired":["KHR_mesh_quantization"],)" +
                       mesh(at("POSITION", positions) + "," + at("COLOR_0", colors)) + R"(,"nodes":[{"mesh":0}])"));
    ASSERT_EQ(made.indices.size(), 3u);
    expect_near(made.vertices[made.indices[1]].position, {1, 0, 0});
    expect_near(made.vertices[made.indices[2]].position, {0, -1, 0});  // never below -1
    EXPECT_NEAR(made.vertices[made.indices[0]].color.a, 0.2, 1e-6);

    File sparse;
    sparse.points(kTriangle);
    sparse.add<std::uint8_t>({2}, 5121, "SCALAR", 1);
    sparse.points({5, 6, 7});
    std::string text;
    std::getline(std::ifstream(sparse.save(mesh(at("POSITION", 0)) + R"(,"nodes":[{"mesh":0}])")), text, '\0');
    const std::string count = R"("type":"VEC3","count":3)";
    text.replace(text.find(count), count.size(), count + R"(,"sparse":{"count":1,
        "indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":2}})");
    const Mesh moved = read(File::save_text(text));
    expect_near(moved.vertices[moved.indices[2]].position, {5, 6, 7});
    expect_near(moved.vertices[moved.indices[1]].position, {1, 0, 0});
}

// A quarter turn about z, twice the size, and one along x; below it a mirrored child.
TEST(Gltf, NodesPlaceWhatIsBelowThem) {
    File file;
    const int positions = file.points(kTriangle);
    const std::string path = file.save(mesh(at("POSITION", positions)) + R"(,"nodes":[
        {"name":"outer","children":[1],"translation":[1,0,0],"scale":[2,2,2],"rotation":[0,0,0.70710678,0.70710678]},
        {"name":"inner","mesh":0,"matrix":[-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]}, {"name":"empty"}],
        "scenes":[{"nodes":[0]}])");
    const Mesh made = read(path);
    // (1, 0, 0) is mirrored to (-1, 0, 0), turned to (0, -1, 0), doubled and moved.
    std::vector<glm::vec3> corners;
    for (const std::uint32_t index : made.indices) corners.push_back(made.vertices[index].position);
    ASSERT_EQ(corners.size(), 3u);
    for (const glm::vec3& wanted : {glm::vec3(1, 0, 0), glm::vec3(1, -2, 0), glm::vec3(-1, 0, 0)}) {
        EXPECT_TRUE(std::any_of(corners.begin(), corners.end(),
                                [&](const glm::vec3& c) { return glm::length(c - wanted) < 1e-5f; }));
    }
    // A mirrored triangle still has its front where its normal is.
    const glm::vec3 front = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    for (const Vertex& v : made.vertices) EXPECT_GT(glm::dot(front, v.normal), 0);
    EXPECT_EQ(read(path, "inner").indices.size(), 3u);
    EXPECT_EQ(read_mesh(path, "empty").error, path + "#empty has no triangles");
    EXPECT_EQ(read_mesh(path, "inmost").error, path + " has no node 'inmost'; there are: outer, inner, empty");
}

// glTF 2.0, section 3.6.2.3: without a view of its own a sparse accessor starts as zeros. A colour of three numbers is
// opaque.
TEST(Gltf, WhatASparseAccessorDoesNotHaveIsZero) {
    File file;
    const int positions = file.points(kTriangle), which = file.add<std::uint8_t>({1}, 5121, "SCALAR", 1);
    const int values = file.points({0.5f, 0.25f, 1});
    const std::string colors = R"({"componentType":5126,"type":"VEC3","count":3,"sparse":{"count":1,"indices":{)" +
                               at("bufferView", which) + R"(,"componentType":5121},"values":{)" +
                               at("bufferView", values) + "}}}";
    const Mesh made = read(file.save_with(
        colors, mesh(at("POSITION", positions) + "," + at("COLOR_0", values + 1)) + R"(,"nodes":[{"mesh":0}])"));
    ASSERT_EQ(made.vertices.size(), 3u);
    EXPECT_EQ(made.vertices[0].color, glm::vec4(0, 0, 0, 1));
    EXPECT_EQ(made.vertices[1].color, glm::vec4(0.5f, 0.25f, 1, 1));
    EXPECT_EQ(made.vertices[2].color, glm::vec4(0, 0, 0, 1));
}

TEST(Gltf, MorphTargetsHaveTheirWeights) {
    File file;
    const int positions = file.points(kTriangle), moves = file.points({0, 0, 1, 0, 0, 2, 0, 0, 4});
    const std::string whole = R"({"primitives":[{"attributes":{)" + at("POSITION", positions) + R"(},"targets":[{)" +
                              at("POSITION", moves) + R"(}]}],"weights":[0.5]})";
    const std::string path = file.save(R"("meshes":[)" + whole +
                                       R"(],"nodes":[{"mesh":0,"name":"half"},{"mesh":0,"name":"all","weights":[1]}])");
    const Mesh half = read(path, "half"), all = read(path, "all");
    EXPECT_NEAR(half.vertices[half.indices[2]].position.z, 2, 1e-6);
    EXPECT_NEAR(all.vertices[all.indices[2]].position.z, 4, 1e-6);
    expect_near(places(path).at(2).position, {0, 1, 2});
}

// The second joint stands two above the place where the mesh was bound to it. The node of the mesh does not count.
TEST(Gltf, SkinsFollowTheirJoints) {
    File file;
    const int positions = file.points(kTriangle);
    const int joints = file.add<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, 5121, "VEC4", 4);
    const int weights = file.floats({1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0}, "VEC4", 4);
    std::vector<float> matrices(32, 0.0f);
    for (const std::size_t i : {0u, 5u, 10u, 15u}) matrices[i] = matrices[16 + i] = 1;
    matrices[16 + 13] = -1;  // bound at y = 1
    const int inverse = file.floats(matrices, "MAT4", 16);
    const std::string path = file.save(
        mesh(at("POSITION", positions) + "," + at("JOINTS_0", joints) + "," + at("WEIGHTS_0", weights)) +
        R"(,"skins":[{"joints":[1,2],)" + at("inverseBindMatrices", inverse) +
        R"(}],"nodes":[{"mesh":0,"skin":0,"translation":[9,9,9]},{"name":"a"},{"name":"b","translation":[0,3,0]}])");
    const Mesh made = read(path);
    expect_near(made.vertices[made.indices[0]].position, {0, 0, 0});
    expect_near(made.vertices[made.indices[1]].position, {1, 2, 0});
    expect_near(made.vertices[made.indices[2]].position, {0, 2, 0});  // half of the way from 1 to 3
    expect_near(places(path).at(1).position, {1, 2, 0});
}

// Joints can be floats, which are checked before they become an index.
TEST(Gltf, JointsThatAreNoneAreRefused) {
    for (const float wrong : {-1.0f, 1.0f, 1e30f, -1e30f, std::nanf(""), std::numeric_limits<float>::infinity()}) {
        File file;
        const int positions = file.points(kTriangle);
        const int joints = file.floats({0, 0, 0, 0, wrong, 0, 0, 0, 0, 0, 0, 0}, "VEC4", 4);
        const int weights = file.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4);
        const std::string path =
            file.save(mesh(at("POSITION", positions) + "," + at("JOINTS_0", joints) + "," + at("WEIGHTS_0", weights)) +
                      R"(,"skins":[{"joints":[1]}],"extensionsUsed":["KHR_mesh_quantization"],)" +
                      R"("nodes":[{"mesh":0,"skin":0},{"name":"a"}])");
        EXPECT_NE(read_model(path).error.find("and the skin has 1"), std::string::npos) << wrong;
    }
}

TEST(Gltf, HasCamerasAndLights) {
    const std::string path = File::save_text(R"({"asset":{"version":"2.0"},
        "extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","color":[1,0.5,0.25],"intensity":3,"range":4,
            "spot":{"innerConeAngle":0.5,"outerConeAngle":0.75}}]}},
        "cameras":[{"type":"perspective","perspective":{"yfov":1.5707963267948966,"znear":0.1}},
                   {"type":"orthographic","orthographic":{"xmag":1,"ymag":2,"znear":0,"zfar":9}}],
        "nodes":[{"camera":0,"translation":[0,0,5]},{"camera":1},
                 {"name":"lamp","extensions":{"KHR_lights_punctual":{"light":0}}}]})");
    const Outcome<GltfModel> model = read_model(path);
    ASSERT_TRUE(model) << model.error;
    ASSERT_EQ(model.value.cameras.size(), 2u);
    EXPECT_NEAR(model.value.cameras[0].fov, 90, 1e-4);
    EXPECT_EQ(model.value.cameras[0].camera_to_world[3], glm::vec4(0, 0, 5, 1));
    EXPECT_TRUE(model.value.cameras[1].is_orthographic);
    EXPECT_EQ(model.value.cameras[1].height, 4);
    ASSERT_EQ(model.value.lights.size(), 1u);
    EXPECT_EQ(model.value.lights[0].node, "lamp");
    EXPECT_EQ(model.value.lights[0].kind, ModelLight::Kind::Spot);
    EXPECT_EQ(model.value.lights[0].color, glm::vec3(1, 0.5f, 0.25f));
    EXPECT_EQ(model.value.lights[0].range, 4);
    EXPECT_NEAR(model.value.lights[0].outer_angle, 0.75 * 180 / std::acos(-1.0), 1e-4);
}

// "left/1" is a primitive alone, in its own space; what is below the node is not part of it.
TEST(Gltf, APrimitiveOfANodeHasAName) {
    File file;
    file.points(kTriangle);
    file.points({0, 0, 5, 1, 0, 5, 0, 1, 5});
    const std::string path =
        file.save(R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}},{"attributes":{"POSITION":1}}]}],
        "nodes":[{"name":"left","mesh":0,"children":[1],"translation":[7,0,0]},{"name":"a/1","mesh":0},{"mesh":0}])");
    const Outcome<GltfModel> model = read_model(path);
    ASSERT_TRUE(model) << model.error;
    const ModelPart* part = find_part(model.value, "left/1");
    ASSERT_TRUE(part);
    EXPECT_EQ(part->mesh->vertices[0].position, glm::vec3(0, 0, 5));
    EXPECT_EQ(part->object_to_world[3], glm::vec4(7, 0, 0, 1));
    ASSERT_TRUE(find_part(model.value, "node 2/0"));
    EXPECT_EQ(find_part(model.value, "node 2/0")->node_index, 2u);
    EXPECT_FALSE(find_part(model.value, "left/2"));
    EXPECT_FALSE(find_part(model.value, "a/1"));  // the name of a node
    EXPECT_FALSE(find_part(model.value, "left"));
    const Mesh alone = read(path, "left/1");
    ASSERT_EQ(alone.vertices.size(), 3u);
    expect_near(alone.vertices[0].position, {7, 0, 5});
    EXPECT_EQ(read(path, "left").vertices.size(), 12u);
    EXPECT_EQ(read(path, "a/1").vertices.size(), 6u);
}

// A mirrored object turns its triangles round, so that their fronts stay fronts; its normals point where they did.
TEST(Gltf, MirroredNodesTurnTheirTriangles) {
    File file;
    file.points(kTriangle);
    const std::string path = file.save(mesh(at("POSITION", 0)) +
                                       R"(,"nodes":[{"name":"a","mesh":0},{"name":"b","mesh":0,"scale":[-1,1,1]}])");
    const Outcome<GltfModel> model = read_model(path);
    ASSERT_EQ(model.value.parts.size(), 2u);
    for (const ModelPart& part : model.value.parts) {
        const auto corner = [&](std::size_t i) {
            const Vertex& vertex = part.mesh->vertices[part.mesh->indices[i]];
            return glm::vec3(part.object_to_world * glm::vec4(vertex.position, 1));
        };
        EXPECT_GT(glm::cross(corner(1) - corner(0), corner(2) - corner(0)).z, 0) << part.node;
        EXPECT_EQ(part.mesh->vertices[0].normal, glm::vec3(0, 0, 1));
    }
    const Mesh whole = read(path, "b");
    EXPECT_GT(glm::cross(whole.vertices[whole.indices[1]].position - whole.vertices[whole.indices[0]].position,
                         whole.vertices[whole.indices[2]].position - whole.vertices[whole.indices[0]].position)
                  .z,
              0);
}

// --- broken files

struct Broken {
    std::string what, rest, error;  // `error`: a part of the message
};

TEST(Gltf, BrokenFilesAreRefusedAtTheirPlace) {
    const std::string shown = mesh(at("POSITION", 0)) + R"(,"nodes":[{"mesh":0}])";
    const std::vector<Broken> cases = {
        {"an accessor that is not there", mesh(at("POSITION", 7)) + R"(,"nodes":[{"mesh":0}])",
         "meshes[0].primitives[0].attributes.POSITION: names accessors[7], and the file has 2"},
        {"an index past the end", mesh(at("POSITION", 0), R"(,"indices":1)") + R"(,"nodes":[{"mesh":0}])",
         "meshes[0].primitives[0].indices: vertex 9, and there are 3"},
        {"a cycle", shown.substr(0, shown.find(",\"nodes\"")) + R"(,"nodes":[{"children":[1]},{"children":[0]}])",
         "is its own ancestor"},
        {"two parents", R"("nodes":[{"children":[2]},{"children":[2]},{}])", "nodes[2] is also a child of nodes[0]"},
        {"a mesh that is not there", R"("nodes":[{"mesh":3}])", "nodes[0].mesh: names meshes[3], and the file has 0"},
        {"an extension that is not read", shown + R"(,"extensionsRequired":["EXT_other"])",
         "extensionsRequired: 'EXT_other' is not supported"},
        {"no positions", mesh(at("NORMAL", 0)) + R"(,"nodes":[{"mesh":0}])", "has no attribute POSITION"},
        {"a camera without an angle",
         R"("cameras":[{"type":"perspective","perspective":{"yfov":0,"znear":1}}],"nodes":[{"camera":0}])",
         "cameras[0].perspective.yfov: is not between 0 and pi"},
    };
    for (const Broken& each : cases) {
        File file;
        file.points(kTriangle);
        file.add<std::uint16_t>({0, 1, 9}, 5123, "SCALAR", 1);
        const std::string path = file.save(each.rest);
        const Outcome<Mesh> made = read_mesh(path);
        EXPECT_FALSE(made) << each.what;
        EXPECT_NE(made.error.find(each.error), std::string::npos) << each.what << ": " << made.error;
        EXPECT_EQ(made.error.rfind(path, 0), 0u) << made.error;
    }
}

TEST(Gltf, ClaimsAreChecked) {
    const auto with = [](const std::string& accessor, const std::string& view, const std::string& buffer) {
        return File::save_text(R"({"asset":{"version":"2.0"},"buffers":[)" + buffer + R"(],"bufferViews":[)" + view +
                               R"(],"accessors":[)" + accessor + "]," + mesh(at("POSITION", 0)) +
                               R"(,"nodes":[{"mesh":0}]})");
    };
    const std::string buffer = R"({"byteLength":4,"uri":"data:application/octet-stream;base64,AAAAAA=="})";
    const std::string view = R"({"buffer":0,"byteLength":4})";
    const auto error = [](const std::string& path) { return read_mesh(path).error; };
    EXPECT_NE(error(with(R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":4000000000})", view, buffer))
                  .find("accessors[0]: 4000000000 elements from byte 0 on do not fit into bufferViews[0]"),
              std::string::npos);
    EXPECT_NE(error(with(R"({"componentType":5126,"type":"VEC3","count":4000000000})", view, buffer))
                  .find("accessors[0]: it has no bufferView"),
              std::string::npos);
    EXPECT_NE(error(with(R"({"bufferView":0,"componentType":5126,"type":"SCALAR","count":1})",
                         R"({"buffer":0,"byteLength":4000000000})", buffer))
                  .find("bufferViews[0]: 4000000000 bytes from byte 0 on"),
              std::string::npos);
    EXPECT_NE(error(with("{}", view, R"({"byteLength":4,"uri":"nowhere.bin"})")).find("nowhere.bin"),
              std::string::npos);
    EXPECT_NE(error("nowhere.glb").find("there is no file 'nowhere.glb'"), std::string::npos);
    for (const std::string& text : {std::string(), std::string("{"), std::string("glTF"), std::string("[]"),
                                    std::string("glTF\2\0\0\0\xff\xff\xff\x7f\xff\xff\xff\x7fJSON{", 21),
                                    std::string(R"({"asset":{"version":"2.0"},"meshes":7})"),
                                    std::string(R"({"asset":{"version":"2.0"},"nodes":[{"children":["x"]}]})")}) {
        const Outcome<Mesh> made = read_mesh(File::save_text(text));
        EXPECT_FALSE(made) << text;
        EXPECT_FALSE(made.error.empty()) << text;
    }
}

// Sixteen million vertices and a few more: of primitives that share the same numbers, and of nodes that share a mesh.
TEST(Gltf, SharedNumbersCountForEachThatSharesThem) {
    const auto model = [](std::size_t primitives, std::size_t nodes) {
        File file;
        file.add<std::uint8_t>({0}, 5121, "SCALAR", 1);
        file.points({1, 2, 3});
        const std::string zeros = R"({"componentType":5126,"type":"VEC3","count":65535,"sparse":{"count":1,)"
                                  R"("indices":{"bufferView":0,"componentType":5121},"values":{"bufferView":1}}})";
        std::string all, places;
        for (std::size_t i = 0; i < primitives; ++i)
            all += (i > 0 ? "," : "") + std::string(R"({"attributes":{"POSITION":2,"NORMAL":2}})");
        for (std::size_t i = 0; i < nodes; ++i) places += (i > 0 ? "," : "") + std::string(R"({"mesh":0})");
        return file.save_with(zeros, R"("meshes":[{"primitives":[)" + all + R"(]}],"nodes":[)" + places + "]");
    };
    const Outcome<Mesh> few = read_mesh(model(2, 2));
    ASSERT_TRUE(few) << few.error;
    EXPECT_EQ(few.value.vertices.size(), 4u * 65535);
    const Outcome<Mesh> shared = read_mesh(model(257, 1));
    EXPECT_NE(shared.error.find("meshes[0]: with it the model has 16842495 vertices, and the limit is 16777216"),
              std::string::npos)
        << shared.error;
    const std::string path = model(1, 257);
    EXPECT_TRUE(read_model(path));
    EXPECT_NE(read_mesh(path).error.find("as one mesh it has 16842495 vertices"), std::string::npos);
}

// A chain of nodes, of which each is the parent of the next one.
TEST(Gltf, ManyNodesBelowEachOther) {
    std::string nodes;
    for (int i = 0; i < 100000; ++i) nodes += R"({"children":[)" + std::to_string(i + 1) + "]},";
    File file;
    file.points(kTriangle);
    const std::string path = file.save(mesh(at("POSITION", 0)) + R"(,"nodes":[)" + nodes + R"({"mesh":0}])");
    EXPECT_EQ(read(path, "node 1").vertices.size(), 3u);
}

}  // namespace
}  // namespace patina::runtime
