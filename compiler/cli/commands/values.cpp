// patina values: what graphs and shaders read of mesh, camera, engine and lights.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/pages/library_json.h"
#include "compiler/cli/pages/page.h"
#include "patina/engine_values.h"

namespace patina::cli {
namespace {

struct Row {
    std::string name, type, text;
};

void print_rows(const Console& console, std::string_view title, std::span<const Row> rows) {
    if (rows.empty()) return;
    std::size_t name_width = 0, type_width = 0;
    for (const Row& row : rows) {
        name_width = std::max(name_width, row.name.size());
        type_width = std::max(type_width, row.type.size());
    }
    print(fmt::format("{}\n", heading(console, title)));
    for (const Row& row : rows) {
        print(fmt::format("  {:<{}}  {:<{}}  {}\n", row.name, name_width, row.type, type_width, row.text));
    }
    print("\n");
}

void print_semantics(const Console& console, const Compiler& compiler) {
    struct Rate {
        std::string_view name, title;
    };
    static constexpr Rate kRates[] = {
        {"vertex", "Semantics of the mesh"},
        {"pixel", "Semantics of the pixel"},
        {"uniform", "Semantics of the frame and of the object"},
        {"lighting", "Semantics of lighting graphs"},
    };
    for (const Rate& rate : kRates) {
        std::vector<Row> rows;
        for (const SemanticInfo& semantic : compiler.semantics()) {
            if (semantic.rate != rate.name) continue;
            rows.push_back({"@" + semantic.name, semantic.type, first_sentence(semantic.doc)});
        }
        print_rows(console, rate.title, rows);
    }
}

// "position (m; world; only with fog)"
std::string text_of(const EngineValueInfo& value) {
    std::vector<std::string> facts;
    if (!value.unit.empty()) facts.push_back(value.unit);
    if (!value.space.empty()) facts.push_back(value.space);
    if (!value.with.empty()) facts.push_back(fmt::format("only with {}", fmt::join(value.with, ", ")));
    const std::string text = first_sentence(value.doc);
    return facts.empty() ? text : fmt::format("{} ({})", text, fmt::join(facts, "; "));
}

Exit list_values(const Console& console, bool json) {
    const Compiler compiler;
    const std::vector<EngineBlockInfo> blocks = engine_blocks(compiler);
    if (json) {
        print(to_json(compiler.semantics(), blocks));
        return Exit::Ok;
    }
    print_semantics(console, compiler);
    for (const EngineBlockInfo& block : blocks) {
        std::vector<Row> rows;
        for (const EngineValueInfo& value : block.values) rows.push_back({value.name, value.type, text_of(value)});
        print_rows(console, block.name.empty() ? "Textures of the engine" : "Block " + block.name, rows);
    }
    return Exit::Ok;
}

}  // namespace

void add_values(Program& program) {
    CLI::App& command = add_command(program, "values", {"patina values", "patina values --json"});
    auto json = std::make_shared<bool>(false);
    command.add_flag("--json", *json, "Print everything about each value as JSON");
    set_work(program, command, [json](const Console& console) { return list_values(console, *json); });
}

}  // namespace patina::cli
