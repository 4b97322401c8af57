// The numbers of an accessor, as floats or as indices: strides, normalised integers and sparse values are resolved. The
// file has been checked (gltf_file.h).
//
//   std::vector<glm::vec3> positions = vectors<3>(model, accessor);
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace patina::runtime {

// All components of all elements, one after the other: `width` numbers an element (tightly packed; the padding of small
// matrices is not known here). Normalised integers are 0 to 1, or -1 to 1.
struct Numbers {
    std::vector<float> values;
    std::size_t width = 0;
    std::size_t count() const { return width == 0 ? 0 : values.size() / width; }
};
Numbers numbers_of(const tinygltf::Model& model, int accessor);

// Whole numbers of one component.
std::vector<std::uint32_t> indices_of(const tinygltf::Model& model, int accessor);

// Elements of N numbers; components that the accessor lacks are `missing`.
template <int N>
std::vector<glm::vec<N, float>> vectors(const tinygltf::Model& model, int accessor, float missing = 0) {
    const Numbers numbers = numbers_of(model, accessor);
    std::vector<glm::vec<N, float>> made(numbers.count(), glm::vec<N, float>(missing));
    for (std::size_t i = 0; i < made.size(); ++i) {
        for (std::size_t c = 0; c < std::min<std::size_t>(N, numbers.width); ++c)
            made[i][static_cast<int>(c)] = numbers.values[i * numbers.width + c];
    }
    return made;
}

}  // namespace patina::runtime
