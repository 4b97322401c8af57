#include "compiler/engines/read_engine.h"

#include <algorithm>

#include "compiler/format/read_fields.h"

namespace patina::engines {
namespace {

using json::Json;

constexpr std::array kGroups = {Word<ir::Group>{"engine", ir::Group::Engine},
                                Word<ir::Group>{"material", ir::Group::Material},
                                Word<ir::Group>{"targets", ir::Group::Targets}};
constexpr int kMostNumber = 1 << 20;  // of sets, bindings and locations

class Reader {
public:
    Reader(format::Reading& reading, const FindFile& find_file, const Printable& printable, Engine& engine)
        : reading_(reading), find_file_(find_file), printable_(printable), engine_(engine) {}

    void engine(const Json& json) {
        using enum format::ObjectKind;
        check_keys(reading_, json, Engine);
        engine_.title = text(json, "name");
        engine_.help = text(json, "help");
        if (const Json* languages = json.find("languages"))
            engine_.languages = chosen(*languages, printable_.languages, "a language that Patina writes");
        if (const Json* format = json.find("file")) {
            for (std::string& name : chosen(*format, printable_.formats, "a file format that Patina writes"))
                engine_.file = std::move(name);
        }
        if (const Json* name = json.find("passes")) engine_.passes = file(*name);
        engine_.paths = texts(json, "paths");
        if (const Json* name = json.find("include")) {
            if (const std::optional<std::uint32_t> base = file(*name))
                engine_.include = reading_.sources.file_text(*base);
        }
        word(json, "variants", "a way to handle variants", engine_.variants);
        word(json, "instances", "a way to hold instances", engine_.instances);
        if (const Json* sets = object(json, "sets", EngineSets)) read_sets(*sets);
        engine_.blocks = map(json, "blocks");
        if (const Json* inputs = json.find("vertexInputs")) vertex_inputs(*inputs);
        if (const Json* clip = object(json, "clip", EngineClip)) {
            word(*clip, "depth", "an order of depth", engine_.clip_depth);
        }
        word(json, "matrices", "an order of matrices", engine_.matrices);
        word(json, "uvOrigin", "an origin of texture coordinates", engine_.uv_origin);
        engine_.storage = map(json, "storage");
        format::read_bool(reading_, json, "sharedSamplers", engine_.shares_samplers);
        engine_.texture_sizes = text(json, "textureSizes");
        if (const Json* limits = object(json, "limits", EngineLimits)) {
            number(*limits, "varyings", engine_.most_varyings);
            number(*limits, "blockBytes", engine_.most_block_bytes);
            engine_.guaranteed_block_bytes = engine_.most_block_bytes;
            number(*limits, "guaranteedBlockBytes", engine_.guaranteed_block_bytes);
            number(*limits, "samplers", engine_.most_samplers);
            engine_.varyings_note = text(*limits, "varyingsNote");
        }
        if (const Json* names = object(json, "names", EngineNames)) read_names(*names);
    }

private:
    std::string text(const Json& json, std::string_view key) { return read_text(reading_, json, key); }

    template <class E>
    void word(const Json& json, std::string_view key, std::string_view what, E& into) {
        format::read_word(reading_, json, key, what, into);
    }

    template <class Number>
    void number(const Json& json, std::string_view key, Number& into) {
        const Json* value = json.find(key);
        if (!value) return;
        const auto read = read_int(reading_, *value, fmt::format("'{}'", key), 0, kMostNumber);
        if (read) into = static_cast<std::uint32_t>(*read);
    }

    const Json* object(const Json& json, std::string_view key, format::ObjectKind kind) {
        const Json* value = json.find(key);
        if (!value || !expect(reading_, *value, Json::Kind::Object, fmt::format("'{}'", key))) return nullptr;
        check_keys(reading_, *value, kind);
        return value;
    }

    // The words of an array, or one word, that are known.
    std::vector<std::string> chosen(const Json& json, std::span<const std::string_view> known, std::string_view what) {
        std::vector<std::string> made;
        const auto add = [&](const Json& each) {
            const std::string* word = read_string(reading_, each, what);
            if (!word) return;
            if (std::find(known.begin(), known.end(), *word) != known.end()) return made.push_back(*word);
            reading_.diagnostics.report(Code::UnknownWord, each.span, *word, what)
                .note(Diagnostics::suggestion(*word, known));
        };
        if (json.kind == Json::Kind::Array) {
            for (const Json& each : json.elements) add(each);
        } else {
            add(json);
        }
        return made;
    }

    std::vector<std::string> texts(const Json& json, std::string_view key) {
        std::vector<std::string> made;
        const Json* value = json.find(key);
        if (!value || !expect(reading_, *value, Json::Kind::Array, fmt::format("'{}'", key))) return made;
        for (const Json& each : value->elements) {
            if (const std::string* word = read_string(reading_, each, fmt::format("an element of '{}'", key)))
                made.push_back(*word);
        }
        return made;
    }

    std::map<std::string, std::string, std::less<>> map(const Json& json, std::string_view key) {
        std::map<std::string, std::string, std::less<>> made;
        const Json* value = json.find(key);
        if (!value || !expect(reading_, *value, Json::Kind::Object, fmt::format("'{}'", key))) return made;
        for (const json::JsonMember& each : value->members) {
            if (const std::string* word = read_string(reading_, each.value, fmt::format("'{}'", each.key)))
                made.emplace(each.key, *word);
        }
        return made;
    }

    std::optional<std::uint32_t> file(const Json& json) {
        const std::string* name = read_string(reading_, json, "the name of a file");
        if (!name) return {};
        const std::optional<std::uint32_t> base = find_file_(*name);
        if (!base) reading_.diagnostics.report(Code::MissingFile, json.span, *name);
        return base;
    }

    void read_sets(const Json& json) {
        for (const Word<ir::Group>& group : kGroups) {
            const Json* value = object(json, group.text, format::ObjectKind::EngineSet);
            if (!value) continue;
            Places& places = engine_.places[static_cast<std::size_t>(group.value)];
            number(*value, "set", places.set);
            number(*value, "buffers", places.buffers);
            number(*value, "textures", places.textures);
            number(*value, "samplers", places.samplers);
        }
    }

    void vertex_inputs(const Json& json) {
        if (!expect(reading_, json, Json::Kind::Array, "'vertexInputs'")) return;
        for (const Json& each : json.elements) {
            if (!expect(reading_, each, Json::Kind::Object, "a vertex input")) continue;
            check_keys(reading_, each, format::ObjectKind::EngineVertexInput);
            VertexInput& made = engine_.vertex_inputs.emplace_back();
            made.semantic = text(each, "semantic");
            made.hlsl = text(each, "hlsl");
            number(each, "location", made.location);
        }
    }

    void read_names(const Json& json) {
        engine_.names = {.owner = text(json, "owner"),
                         .taken = texts(json, "taken"),
                         .prefixes = texts(json, "prefixes"),
                         .own = texts(json, "own"),
                         .own_near_properties = texts(json, "ownNearProperties"),
                         .instead = map(json, "instead")};
    }

    format::Reading& reading_;
    const FindFile& find_file_;
    const Printable& printable_;
    Engine& engine_;
};

}  // namespace

Engine read_engine(const SourceMap& sources, std::uint32_t base, std::string folder, const FindFile& find_file,
                   const Printable& printable, Diagnostics& diagnostics) {
    Engine engine;
    engine.name = std::move(folder);
    const std::unique_ptr<Json> json = json::parse_json(sources, base, diagnostics);
    if (!json) return engine;
    nodelang::Ast unused;
    format::Reading reading{.sources = sources, .ast = unused, .diagnostics = diagnostics};
    if (expect(reading, *json, Json::Kind::Object, "an engine"))
        Reader(reading, find_file, printable, engine).engine(*json);
    return engine;
}

}  // namespace patina::engines
