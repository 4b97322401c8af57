#include "runtime/values/material_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "patina/patina.h"
#include "runtime/scene/scene_text.h"
#include "runtime/values/engine_values.h"

namespace patina::runtime {
namespace {

using Numbers = std::array<double, 4>;

template <class Range, class Name>
std::string list(const Range& range, Name name) {
    std::string text;
    for (const auto& item : range) text += (text.empty() ? "" : ", ") + name(item);
    return text.empty() ? "none" : text;
}

// The forms that its value can have.
std::string forms(const Property& property, Spelling spelling) {
    const int count = static_cast<int>(component_count(property.type));
    if (spelling == Spelling::Json) {
        if (property.type == PropertyType::Int) return "a whole number";
        if (property.type == PropertyType::Color) return "\"#rrggbb\", a number or an array of 3 or 4 numbers";
        return count == 1 ? "a number" : fmt::format("a number or an array of {} numbers", count);
    }
    if (property.type == PropertyType::Color) return "#rrggbb, or three or four numbers with commas";
    return count == 1 ? "one number" : std::to_string(count) + " numbers with commas";
}

Outcome<Numbers> parse_vector(const Property& property, const std::string& text, Spelling spelling) {
    int wanted = static_cast<int>(component_count(property.type));
    Failure wrong{property.name + " must be " + forms(property, spelling) + ", not '" + text + "'"};

    if (text.starts_with('#')) {
        if (wanted < 3) return wrong;
        Outcome<glm::vec4> color = parse_hex_color(text);
        if (!color) return Failure{property.name + ": " + color.error};
        return Numbers{color.value.x, color.value.y, color.value.z, color.value.w};
    }
    int count = 0;
    Outcome<glm::vec4> value = parse_numbers(text, count);
    if (!value) return wrong;
    bool is_opaque_color = property.type == PropertyType::Color && count == 3;
    if (count != wanted && count != 1 && !is_opaque_color) return wrong;
    if (count == 1 && wanted > 1) value.value = glm::vec4(value.value.x);  // a scalar splats, as in a graph
    if (property.type == PropertyType::Color && count != 4) value.value.w = 1;
    return Numbers{value.value.x, value.value.y, value.value.z, value.value.w};
}

Outcome<Numbers> parse_value(const Property& property, const std::string& text, Spelling spelling) {
    if (property.type == PropertyType::Bool) {
        if (text == "true") return Numbers{1};
        if (text == "false") return Numbers{0};
        return Failure{property.name + " must be true or false, not '" + text + "'"};
    }
    if (property.type == PropertyType::Enum) {
        auto found = std::find(property.values.begin(), property.values.end(), text);
        if (found != property.values.end()) return Numbers{double(found - property.values.begin())};
        return Failure{property.name + " must be one of " + list(property.values, [](const auto& v) { return v; }) +
                       ", not '" + text + "'"};
    }
    Outcome<Numbers> value = parse_vector(property, text, spelling);
    if (value && property.type == PropertyType::Int && value.value[0] != std::floor(value.value[0]))
        return Failure{property.name + " must be a whole number, not '" + text + "'"};
    return value;
}

// The first number that the property's range leaves out, and that range: "1.5 is outside the range 0 to 1 of '_Wear'".
// Empty: none.
std::string outside_range(const Property& property, const Numbers& value) {
    if (!property.range) return "";
    const auto [lowest, highest] = *property.range;
    // Alpha, which is coverage, has no range.
    for (int i = 0; i < (property.type == PropertyType::Color ? 3 : static_cast<int>(component_count(property.type)));
         i++) {
        // The words were read as floats, and the ends of the range are compared as such.
        if (float(value[i]) >= float(lowest) && float(value[i]) <= float(highest)) continue;
        return fmt::format("{} is outside the {}range {} to {} of '{}'", float(value[i]), property.hard ? "" : "usual ",
                           lowest, highest, property.name);
    }
    return "";
}

std::string first_error(const ReadNumbers& read) {
    for (const Diagnostic& diagnostic : read.diagnostics)
        if (diagnostic.severity == Severity::Error) return diagnostic.message;
    return "it has no value";
}

// "_Turn must be a matrix by rows, like [[1,0],[0,1]], not '1,0,0,1'"
std::string wrong_array(const Property& property, const std::string& text, const ReadNumbers& read) {
    const std::size_t size = property.type == PropertyType::Float2x2   ? 2
                             : property.type == PropertyType::Float3x3 ? 3
                             : property.type == PropertyType::Float4x4 ? 4
                                                                       : 0;
    if (size == 0 || text.starts_with('[')) return property.name + ": " + first_error(read);
    std::string like;
    for (std::size_t row = 0; row < size; row++) {
        like += row > 0 ? ",[" : "[";
        for (std::size_t i = 0; i < size; i++) like += fmt::format("{}{}", i > 0 ? "," : "", row == i ? 1 : 0);
        like += "]";
    }
    return fmt::format("{} must be a matrix by rows, like [{}], not '{}'", property.name, like, text);
}

bool is_number(PropertyType type) {
    return !is_texture(type) && !is_array(type) && type != PropertyType::Sampler;
}

std::string no_sampler(const std::string& property, const std::string& word) {
    std::vector<std::string> names;
    for (const NamedSampler& each : kNamedSamplers) names.emplace_back(each.name);
    return property + " must be a sampler, not '" + word + "'; " + suggestion(word, names);
}

std::string no_property(const Reflection& reflection, const std::string& name) {
    const std::string hint = suggestion(name, property_names(reflection));
    return "the material has no property '" + name + "'" + (hint.empty() ? "" : "; " + hint);
}

// The texture whose tiling this word names ("_MainTex_ST"), or null. Only a texture that was declared with a tiling has
// one.
const Texture* tiled_texture(const Reflection& reflection, const std::string& word) {
    for (const Texture& texture : reflection.textures)
        if (!texture.tiling.empty() && word == texture.name + "_ST") return &texture;
    return nullptr;
}

// How a member is stored: vectors one after the other, `stride` bytes apart, of `rows` 32-bit numbers each.
struct Storage {
    bool is_float = true;
    unsigned rows = 1;
    unsigned columns = 1;  // of a matrix
    unsigned vectors = 1;  // columns of a matrix, times elements of an array
    unsigned stride = 0;
};

Storage storage(const BlockMember& member) {
    const unsigned rows = rows_of(member.type);
    const unsigned columns = is_matrix(member.type) ? rows : 1;
    return {.is_float = is_float(member.type),
            .rows = rows,
            .columns = columns,
            .vectors = columns * std::max(member.array_count, 1u),
            .stride = columns > 1 ? 16 : member.array_stride};  // std140 keeps a column in 16 bytes
}

// `numbers` hold `per_vector` of them for each vector of the member; both are cut to what the other has.
void write(std::vector<std::byte>& bytes, const BlockMember& member, MatrixOrder order, std::span<const double> numbers,
           unsigned per_vector) {
    Storage shape = storage(member);
    // Rows of a square matrix lie where its columns would.
    const bool by_rows = order == MatrixOrder::Rows && shape.columns > 1;
    for (unsigned v = 0; v < shape.vectors; v++) {
        for (unsigned r = 0; r < std::min(shape.rows, per_vector); r++) {
            std::size_t index = std::size_t(v) * per_vector + r;
            const unsigned first = v / shape.columns * shape.columns;  // vector of the matrix
            const unsigned vector = by_rows ? first + r : v, component = by_rows ? v - first : r;
            std::size_t offset = member.offset + std::size_t(vector) * shape.stride + 4 * component;
            if (index >= numbers.size() || offset + 4 > bytes.size()) return;
            if (shape.is_float) {
                auto value = float(numbers[index]);
                std::memcpy(&bytes[offset], &value, sizeof value);
            } else {
                auto value = std::int32_t(numbers[index]);
                std::memcpy(&bytes[offset], &value, sizeof value);
            }
        }
    }
}

// Of a matrix, by rows: the columns of the float4x4 that its block holds.
std::vector<double> columns_of(std::span<const double> rows) {
    const auto size = std::size_t(std::lround(std::sqrt(double(rows.size()))));
    std::vector<double> columns(16);
    for (std::size_t i = 0; i < rows.size(); i++) columns[i % size * 4 + i / size] = rows[i];
    return columns;
}

// The value of a matrix, a gradient or a curve.
std::vector<double> array_numbers(const Property& property, const MaterialValues& values) {
    auto found = values.arrays.find(property.name);
    const std::vector<double>& numbers = found == values.arrays.end() ? property.numbers : found->second;
    return property.type == PropertyType::Gradient || property.type == PropertyType::Curve ? numbers
                                                                                           : columns_of(numbers);
}

// The value of a member of the graph's own block: a property, or a texture's tiling or size.
std::optional<std::vector<double>> material_numbers(const BlockMember& member, const std::string& block,
                                                    const Reflection& reflection, const MaterialValues& values) {
    const auto list = [](const Numbers& numbers) { return std::vector<double>(numbers.begin(), numbers.end()); };
    for (const Property& property : reflection.properties) {
        if (!(is_number(property.type) || is_array(property.type)) || property.block != block ||
            property.offset != member.offset)
            continue;
        if (is_array(property.type)) return array_numbers(property, values);
        auto found = values.numbers.find(property.name);
        return list(found == values.numbers.end() ? property.value : found->second);
    }
    for (const Texture& texture : reflection.textures) {
        if (member.name != texture.tiling) continue;
        auto found = values.tilings.find(texture.name);
        return list(found == values.tilings.end() ? Numbers{1, 1, 0, 0} : found->second);
    }
    return std::nullopt;
}

// The values of all instances at a member of a block, one after the other.
EngineValue instance_numbers(const BlockMember& member, const std::string& block, const Reflection& reflection,
                             const MaterialValues& values, std::span<const SeenInstance> instances,
                             const std::map<std::string, EngineValue>& engine) {
    EngineValue all{.per_vector = 4, .numbers = {}};
    for (const SeenInstance& instance : instances) {
        if (const std::optional<std::vector<double>> own =
                material_numbers(member, block, reflection, instance.values ? *instance.values : values)) {
            all.numbers.insert(all.numbers.end(), own->begin(), own->end());
            continue;
        }
        const std::map<std::string, EngineValue> placed = object_values(instance.object_to_world);
        for (const std::map<std::string, EngineValue>* from : {&placed, &engine}) {
            const auto found = from->find(member.name);
            if (found == from->end()) continue;
            all.per_vector = found->second.per_vector;
            all.numbers.insert(all.numbers.end(), found->second.numbers.begin(), found->second.numbers.end());
            break;
        }
    }
    return all;
}

std::vector<BlockBytes> fill_with(const Reflection& reflection, const MaterialValues& values,
                                  std::span<const SeenInstance> instances,
                                  const std::map<std::string, EngineValue>& engine) {
    std::vector<BlockBytes> result;
    for (const Block& block : reflection.blocks) {
        BlockBytes filled{.name = block.name, .bytes = std::vector<std::byte>(block.size)};
        for (const BlockMember& member : block.members) {
            if (member.is_of_instance) {
                const EngineValue all = instance_numbers(member, block.name, reflection, values, instances, engine);
                write(filled.bytes, member, block.matrices, all.numbers, all.per_vector);
            } else if (block.is_material) {
                std::optional<std::vector<double>> numbers = material_numbers(member, block.name, reflection, values);
                if (numbers) write(filled.bytes, member, block.matrices, *numbers, 4);
            } else if (auto found = engine.find(member.name); found != engine.end()) {
                write(filled.bytes, member, block.matrices, found->second.numbers, found->second.per_vector);
            }
        }
        result.push_back(std::move(filled));
    }
    return result;
}

}  // namespace

const Property* lighting_option(const Reflection& reflection, const std::string& name) {
    for (const Property& option : reflection.lighting_options)
        if (option.name == name) return &option;
    return nullptr;
}

std::vector<std::string> property_names(const Reflection& reflection) {
    std::vector<std::string> names;
    for (const Property& property : reflection.properties) names.push_back(property.name);
    for (const Property& option : reflection.lighting_options) names.push_back(option.name);
    for (const Texture& texture : reflection.textures)
        if (!texture.tiling.empty()) names.push_back(texture.name + "_ST");
    return names;
}

Outcome<MaterialValues> material_values(const Reflection& reflection, const std::map<std::string, std::string>& words,
                                        Spelling spelling) {
    MaterialValues result;
    for (const Property& property : reflection.properties)
        if (is_number(property.type)) result.numbers[property.name] = property.value;

    for (const auto& [name, text] : words) {
        if (const Texture* texture = tiled_texture(reflection, name)) {
            int count = 0;
            Outcome<glm::vec4> value = parse_numbers(text, count);
            if (!value || count != 4)
                return Failure{name + " must be scale x, scale y, offset x, offset y, like " +
                               (spelling == Spelling::Json ? "[2, 2, 0, 0]" : "2,2,0,0") + ", not '" + text + "'"};
            result.tilings[texture->name] = {value.value.x, value.value.y, value.value.z, value.value.w};
            continue;
        }
        auto found = std::find_if(reflection.properties.begin(), reflection.properties.end(),
                                  [&, &wanted = name](const Property& property) { return property.name == wanted; });
        if (found == reflection.properties.end()) {
            const Property* option = lighting_option(reflection, name);
            if (!option) return Failure{no_property(reflection, name)};
            // The material was compiled for it (keywords_of()).
            if (const Outcome<Numbers> value = parse_value(*option, text, spelling); !value)
                return Failure{value.error};
            continue;
        }
        if (is_texture(found->type)) {
            result.textures[name] = text;
            continue;
        }
        if (found->type == PropertyType::Sampler) {
            const NamedSampler* const sampler = find_sampler(text);
            if (!sampler) return Failure{no_sampler(name, text)};
            result.samplers[name] = sampler->sampler;
            continue;
        }
        if (is_array(found->type)) {
            ReadNumbers read = read_array_value(found->type, text);
            if (!read.ok) return Failure{wrong_array(*found, text, read)};
            result.arrays[name] = std::move(read.numbers);
            continue;
        }
        Outcome<Numbers> value = parse_value(*found, text, spelling);
        if (!value) return Failure{value.error};
        if (std::string outside = outside_range(*found, value.value); !outside.empty()) {
            if (found->hard) return Failure{outside};
            result.warnings.push_back(outside);
        }
        result.numbers[name] = value.value;
    }
    return result;
}

std::vector<std::pair<std::string, std::string>> keywords_of(const Reflection& reflection,
                                                             const std::map<std::string, std::string>& words,
                                                             Spelling spelling) {
    std::vector<std::pair<std::string, std::string>> wanted;
    const auto want = [&](const Property& property) {
        const bool is_variant = property.binding == Binding::Variant;
        const auto word = words.find(property.name);
        if ((!is_variant && !property.constant_id) || word == words.end()) return;
        const Outcome<Numbers> value = parse_value(property, word->second, spelling);
        const bool is_other = value && is_variant && value.value[0] != property.value[0];
        if (is_other || (!value && spelling == Spelling::Words)) wanted.push_back(*word);
    };
    std::ranges::for_each(reflection.properties, want);
    std::ranges::for_each(reflection.lighting_options, want);
    return wanted;
}

std::vector<ConstantValue> constants_of(const Reflection& reflection, const MaterialValues& values) {
    std::vector<ConstantValue> constants;
    for (const Property& property : reflection.properties) {
        if (!property.constant_id) continue;
        const auto found = values.numbers.find(property.name);
        const double value = found == values.numbers.end() ? property.value[0] : found->second[0];
        constants.push_back(
            {.id = *property.constant_id, .value = static_cast<std::uint32_t>(value), .name = property.identifier});
    }
    return constants;
}

std::vector<BlockBytes> fill_blocks(const Reflection& reflection, const MaterialValues& values, const Scene& scene) {
    const SeenInstance alone{.object_to_world = scene.object_to_world};
    return fill_with(reflection, values, std::span(&alone, 1), engine_values(scene));
}

std::vector<BlockBytes> fill_blocks(const Reflection& reflection, const MaterialValues& values,
                                    const EngineScene& seen) {
    const SeenInstance alone{.object_to_world = seen.object_to_world};
    return fill_with(reflection, values, seen.instances.empty() ? std::span(&alone, 1) : std::span(seen.instances),
                     engine_values(seen));
}

}  // namespace patina::runtime
