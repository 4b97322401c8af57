// Meshes that Draco has compressed. The test compresses a small mesh with Draco's encoder, without
// quantization. So the reader must give back the same numbers.
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "runtime/gltf/gltf_model.h"

namespace patina::runtime {
namespace {

using Corner = std::array<float, 3>;
constexpr std::array<Corner, 6> kSquare = {Corner{0, 0, 0}, Corner{1, 0, 0}, Corner{1, 1, 0},
                                           Corner{0, 0, 0}, Corner{1, 1, 0}, Corner{0, 1, 0.25f}};

std::string compressed() {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(2);
    const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    for (std::uint32_t face = 0; face < 2; face++)
        builder.SetAttributeValuesForFace(position, draco::FaceIndex(face), kSquare[3 * face].data(),
                                          kSquare[3 * face + 1].data(), kSquare[3 * face + 2].data());
    const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
    draco::Encoder encoder;
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    return {buffer.data(), buffer.size()};
}

// A file whose one primitive has `count` vertices, and the numbers of `bytes` for attributes.
std::string file_of(const std::string& bytes, const std::string& attributes = R"({"POSITION":0})") {
    namespace fs = std::filesystem;
    static int number = 0;
    const std::string name = "draco_" + std::to_string(number++);
    const fs::path folder = testing::TempDir();
    std::ofstream(folder / (name + ".bin"), std::ios::binary) << bytes;
    const std::string path = (folder / (name + ".gltf")).string();
    std::ofstream(path) << R"({"asset":{"version":"2.0"},
  "extensionsUsed":["KHR_draco_mesh_compression"], "extensionsRequired":["KHR_draco_mesh_compression"],
  "buffers":[{"byteLength":)"
                        << bytes.size() << R"(,"uri":")" << name << R"(.bin"}],
  "bufferViews":[{"buffer":0,"byteLength":)"
                        << bytes.size() << R"(}],
  "accessors":[{"componentType":5126,"type":"VEC3","count":4,"min":[0,0,0],"max":[1,1,0.25]},
               {"componentType":5125,"type":"SCALAR","count":6}],
  "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,
    "extensions":{"KHR_draco_mesh_compression":{"bufferView":0,"attributes":)"
                        << attributes << R"(}}}]}],
  "nodes":[{"mesh":0}], "scenes":[{"nodes":[0]}], "scene":0})";
    return path;
}

TEST(GltfDraco, ACompressedMeshIsWhatWasCompressed) {
    const Outcome<GltfModel> model = read_model(file_of(compressed()));
    ASSERT_TRUE(model) << model.error;
    ASSERT_EQ(model.value.parts.size(), 1u);
    const Mesh& mesh = *model.value.parts[0].mesh;
    ASSERT_EQ(mesh.indices.size(), kSquare.size());
    // Draco may begin with another triangle, and with another corner of it.
    const auto triangle = [](std::array<Corner, 3> corners) {
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        return corners;
    };
    std::vector<std::array<Corner, 3>> read, written;
    for (std::size_t i = 0; i < kSquare.size(); i += 3) {
        std::array<Corner, 3> corners{};
        for (std::size_t k = 0; k < 3; k++) {
            const glm::vec3 p = mesh.vertices[mesh.indices[i + k]].position;
            corners[k] = {p.x, p.y, p.z};
        }
        read.push_back(triangle(corners));
        written.push_back(triangle({kSquare[i], kSquare[i + 1], kSquare[i + 2]}));
    }
    std::sort(read.begin(), read.end());
    std::sort(written.begin(), written.end());
    EXPECT_EQ(read, written);
}

TEST(GltfDraco, BrokenBytesAreToldAtTheirPlace) {
    const std::string whole = compressed(), place = "meshes[0].primitives[0].extensions.KHR_draco_mesh_compression: ";
    const auto error = [&](const std::string& path) {
        const Outcome<GltfModel> model = read_model(path);
        EXPECT_FALSE(model);
        EXPECT_NE(model.error.find(place), std::string::npos) << model.error;
        return model.error.substr(std::min(model.error.find(place) + place.size(), model.error.size()));
    };
    EXPECT_EQ(error(file_of("not a mesh at all")), "its bytes are not a Draco mesh");
    EXPECT_NE(error(file_of(whole.substr(0, whole.size() - 8))), "");
    EXPECT_EQ(error(file_of(whole, R"({"POSITION":7})")), "its bytes have no attribute 7, for POSITION");
}

}  // namespace
}  // namespace patina::runtime
