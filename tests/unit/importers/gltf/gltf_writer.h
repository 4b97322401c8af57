// Small glTF files that tests write: a square of two metres around the origin that faces +z, as JSON with all bytes
// inside, and pictures of some texels.
//
//   const std::string path = save_gltf({.materials = R"([{"name":"Paint"}])"});
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "runtime/picture/image.h"

namespace patina::importers {

inline std::string base64(std::string_view bytes) {
    constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kLetters[(three >> (18 - 6 * k)) & 63];
    }
    return text;
}

inline std::string bytes_of(const std::vector<float>& numbers) {
    std::string bytes(numbers.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

// Rows from the top, each texel as its four bytes.
inline std::string png_of(int width, int height, const std::vector<int>& bytes) {
    runtime::Image image = runtime::make_image(width, height);
    image.bits = 8;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<float>(bytes[i]) / 255;
    return runtime::encode_png_as_is(image).value;
}
inline std::string picture_of(const std::string& bytes, const std::string& more = "") {
    return R"({"uri":"data:image/png;base64,)" + base64(bytes) + "\"" + more + "}";
}

inline std::string new_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "patina_gltf_XXXXXX").string();
    return mkdtemp(name.data());
}

struct Square {
    std::string materials = "[]";
    std::string nodes = R"([{"name":"square","mesh":0}])";
    std::string meshes{};     // empty: one, with the first material if there is one
    std::string textures{};   // with "images" and "samplers": R"("textures":[...],"images":[...])"
    std::string more{};       // other members of the file
    bool has_bytes = false;   // accessor 6: four positions of whole numbers of one byte
    bool has_colors = false;  // of the default mesh: the left side is black, the right side red
    std::string name = "square.gltf";
};

// In a folder of its own. Attributes: POSITION 0, NORMAL 1, TEXCOORD_0 2 (u to the right, v down), TEXCOORD_1 3 (the
// same, turned by half a turn), COLOR_0 4.
inline std::string save_gltf(const Square& square) {
    const std::string bytes =
        bytes_of({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}) + bytes_of({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}) +
        bytes_of({0, 1, 1, 1, 1, 0, 0, 0}) + bytes_of({1, 0, 0, 0, 0, 1, 1, 1}) +
        bytes_of({0, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1}) + std::string("\0\1\2\0\2\3", 6);
    const auto view = [](int offset, int length) {
        return R"({"buffer":0,"byteOffset":)" + std::to_string(offset) + ",\"byteLength\":" + std::to_string(length) +
               "}";
    };
    const auto accessor = [](int number, const char* type, int count, int component = 5126) {
        return R"({"bufferView":)" + std::to_string(number) + ",\"componentType\":" + std::to_string(component) +
               ",\"type\":\"" + type + "\",\"count\":" + std::to_string(count) + "}";
    };
    std::string meshes = square.meshes;
    if (meshes.empty()) {
        meshes = R"([{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"TEXCOORD_1":3)";
        meshes += std::string(square.has_colors ? R"(,"COLOR_0":4)" : "") + R"(},"indices":5)";
        meshes += std::string(square.materials == "[]" ? "" : R"(,"material":0)") + "}]}]";
    }
    const std::string text =
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"buffers":[{"byteLength":)" +
        std::to_string(bytes.size()) + R"(,"uri":"data:application/octet-stream;base64,)" + base64(bytes) +
        R"("}],"bufferViews":[)" + view(0, 48) + "," + view(48, 48) + "," + view(96, 32) + "," + view(128, 32) + "," +
        view(160, 64) + "," + view(224, 6) + R"(],"accessors":[)" + accessor(0, "VEC3", 4) + "," +
        accessor(1, "VEC3", 4) + "," + accessor(2, "VEC2", 4) + "," + accessor(3, "VEC2", 4) + "," +
        accessor(4, "VEC4", 4) + "," + accessor(5, "SCALAR", 6, 5121) +
        (square.has_bytes ? R"(,{"bufferView":0,"componentType":5120,"type":"VEC3","count":4})" : "") +
        R"(],"nodes":)" + square.nodes + ",\"meshes\":" + meshes +
        (square.materials == "[]" ? "" : ",\"materials\":" + square.materials) +
        (square.textures.empty() ? "" : "," + square.textures) + (square.more.empty() ? "" : "," + square.more) + "}";
    const std::filesystem::path path = std::filesystem::path(new_folder()) / square.name;
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
}

}  // namespace patina::importers
