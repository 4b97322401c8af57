// Reflection::to_json(): pretty-printed, with keys in the order of describe.h.
#include <concepts>

#include "compiler/base/text.h"
#include "compiler/json/json_writer.h"
#include "compiler/reflection/describe.h"

namespace patina::reflection {
namespace {

template <class T>
bool is_left_out(const T& value, const T& usual) {
    if constexpr (requires(T list) { list.clear(); }) {  // text, lists
        return value.empty();
    } else if constexpr (requires { value.has_value(); }) {
        return !value.has_value();
    } else {
        return value == usual;
    }
}

class WriteFields {
public:
    static constexpr bool kWrites = true;

    WriteFields(JsonWriter& json, const Reflection& reflection) : json_(json), reflection_(reflection) {}

    template <class T>
    void key(const char* name, const T& value, std::string_view) {
        json_.write_key(name);
        write(value);
    }
    template <class T>
    void optional(const char* name, const T& value, const T& usual, std::string_view doc) {
        if (!is_left_out(value, usual)) key(name, value, doc);
    }
    template <class T>
    void key_if(bool is_there, const char* name, const T& value, std::string_view doc) {
        if (is_there) key(name, value, doc);
    }

    void version(const char* name, int version, std::string_view doc) { key(name, version, doc); }
    void meta(const std::string& json) {
        if (json.empty()) return;
        json_.write_key("meta");
        json_.raw(json);
    }
    void stencil_reference(bool is_used, const Stencil& stencil) {
        if (!is_used) return;
        if (stencil.is_of_lighting()) return key("stencilReference", stencil.reference, {});
        key("stencilReference", stencil.value, {});
    }
    void texture_default(const Texture& texture) {
        if (texture.default_texture == TextureDefault::None) return;
        key("default", texture.default_text(), {});
    }
    void property_default(const Property& property) {
        if (is_texture(property.type)) {
            for (const Texture& texture : reflection_.textures)
                if (texture.name == property.name) texture_default(texture);
        } else if (property.type == PropertyType::Bool) {
            key("default", property.value[0] != 0, {});
        } else if (property.type == PropertyType::Enum) {
            const auto index = static_cast<std::size_t>(property.value[0]);
            if (index < property.values.size()) key("default", property.values[index], {});
            key("defaultIndex", property.value[0], {});
        } else if (property.type == PropertyType::Sampler) {
            key("default", name_of(property.sampler), {});
        } else if (is_array(property.type)) {
            key("default", property.numbers, {});
        } else if (const std::size_t count = component_count(property.type); count == 1) {
            key("default", property.value[0], {});
        } else {
            key("default", std::vector<double>(property.value.begin(), property.value.begin() + std::ptrdiff_t(count)),
                {});
        }
    }

private:
    void write(std::string_view text) { json_.write(text); }
    void write(const std::string& text) { json_.write(text); }
    void write(bool value) { json_.write(value); }
    template <class T>
    requires(std::integral<T> || std::floating_point<T>) void write(T value) {
        json_.raw(shortest(static_cast<double>(value)));
    }
    void write(HasWords auto value) { json_.write(value); }
    template <class T>
    void write(const std::optional<T>& value) {
        write(*value);
    }
    template <class T>
    void write(const std::vector<T>& values) {
        write_list(values);
    }
    template <class T, std::size_t kCount>
    void write(const std::array<T, kCount>& values) {
        write_list(values);
    }
    void write(const Bounds& bounds) {
        if (bounds.box)
            write(*bounds.box);
        else
            write(bounds.margin);
    }
    template <class T>
    requires requires(WriteFields& fields, const T& value) { describe(fields, value); }
    void write(const T& value) {
        json_.begin('{');
        describe(*this, value);
        json_.end();
    }
    void write_list(const auto& values) {
        json_.begin('[');
        for (const auto& value : values) write(value);
        json_.end();
    }

    JsonWriter& json_;
    const Reflection& reflection_;
};

}  // namespace
}  // namespace patina::reflection

namespace patina {

std::string Reflection::to_json() const {
    JsonWriter json(JsonWriter::Layout::ShortLists);
    reflection::WriteFields fields(json, *this);
    json.begin('{');
    reflection::describe(fields, *this);
    json.end();
    return json.take() + "\n";
}

}  // namespace patina
