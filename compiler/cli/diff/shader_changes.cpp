#include <algorithm>
#include <filesystem>
#include <functional>
#include <tuple>
#include <utility>

#include "compiler/cli/diff/report.h"
#include "patina/cost.h"

namespace patina::cli {
namespace {

auto key_of(const Shader& shader) {
    return std::tie(shader.pass, shader.stage, shader.target);
}

StageCost cost_of(const Shader& shader) {
    const bool is_stage = shader.has_main && shader.target.engine.empty();
    return is_stage ? measure(shader) : StageCost{};
}

ShaderChange change_of(const Shader& shader) {
    return {.pass = shader.pass, .stage = shader.stage, .target = shader.target};
}

// The errors of a text that was compiled as `alias` are those of `path`.
void rename_file(std::vector<Diagnostic>& diagnostics, const std::string& alias, const std::string& path) {
    for (Diagnostic& each : diagnostics) {
        if (each.file == alias) each.file = path;
        rename_file(each.notes, alias, path);
    }
}

}  // namespace

bool add_shader_changes(const Compiler& compiler, const Version& before, const Version& after,
                        const CompileOptions& options, DiffReport& report, std::vector<Diagnostic>& diagnostics) {
    CompileOptions compile = options;
    compile.hashes = true;
    compile.accept_parts = true;
    const Result old_result = compiler.compile_text(before.path, before.text, compile);
    // A shader has the name of its graph in a comment: both get that of the old file, each in its own folder.
    namespace fs = std::filesystem;
    const std::string new_path =
        (fs::path(after.path).parent_path() / fs::path(before.path).filename()).generic_string();
    Result new_result = compiler.compile_text(new_path, after.text, compile);
    rename_file(new_result.diagnostics, new_path, after.path);
    for (const Result& result : {std::cref(old_result), std::cref(std::as_const(new_result))}) {
        if (!result.ok) diagnostics.insert(diagnostics.end(), result.diagnostics.begin(), result.diagnostics.end());
    }
    if (!old_result.ok || !new_result.ok) return false;
    report.has_shaders = true;

    const auto find = [](const Result& result, const Shader& like) {
        return std::ranges::find_if(result.shaders, [&](const Shader& each) { return key_of(each) == key_of(like); });
    };
    for (const Shader& shader : old_result.shaders) {
        const auto other = find(new_result, shader);
        ShaderChange change = change_of(shader);
        if (other == new_result.shaders.end()) {
            change.is_there = false;
            change.before = cost_of(shader);
        } else if (other->text == shader.text) {
            continue;
        } else {
            change.lines = differences(shader.text, other->text);
            change.computes_same = !shader.hash.empty() && shader.hash == other->hash;
            if (!change.computes_same) {
                change.before = cost_of(shader);
                change.after = cost_of(*other);
            }
        }
        report.shaders.push_back(std::move(change));
    }
    for (const Shader& shader : new_result.shaders) {
        if (find(old_result, shader) != old_result.shaders.end()) continue;
        ShaderChange change = change_of(shader);
        change.was_there = false;
        change.after = cost_of(shader);
        report.shaders.push_back(std::move(change));
    }
    return true;
}

}  // namespace patina::cli
