// Reflection::schema(): the JSON Schema of what to_json() writes.
#include <concepts>
#include <type_traits>

#include "compiler/json/json_writer.h"
#include "compiler/reflection/describe.h"

namespace patina::reflection {
namespace {

// Writes "properties" of an object and collects its required keys.
class SchemaFields {
public:
    static constexpr bool kWrites = false;

    explicit SchemaFields(JsonWriter& json) : json_(json) {}

    // The inside of the schema of an object.
    template <class T>
    static void write_object(JsonWriter& json, T& value) {
        SchemaFields fields(json);
        json.write("type", "object");
        json.begin("properties", '{');
        describe(fields, value);
        json.end();
        json.write("required", fields.required_);
        json.write("additionalProperties", false);
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
            "gradient or a curve: the numbers of its array in the block");
        raw("defaultIndex", R"("type": "integer")", "of an enum: the index of its word");
    }

private:
    static std::string fmt_version(int version) { return "\"enum\": [" + std::to_string(version) + "]"; }

    template <class T>
    void property(const char* name, T& value, std::string_view doc) {
        json_.begin(name, '{');
        type(value);
        json_.write("description", doc);
        json_.end();
    }
    // `json`: the members that state the type.
    void raw(const char* name, const std::string& json, std::string_view doc) {
        json_.write_key(name);
        json_.raw("{ " + json + (json.empty() ? "" : ", ") + "\"description\": \"" + std::string(doc) + "\" }");
    }

    void type(std::string&) { json_.write("type", "string"); }
    void type(bool&) { json_.write("type", "boolean"); }
    void type(double&) { json_.write("type", "number"); }
    template <std::integral T>
    void type(T&) {
        json_.write("type", "integer");
        if constexpr (std::is_unsigned_v<T>) json_.write("minimum", 0);
    }
    template <HasWords E>
    void type(E&) {
        json_.begin("enum", '[');
        for (const Word<E>& word : kWords<E>) json_.write(word.text);
        json_.end();
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
        json_.write("minItems", kCount);
        json_.write("maxItems", kCount);
    }
    void type(Bounds&) {
        std::array<std::array<double, 3>, 2> box{};
        json_.begin("anyOf", '[');
        json_.begin('{');
        json_.write("type", "number");
        json_.end();
        json_.begin('{');
        type(box);
        json_.end();
        json_.end();
    }
    template <class T>
    requires requires(SchemaFields& fields, T& value) { describe(fields, value); }
    void type(T& value) { write_object(json_, value); }
    template <class T>
    void list() {
        T value{};
        json_.write("type", "array");
        json_.begin("items", '{');
        type(value);
        json_.end();
    }

    JsonWriter& json_;
    std::vector<const char*> required_;
};

}  // namespace
}  // namespace patina::reflection

namespace patina {

std::string Reflection::schema() {
    JsonWriter json(JsonWriter::Layout::ShortLists);
    Reflection any;
    json.begin('{');
    json.write("$schema", "https://json-schema.org/draft/2020-12/schema");
    json.write("title", "The reflection of a material that Patina has compiled");
    reflection::SchemaFields::write_object(json, any);
    json.end();
    return json.take() + "\n";
}

}  // namespace patina
