// The order of a shader's sections, which is the same in every language.
#include "compiler/targets/body.h"

namespace patina::targets {

using namespace ir;

namespace {

// All names of the outermost scope are taken before the first function is printed, so that no local hides one.
void name_globals(Writer& w) {
    const Module& m = w.module;
    w.structs.resize(m.structs.size());
    w.members.resize(m.structs.size());
    w.blocks.resize(m.blocks.size());
    w.block_members.resize(m.blocks.size());
    w.globals.resize(m.globals.size());
    w.functions.resize(m.functions.size());
    // Properties first: their names are what the reflection says.
    for (std::size_t i = 0; i < m.blocks.size(); ++i) {
        if (!w.reachable.blocks[i]) continue;
        for (const BlockMember& member : m.blocks[i].members) {
            w.block_members[i].push_back(w.names.declare(member.name));
        }
    }
    for (std::size_t i = 0; i < m.globals.size(); ++i) {
        const Global& global = m.globals[i];
        if (!w.reachable.globals[i]) continue;
        w.globals[i] = global.in_block() ? w.block_members[global.block][global.member] : w.names.declare(global.name);
    }
    for (std::size_t i = 0; i < m.blocks.size(); ++i) {
        if (w.reachable.blocks[i]) w.blocks[i] = w.names.declare(m.blocks[i].name);
    }
    for (std::size_t i = 0; i < m.structs.size(); ++i) {
        if (!w.reachable.structs[i]) continue;
        w.structs[i] = w.names.declare(m.structs[i].name);
        Names members;
        for (const Member& member : m.structs[i].members) w.members[i].push_back(members.declare(member.name));
    }
    for (std::size_t i = 0; i < m.functions.size(); ++i) {
        if (w.reachable.functions[i] && m.stage.entry.index != i) w.functions[i] = w.names.declare(m.functions[i].name);
    }
}

// A struct stands after those that its members are made of.
void print_struct(Writer& w, std::size_t index, std::vector<bool>& printed) {
    if (printed[index]) return;
    printed[index] = true;
    const Struct& structure = w.module.structs[index];
    for (const Member& member : structure.members) {
        Type type = member.type;
        while (type.kind == Kind::Array) type = w.module.arrays[type.ref].element;
        if (type.kind == Kind::Struct) print_struct(w, type.ref, printed);
    }
    w.gap();
    w.line(0, "struct " + w.structs[index]);
    w.line(0, "{");
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        w.line(1, w.declaration(structure.members[i].type, w.members[index][i]) + ";");
    }
    // GLSL has no empty structs.
    if (structure.members.empty()) w.line(1, w.declaration(kFloat, "nothing") + ";");
    w.line(0, "};");
}

void print_globals(Writer& w) {
    std::vector<bool> printed(w.module.structs.size());
    for (std::size_t i = 0; i < printed.size(); ++i) {
        if (w.reachable.structs[i]) print_struct(w, i, printed);
    }
    for (std::size_t i = 0; i < w.module.blocks.size(); ++i) {
        if (!w.reachable.blocks[i]) continue;
        w.gap();
        w.language.block(w, w.module.blocks[i]);
    }
    w.gap();
    for (std::uint32_t i = 0; i < w.module.globals.size(); ++i) {
        if (w.reachable.globals[i] && !w.module.globals[i].in_block()) w.language.resource(w, {i});
    }
}

void print_function(Writer& w, FunctionId id, const EntryPoint* entry) {
    w.gap();
    const Function& function = w.module[id];
    if (!function.comment.empty()) w.comment(0, function.comment, function.origin);
    Body(w, id, entry).print();
}

void print_header(Writer& w) {
    std::string_view header = w.options.header;
    while (!header.empty()) {
        const std::size_t end = std::min(header.find('\n'), header.size());
        w.comment(0, header.substr(0, end));
        header.remove_prefix(std::min(end + 1, header.size()));
    }
}

}  // namespace

Printed print(const Module& module, const Language& language, const PrintOptions& options) {
    std::vector<Plan> own;
    if (options.plans == nullptr) own = make_plans(module);
    Writer w(module, language, options, options.plans ? *options.plans : own);
    w.reachable = find_reachable(module);
    name_globals(w);

    print_header(w);
    language.preamble(w);
    print_globals(w);
    w.gap();
    const EntryPoint entry = module.stage.entry ? language.entry_point(w) : EntryPoint{};
    for (std::uint32_t i = 0; i < module.functions.size(); ++i) {
        if (w.reachable.functions[i] && module.stage.entry.index != i) print_function(w, {i}, nullptr);
    }
    if (module.stage.entry) print_function(w, module.stage.entry, &entry);
    return {std::move(w.text), std::move(w.lines)};
}

}  // namespace patina::targets
