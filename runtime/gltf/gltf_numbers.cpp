#include "runtime/gltf/gltf_numbers.h"

#include <algorithm>
#include <cstring>

namespace patina::runtime {
namespace {

// Where the elements of an accessor lie.
struct Bytes {
    const unsigned char* begin = nullptr;  // null: all are zero
    std::size_t stride = 0;
};

const unsigned char* bytes_of(const tinygltf::Model& model, int view_index, std::size_t offset) {
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(view_index)];
    return model.buffers[static_cast<std::size_t>(view.buffer)].data.data() + view.byteOffset + offset;
}

template <class T>
T read(const unsigned char* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

template <class T>
float shared(const unsigned char* at, bool is_normalized) {
    const auto value = static_cast<float>(read<T>(at));
    return is_normalized ? std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0f) : value;
}

float float_at(const unsigned char* at, int component_type, bool is_normalized) {
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE: return shared<std::int8_t>(at, is_normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return shared<std::uint8_t>(at, is_normalized);
        case TINYGLTF_COMPONENT_TYPE_SHORT: return shared<std::int16_t>(at, is_normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return shared<std::uint16_t>(at, is_normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return shared<std::uint32_t>(at, is_normalized);
        default: return read<float>(at);
    }
}

std::uint32_t whole_at(const unsigned char* at, int component_type) {
    if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return *at;
    return component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? read<std::uint16_t>(at) : read<std::uint32_t>(at);
}

std::size_t size_of(int component_type) {
    return static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_type)));
}

// Writes the first of the `width` numbers of each element, `columns` apart. Without bytes they are 0.
template <class Number, class NumberAt>
void read_all(const tinygltf::Model& model, const tinygltf::Accessor& accessor, std::size_t width, std::size_t columns,
              const NumberAt& number_at, Number* to) {
    const std::size_t unit = size_of(accessor.componentType), taken = std::min(width, columns);
    const auto take = [&](std::size_t element, const unsigned char* at) {
        for (std::size_t c = 0; c < taken; ++c)
            to[element * columns + c] = number_at(at + c * unit, accessor.componentType);
    };
    if (accessor.bufferView >= 0) {
        const std::size_t said = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
        const std::size_t stride = said == 0 ? width * unit : said;
        const unsigned char* at = bytes_of(model, accessor.bufferView, accessor.byteOffset);
        for (std::size_t i = 0; i < accessor.count; ++i) take(i, at + i * stride);
    } else {
        for (std::size_t i = 0; i < accessor.count; ++i) std::fill_n(to + i * columns, taken, Number{});
    }
    if (!accessor.sparse.isSparse) return;
    const auto& sparse = accessor.sparse;
    const unsigned char* index =
        bytes_of(model, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset));
    const unsigned char* value =
        bytes_of(model, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset));
    for (std::size_t i = 0; i < static_cast<std::size_t>(sparse.count); ++i) {
        const std::uint32_t element =
            whole_at(index + i * size_of(sparse.indices.componentType), sparse.indices.componentType);
        if (element < accessor.count) take(element, value + i * width * unit);
    }
}

std::size_t width_of(const tinygltf::Accessor& accessor) {
    return static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
}

}  // namespace

void read_columns(const tinygltf::Model& model, int index, std::size_t columns, float* to) {
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    const auto number_at = [&](const unsigned char* at, int type) { return float_at(at, type, accessor.normalized); };
    read_all(model, accessor, width_of(accessor), columns, number_at, to);
}

Numbers numbers_of(const tinygltf::Model& model, int index) {
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    const std::size_t width = width_of(accessor);
    Numbers made{.values = std::vector<float>(accessor.count * width), .width = width};
    read_columns(model, index, width, made.values.data());
    return made;
}

std::vector<std::uint32_t> indices_of(const tinygltf::Model& model, int index) {
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    std::vector<std::uint32_t> made(accessor.count);
    read_all(model, accessor, 1, 1, whole_at, made.data());
    return made;
}

}  // namespace patina::runtime
