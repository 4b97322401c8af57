#include "compiler/capi/read_options.h"

#include <cmath>
#include <memory>
#include <optional>

#include "compiler/api/report.h"
#include "compiler/format/read_fields.h"

namespace patina::capi {
namespace {

using format::ObjectKind;
using json::Json;

class Reader {
public:
    Reader(format::Reading& reading, const Compiler& compiler, CompileOptions& options)
        : reading_(reading), compiler_(compiler), options_(options) {}

    void read(const Json& json) {
        if (!expect(reading_, json, Json::Kind::Object, "the text of the options")) return;
        check_keys(reading_, json, ObjectKind::Options);
        if (const Json* names = json.find("targets")) targets(*names);
        request(json);
        if (const Json* values = json.find("switches")) switches(*values);
        options_.lighting = read_text(reading_, json, "lighting");
        options_.include_dirs = texts(json, "includeDirs");
        if (std::string root = read_text(reading_, json, "root"); !root.empty())
            options_.files = disk({.root = std::move(root)});
        read_bool(reading_, json, "keepVariants", options_.keep_variants);
        read_bool(reading_, json, "acceptParts", options_.accept_parts);
        read_bool(reading_, json, "hashes", options_.hashes);
        if (const Json* limits = json.find("limits");
            limits && expect(reading_, *limits, Json::Kind::Object, "'limits'")) {
            check_keys(reading_, *limits, ObjectKind::OptionsLimits);
            count(*limits, "nodes", options_.limits.nodes);
            count(*limits, "instructions", options_.limits.instructions);
            count(*limits, "sourceBytes", options_.limits.source_bytes);
            count(*limits, "shaderBytes", options_.limits.shader_bytes);
        }
    }

private:
    void targets(const Json& json) {
        options_.targets.clear();
        for (const Json* each : strings(json, "targets")) {
            const std::vector<Target> meant = compiler_.targets(each->string);
            if (meant.empty()) {
                std::vector<std::string_view> known;
                for (const EngineInfo& engine : compiler_.engines()) {
                    if (engine.is_default) known.insert(known.end(), engine.languages.begin(), engine.languages.end());
                    known.push_back(engine.name);
                }
                suggest(reading_,
                        reading_.diagnostics.report(Code::UnknownWord, format::inside(each->span),
                                                    json::shown(each->string), "a language or an engine"),
                        each->string, known);
            }
            options_.targets.insert(options_.targets.end(), meant.begin(), meant.end());
        }
    }

    // Passes, functions or a preview.
    void request(const Json& json) {
        CompileOptions::Passes passes;
        if (std::string path = read_text(reading_, json, "path"); !path.empty()) passes.path = std::move(path);
        passes.only = texts(json, "passes");
        options_.request = passes;
        if (std::string port = read_text(reading_, json, "preview"); !port.empty())
            options_.request = CompileOptions::Preview{.port = std::move(port), .passes = passes};
        const json::JsonMember* functions = format::find_member(json, "functions");
        if (!functions) return;
        for (const std::string_view other : {"path", "passes", "preview"}) {
            if (json.find(other))
                reading_.diagnostics.report(Code::ConflictingInputs, functions->key_span, "functions", other);
        }
        options_.request = CompileOptions::Functions{.prefix = read_text(reading_, json, "functions")};
    }

    void switches(const Json& json) {
        if (!expect(reading_, json, Json::Kind::Object, "'switches'")) return;
        for (const json::JsonMember& member : json.members) {
            std::string value = member.value.string;
            switch (member.value.kind) {
                case Json::Kind::String: break;
                case Json::Kind::Bool: value = member.value.boolean ? "true" : "false"; break;
                case Json::Kind::Number: value = reading_.sources.text(member.value.span); break;
                case Json::Kind::Null:
                case Json::Kind::Array:
                case Json::Kind::Object:
                    report_type(reading_, member.value, fmt::format("'{}'", json::shown(member.key)),
                                "a word, a number, true or false");
                    continue;
            }
            options_.switches.emplace_back(member.key, std::move(value));
        }
    }

    void count(const Json& object, std::string_view key, std::size_t& into) {
        const Json* json = object.find(key);
        if (!json || !expect(reading_, *json, Json::Kind::Number, fmt::format("'{}'", key))) return;
        constexpr double kMost = 9007199254740992;  // the last whole number of a double without a gap before it
        if (json->number < 0 || json->number > kMost || json->number != std::floor(json->number))
            report_type(reading_, *json, fmt::format("'{}'", key), "a whole number from 0");
        else
            into = static_cast<std::size_t>(json->number);
    }

    std::vector<const Json*> strings(const Json& json, std::string_view key) {
        std::vector<const Json*> result;
        if (!expect(reading_, json, Json::Kind::Array, fmt::format("'{}'", key))) return result;
        for (const Json& each : json.elements) {
            if (read_string(reading_, each, fmt::format("an entry of '{}'", key))) result.push_back(&each);
        }
        return result;
    }
    std::vector<std::string> texts(const Json& object, std::string_view key) {
        std::vector<std::string> result;
        if (const Json* json = object.find(key)) {
            for (const Json* each : strings(*json, key)) result.push_back(each->string);
        }
        return result;
    }

    format::Reading& reading_;
    const Compiler& compiler_;
    CompileOptions& options_;
};

}  // namespace

std::vector<Diagnostic> read_options(const Compiler& compiler, std::string text, CompileOptions& options) {
    SourceMap sources;
    Diagnostics diagnostics;
    nodelang::Ast ast;
    const std::uint32_t base = sources.add("options", std::move(text));
    if (const std::unique_ptr<Json> json = json::parse_json(sources, base, diagnostics)) {
        format::Reading reading{.sources = sources, .ast = ast, .diagnostics = diagnostics};
        Reader(reading, compiler, options).read(*json);
    }
    return to_public(diagnostics, sources);
}

}  // namespace patina::capi
