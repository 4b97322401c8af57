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

// Writes the first `columns` components of each element, one element after the other. `to` keeps the components that
// the accessor lacks.
void read_columns(const tinygltf::Model& model, int accessor, std::size_t columns, float* to);

// Elements of N numbers; components that the accessor lacks are `missing`.
template <int N>
std::vector<glm::vec<N, float>> vectors(const tinygltf::Model& model, int accessor, float missing = 0) {
    std::vector<glm::vec<N, float>> made(model.accessors[static_cast<std::size_t>(accessor)].count,
                                         glm::vec<N, float>(missing));
    if (!made.empty()) read_columns(model, accessor, N, &made[0][0]);
    return made;
}

}  // namespace patina::runtime
