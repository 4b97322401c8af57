#include "compiler/cli/compile/variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "compiler/cli/compile/compiled.h"
#include "compiler/cli/files.h"
#include "compiler/json/json_writer.h"
#include "patina/output_name.h"

namespace patina::cli {
namespace {

constexpr std::size_t kShortHash = 8;

// Shortens hashes: to as many digits as make each different from the others.
class ShortHashes {
public:
    std::string name(const std::string& hash) {
        std::size_t length = kShortHash;
        while (length < hash.size() && taken_.emplace(hash.substr(0, length), hash).first->second != hash) ++length;
        return hash.substr(0, length);
    }

private:
    std::map<std::string, std::string> taken_;
};

// "rust.forward.frag.glsl" -> "rust.3f2a9c1e.forward.frag.glsl"
std::string with_hash(const std::string& file_name, const std::string& name, const std::string& hash) {
    return hash.empty() ? file_name : name + "." + hash + file_name.substr(name.size());
}

VariantsWanted wanted_of(const std::string& word) {
    for (const VariantsWanted each : {VariantsWanted::Listed, VariantsWanted::Reachable}) {
        if (word == to_string(each)) return each;
    }
    return VariantsWanted::All;
}

std::string counted(std::size_t count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

constexpr std::size_t kMostNamed = 12;

// "8 combinations of _DETAIL (2), _Mode (4)"
std::string announcement(const VariantPlan& plan, double count) {
    std::string text = fmt::format("{:.0f} combination{}", count, count == 1 ? "" : "s");
    for (std::size_t i = 0; i < std::min(plan.axes.size(), kMostNamed); ++i)
        text += fmt::format("{}{} ({})", i == 0 ? " of " : ", ", plan.axes[i].property, plan.axes[i].values.size());
    if (plan.axes.size() > kMostNamed) text += fmt::format(" and {} more", plan.axes.size() - kMostNamed);
    if (!plan.axes.empty()) return text;
    return plan.fixed > 0 ? text + ": -D fixes all variants" : "it has no variants; " + text;
}

// A program's files.
struct Written {
    std::string hash;  // short
    WrittenFile reflection;
    std::vector<std::string> files;
};

std::string manifest(const std::string& name, const VariantOptions& wanted, const CompileOptions& options,
                     const VariantPlan& plan, const VariantSet& set, const std::vector<Written>& written) {
    JsonWriter json(JsonWriter::Layout::ShortLists);
    const auto value = [&](const VariantAxis& axis, const std::string& word) {
        if (axis.is_bool)
            json.write(word == "true");
        else
            json.write(word);
    };
    json.begin('{');
    json.write("graph", name);
    json.write("variants", wanted.wanted);
    if (const CompileOptions::Passes* passes = options.passes()) json.write("path", passes->path);
    json.begin("defines", '{');
    for (const auto& [define, word] :
         std::map<std::string, std::string>(options.switches.rbegin(), options.switches.rend()))
        json.write(define, word.empty() ? "true" : word);
    json.end();
    json.begin("properties", '[');
    for (const VariantAxis& axis : plan.axes) {
        json.begin('{');
        json.write("name", axis.property);
        json.begin("values", '[');
        for (const std::string& word : axis.values) value(axis, word);
        json.end();
        json.write_key("default");
        value(axis, axis.values[axis.otherwise]);
        json.end();
    }
    json.end();
    json.begin("programs", '[');
    for (std::size_t i = 0; i < written.size(); ++i) {
        json.begin('{');
        json.write("program", written[i].hash);
        json.write("hash", set.programs[i].hash);
        json.write("reflection", written[i].reflection.file);
        if (wanted.file_hashes) json.write("reflectionHash", written[i].reflection.hash);
        json.write("files", written[i].files);
        json.end();
    }
    json.end();
    json.begin("combinations", '[');
    for (std::size_t i = 0; i < plan.count; ++i) {
        json.begin('{');
        json.begin("values", '{');
        for (const auto& [property, word] : plan.combination(i)) {
            const auto axis =
                std::find_if(plan.axes.begin(), plan.axes.end(),
                             [&, &wanted = property](const VariantAxis& each) { return each.property == wanted; });
            json.write_key(property);
            value(*axis, word);
        }
        json.end();
        json.write("program", written[set.program_of[i]].hash);
        json.end();
    }
    json.end();
    json.end();
    return json.take() + "\n";
}

}  // namespace

Exit make_variants(const Console& console, const Compiler& compiler, const std::string& graph,
                   const VariantOptions& wanted, const CompileOptions& options, const std::string& folder,
                   const AddShader& add, OutputFiles& files, FilesRead& read) {
    const auto looking = [&](const VariantPlan& plan) {
        const double most = combinations_of(plan.axes);
        if (plan.count == 0 && !plan.axes.empty()) remark(console, graph + ": at most " + announcement(plan, most));
        show_progress(console, plan.count, static_cast<std::size_t>(std::min(most, static_cast<double>(kMostVariants))),
                      graph);
    };
    VariantPlan plan = compiler.plan_variants(graph, wanted_of(wanted.wanted), options, wanted.limit, looking);
    // The library does not know how its caller gives values and limits.
    Diagnostic advice;
    advice.severity = Severity::Note;
    advice.message = "-D NAME=VALUE sets a property, and --variants-limit sets the limit";
    for (Diagnostic& each : plan.diagnostics)
        if (each.code == "too-many") each.notes.push_back(advice);
    name_graph(plan.diagnostics, graph);
    end_progress(console);
    report(console, plan.diagnostics);
    if (!plan.ok) return Exit::Wrong;
    const std::string name = output_name(graph);
    const bool is_counted = wanted.wanted == to_string(VariantsWanted::Reachable) && !plan.axes.empty();
    remark(console, graph + ": " +
                        (is_counted ? counted(plan.count, "combination") + " can be reached"
                                    : announcement(plan, static_cast<double>(plan.count))));
    VariantSet set = compiler.compile_variants(
        graph, plan, options, [&](std::size_t done) { show_progress(console, done, plan.count, graph); });
    name_graph(set.diagnostics, graph);
    end_progress(console);
    report(console, set.diagnostics);
    if (!set.ok) return Exit::Wrong;

    ShortHashes programs, stages;
    std::map<std::string, std::vector<WrittenFile>> files_of;  // by a stage's file name and hash
    std::vector<Written> written;
    OutputFiles reflections;  // a file comes after those that it lists
    for (VariantProgram& program : set.programs) {
        Written& made = written.emplace_back();
        made.hash = programs.name(program.hash);
        // A file that holds all programs, as Unity's does, has no hash in its name.
        const bool is_hashed = std::any_of(program.result.shaders.begin(), program.result.shaders.end(),
                                           [](const Shader& s) { return !s.hash.empty(); });
        made.reflection.file = with_hash(name + wanted.kind + ".reflect.json", name, is_hashed ? made.hash : "");
        for (Shader& shader : program.result.shaders) {
            const std::string compiled = shader.file_name;
            const auto [own, is_new] = files_of.try_emplace(shader.file_name + shader.hash);
            if (is_new) {
                shader.file_name = with_hash(shader.file_name, name, stages.name(shader.hash));
                OutputFiles added;
                if (!add(shader, added)) return Exit::Wrong;
                own->second = written_files(added, wanted.file_hashes);
                std::ranges::move(added.files, std::back_inserter(files.files));
            }
            list_files(program.result.reflection, shader, compiled, own->second);
            for (const WrittenFile& each : own->second) made.files.push_back(each.file);
        }
        std::string text = program.result.reflection.to_json();
        if (wanted.file_hashes) made.reflection.hash = file_hash(text);
        reflections.add(join_path(folder, made.reflection.file), std::move(text));
    }
    std::ranges::move(reflections.files, std::back_inserter(files.files));
    remark(console, fmt::format("{}: {} in {}", graph, counted(set.programs.size(), "different program"),
                                counted(files_of.size(), "shader")));
    files.add(join_path(folder, name + wanted.kind + ".variants.json"),
              manifest(name, wanted, options, plan, set, written));
    read = {.dependencies = std::move(set.dependencies), .missing = std::move(set.missing)};
    return Exit::Ok;
}

}  // namespace patina::cli
