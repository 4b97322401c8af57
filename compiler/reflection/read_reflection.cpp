#include "compiler/reflection/read_reflection.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include "compiler/json/json.h"
#include "compiler/reflection/describe.h"

namespace patina::reflection {
namespace {

using json::Json;

// Reads the keys of one object.
class ReadFields {
public:
    static constexpr bool kWrites = false;

    ReadFields(const Json& object, const SourceMap& sources, Diagnostics& diagnostics)
        : object_(object), sources_(sources), diagnostics_(diagnostics) {}

    template <class T>
    void key(const char* name, T& value, std::string_view) {
        if (is_other_version_) return;
        if (const Json* json = object_.find(name))
            read(name, *json, value);
        else
            diagnostics_.report(Code::MissingKey, {object_.span.begin, object_.span.begin + 1}, "the object", name);
    }
    template <class T>
    void optional(const char* name, T& value, const T&, std::string_view) {
        read_if_there(name, value);
    }
    template <class T>
    void key_if(bool, const char* name, T& value, std::string_view) {
        read_if_there(name, value);
    }

    void version(const char* name, int version, std::string_view doc) {
        int found = version;
        key(name, found, doc);
        if (found == version) return;
        diagnostics_.report(Code::ImpossibleValue, object_.find(name)->span, name, version)
            .note("another version of Patina has written this reflection");
        is_other_version_ = true;
    }
    void meta(std::string& json) {
        if (const Json* meta = object_.find("meta")) json = sources_.text(meta->span);
    }
    void stencil_reference(bool, Stencil& stencil) {
        const Json* json = object_.find("stencilReference");
        if (!json) return;
        if (json->kind == Json::Kind::String)
            read("stencilReference", *json, stencil.reference);
        else
            read("stencilReference", *json, stencil.value);
    }
    void texture_default(Texture& texture) {
        const Json* json = object_.find("default");
        std::string text;
        if (!json || !read("default", *json, text)) return;
        texture.default_texture = from_word<TextureDefault>(text).value_or(TextureDefault::File);
        if (texture.default_texture == TextureDefault::File) texture.default_file = std::move(text);
    }
    void property_default(Property& property) {
        // The texture has its own.
        if (is_texture(property.type)) return;
        if (property.type == PropertyType::Sampler) return sampler_default(property);
        if (property.type == PropertyType::Enum) return key("defaultIndex", property.value[0], {});
        const std::size_t count = component_count(property.type);
        const Json* json = object_.find("default");
        if (property.type == PropertyType::Bool) {
            bool is_on = false;
            key("default", is_on, {});
            property.value[0] = is_on ? 1 : 0;
        } else if (is_array(property.type)) {
            key("default", property.numbers, {});
            if (json) is_list("default", *json, count);
        } else if (!json || count == 1) {
            key("default", property.value[0], {});
        } else if (is_list("default", *json, count)) {
            for (std::size_t i = 0; i < count; ++i) read("default", json->elements[i], property.value[i]);
        }
    }

private:
    void sampler_default(Property& property) {
        std::string name;
        key("default", name, {});
        const Json* const json = object_.find("default");
        if (const NamedSampler* const found = find_sampler(name))
            property.sampler = found->sampler;
        else if (json && json->kind == Json::Kind::String)
            diagnostics_.report(Code::UnknownWord, json->span, json::shown(name), "a sampler");
    }

    template <class T>
    void read_if_there(const char* name, T& value) {
        const Json* const json = is_other_version_ ? nullptr : object_.find(name);
        if (json) read(name, *json, value);
    }

    bool refuse(std::string_view name, const Json& json, std::string_view wanted) {
        const bool is_number = json.kind == Json::Kind::Number;
        diagnostics_.report(Code::WrongJsonType, json.span, fmt::format("'{}'", name), wanted,
                            is_number ? json::shown(sources_.text(json.span)) : json::describe(json.kind));
        return false;
    }
    bool is_list(std::string_view name, const Json& json, std::size_t count) {
        if (json.kind == Json::Kind::Array && json.elements.size() == count) return true;
        return refuse(name, json, fmt::format("an array of {} values", count));
    }

    bool read(std::string_view name, const Json& json, std::string& text) {
        if (json.kind != Json::Kind::String) return refuse(name, json, "a string");
        text = json.string;
        return true;
    }
    bool read(std::string_view name, const Json& json, bool& value) {
        if (json.kind != Json::Kind::Bool) return refuse(name, json, "true or false");
        value = json.boolean;
        return true;
    }
    bool read(std::string_view name, const Json& json, double& value) {
        if (json.kind != Json::Kind::Number) return refuse(name, json, "a number");
        value = json.number;
        return true;
    }
    template <std::integral T>
    bool read(std::string_view name, const Json& json, T& value) {
        using Limits = std::numeric_limits<T>;
        const bool fits = json.kind == Json::Kind::Number && json.number == std::floor(json.number) &&
                          json.number >= double(Limits::min()) && json.number <= double(Limits::max());
        if (!fits) return refuse(name, json, fmt::format("a whole number from {} to {}", Limits::min(), Limits::max()));
        value = static_cast<T>(json.number);
        return true;
    }
    template <HasWords E>
    bool read(std::string_view name, const Json& json, E& value) {
        std::string text;
        if (!read(name, json, text)) return false;
        const std::optional<E> found = from_word<E>(text);
        if (found) {
            value = *found;
            return true;
        }
        std::vector<std::string_view> known;
        for (const Word<E>& word : kWords<E>) known.push_back(word.text);
        diagnostics_.report(Code::UnknownWord, json.span, json::shown(text), fmt::format("a value of '{}'", name))
            .note(Diagnostics::suggestion(text, known));
        return false;
    }
    template <class T>
    bool read(std::string_view name, const Json& json, std::optional<T>& value) {
        T made{};
        if (!read(name, json, made)) return false;
        value = std::move(made);
        return true;
    }
    template <class T>
    bool read(std::string_view name, const Json& json, std::vector<T>& values) {
        if (json.kind != Json::Kind::Array) return refuse(name, json, "an array");
        values.clear();
        for (const Json& element : json.elements) {
            T made{};
            if (!read(name, element, made)) return false;
            values.push_back(std::move(made));
        }
        return true;
    }
    template <class T, std::size_t kCount>
    bool read(std::string_view name, const Json& json, std::array<T, kCount>& values) {
        if (!is_list(name, json, kCount)) return false;
        for (std::size_t i = 0; i < kCount; ++i)
            if (!read(name, json.elements[i], values[i])) return false;
        return true;
    }
    bool read(std::string_view name, const Json& json, Bounds& bounds) {
        if (json.kind != Json::Kind::Array) return read(name, json, bounds.margin);
        return read(name, json, bounds.box);
    }
    template <class T>
    requires requires(ReadFields& fields, T& value) { describe(fields, value); }
    bool read(std::string_view name, const Json& json, T& value) {
        if (json.kind != Json::Kind::Object) return refuse(name, json, "an object");
        ReadFields fields(json, sources_, diagnostics_);
        describe(fields, value);
        return true;
    }

    const Json& object_;
    const SourceMap& sources_;
    Diagnostics& diagnostics_;
    bool is_other_version_ = false;  // its keys are not known
};

// A program writes values to these places.
void check_blocks(const Json& json, const Reflection& made, Diagnostics& diagnostics) {
    const Json* const properties = json.find("properties");
    for (std::size_t i = 0; i < made.properties.size(); ++i) {
        const Property& property = made.properties[i];
        if (property.block.empty()) continue;
        const Json& object = properties->elements[i];
        const auto block = std::find_if(made.blocks.begin(), made.blocks.end(),
                                        [&](const Block& each) { return each.name == property.block; });
        if (block == made.blocks.end())
            diagnostics.report(Code::UnknownWord, object.find("block")->span, json::shown(property.block),
                               "one of the blocks");
        else if (std::uint64_t{property.offset} + property.size > block->size)
            diagnostics.report(Code::ImpossibleValue, object.find("offset") ? object.find("offset")->span : object.span,
                               "offset", fmt::format("inside the {} bytes of '{}'", block->size, block->name));
    }
}

}  // namespace

Reflection read_reflection(const SourceMap& sources, std::uint32_t base, Diagnostics& diagnostics) {
    Reflection made;
    const std::unique_ptr<Json> json = json::parse_json(sources, base, diagnostics);
    if (!json) return made;
    if (json->kind != Json::Kind::Object) {
        diagnostics.report(Code::WrongJsonType, json->span, "a reflection", "an object", json::describe(json->kind));
        return made;
    }
    ReadFields fields(*json, sources, diagnostics);
    describe(fields, made);
    if (!diagnostics.has_errors()) check_blocks(*json, made, diagnostics);
    return made;
}

}  // namespace patina::reflection
