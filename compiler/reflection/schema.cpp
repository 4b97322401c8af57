// Reflection::schema(): the JSON Schema of what to_json() writes.
#include <concepts>
#include <type_traits>

#include "compiler/json/memory/json_memory.h"
#include "compiler/reflection/describe.h"

namespace patina::reflection {
namespace {

using Writer = JsonPages;

void write(Writer& writer, const char* key, std::string_view text) {
    writer.Key(key);
    writer.String(text.data(), static_cast<rapidjson::SizeType>(text.size()));
}

// Writes "properties" of an object and collects its required keys.
class SchemaFields {
public:
    static constexpr bool kWrites = false;

    explicit SchemaFields(Writer& writer) : writer_(writer) {}

    // The inside of the schema of an object.
    template <class T>
    static void write_object(Writer& writer, T& value) {
        SchemaFields fields(writer);
        write(writer, "type", "object");
        writer.Key("properties");
        writer.StartObject();
        describe(fields, value);
        writer.EndObject();
        writer.Key("required");
        writer.StartArray();
        for (const char* name : fields.required_) writer.String(name);
        writer.EndArray();
        writer.Key("additionalProperties");
        writer.Bool(false);
    }

    template <class T>
    void key(const char* name, T& value, std::string_view doc) {
        required_.push_back(name);
        property(name, value, doc);
    }
    template <class T>
    void optional(const char* name, T& value, const T&, std::string_view doc) {
        property(name, value, doc);
    }
    template <class T>
    void key_if(bool, const char* name, T& value, std::string_view doc) {
        property(name, value, doc);
    }

    void version(const char* name, int version, std::string_view doc) {
        required_.push_back(name);
        raw(name, fmt_version(version), doc);
    }
    void meta(std::string&) { raw("meta", "", "what the graph's key 'meta' has"); }
    void stencil_reference(bool, Stencil&) {
        raw("stencilReference", R"("anyOf": [{ "type": "integer" }, { "enum": ["lighting"] }])",
            "a number; lighting: one that the materials of a lighting pass share");
    }
    void texture_default(Texture&) {
        raw("default", R"("type": "string")", "white, black, gray, bump, or a file: its path from the graph's folder");
    }
    void property_default(Property&) {
        raw("default",
            R"("anyOf": [{ "type": ["number", "boolean", "string"] }, { "type": "array", "items": { "type": "number" } }])",
            "of its type; colours are linear; of an enum and a sampler: its word; of a matrix: row by row; of a "
            "gradient or a curve: "
            "what its array in the block holds");
        raw("defaultIndex", R"("type": "integer")", "of an enum: the index of its word");
    }

private:
    static std::string fmt_version(int version) { return "\"enum\": [" + std::to_string(version) + "]"; }

    template <class T>
    void property(const char* name, T& value, std::string_view doc) {
        writer_.Key(name);
        writer_.StartObject();
        type(value);
        write(writer_, "description", doc);
        writer_.EndObject();
    }
    // `json`: the members that state the type.
    void raw(const char* name, const std::string& json, std::string_view doc) {
        writer_.Key(name);
        const std::string text =
            "{ " + json + (json.empty() ? "" : ", ") + "\"description\": \"" + std::string(doc) + "\" }";
        writer_.RawValue(text.data(), text.size(), rapidjson::kObjectType);
    }

    void type(std::string&) { write(writer_, "type", "string"); }
    void type(bool&) { write(writer_, "type", "boolean"); }
    void type(double&) { write(writer_, "type", "number"); }
    template <std::integral T>
    void type(T&) {
        write(writer_, "type", "integer");
        if constexpr (std::is_unsigned_v<T>) {
            writer_.Key("minimum");
            writer_.Int(0);
        }
    }
    template <HasWords E>
    void type(E&) {
        writer_.Key("enum");
        writer_.StartArray();
        for (const Word<E>& word : kWords<E>)
            writer_.String(word.text.data(), static_cast<rapidjson::SizeType>(word.text.size()));
        writer_.EndArray();
    }
    template <class T>
    void type(std::optional<T>&) {
        T value{};
        type(value);
    }
    template <class T>
    void type(std::vector<T>&) {
        list<T>();
    }
    template <class T, std::size_t kCount>
    void type(std::array<T, kCount>&) {
        list<T>();
        writer_.Key("minItems");
        writer_.Uint(kCount);
        writer_.Key("maxItems");
        writer_.Uint(kCount);
    }
    void type(Bounds&) {
        std::array<std::array<double, 3>, 2> box{};
        writer_.Key("anyOf");
        writer_.StartArray();
        writer_.StartObject();
        write(writer_, "type", "number");
        writer_.EndObject();
        writer_.StartObject();
        type(box);
        writer_.EndObject();
        writer_.EndArray();
    }
    template <class T>
    requires requires(SchemaFields& fields, T& value) { describe(fields, value); }
    void type(T& value) { write_object(writer_, value); }
    template <class T>
    void list() {
        T value{};
        write(writer_, "type", "array");
        writer_.Key("items");
        writer_.StartObject();
        type(value);
        writer_.EndObject();
    }

    Writer& writer_;
    std::vector<const char*> required_;
};

}  // namespace
}  // namespace patina::reflection

namespace patina {

std::string Reflection::schema() {
    JsonBuffer buffer;
    reflection::Writer writer(buffer);
    writer.SetIndent(' ', 2);
    writer.SetFormatOptions(rapidjson::kFormatSingleLineArray);
    Reflection any;
    writer.StartObject();
    reflection::write(writer, "$schema", "https://json-schema.org/draft/2020-12/schema");
    reflection::write(writer, "title", "The reflection of a material that Patina has compiled");
    reflection::SchemaFields::write_object(writer, any);
    writer.EndObject();
    return std::string(buffer.GetString(), buffer.GetSize()) + "\n";
}

}  // namespace patina
