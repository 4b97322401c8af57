// Prints the sections of a shader, in an order that is the same in every language.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/languages/body.h"

namespace patina::languages {

using namespace ir;

namespace {

void print_comment(Writer& w, std::string_view lines, OriginId origin) {
    while (!lines.empty()) {
        const std::size_t end = std::min(lines.find('\n'), lines.size());
        w.comment(0, lines.substr(0, end), origin);
        lines.remove_prefix(std::min(end + 1, lines.size()));
    }
}

void open_guard(Writer& w, const std::string& name, const std::string& value) {
    w.line(0, w.language.syntax->once(name));
    w.line(0, w.language.syntax->define(name, value));
}

// "0 Dry, 1 Wet"
std::string numbered(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) text += fmt::format("{}{} {}", i > 0 ? ", " : "", i, words[i]);
    return text;
}

// Takes all names of the outermost scope before the first function is printed, so that no local variable hides one.
void name_globals(Writer& w) {
    const Module& m = w.module;
    w.structs.resize(m.structs.size());
    w.members.resize(m.structs.size());
    w.blocks.resize(m.blocks.size());
    w.block_members.resize(m.blocks.size());
    w.globals.resize(m.globals.size());
    w.functions.resize(m.functions.size());
    w.helpers.resize(m.functions.size());
    for (const std::string& name : w.options.also_taken) w.names.declare(name);
    for (std::size_t i = 0; i < m.functions.size(); ++i) {
        if (m.functions[i].linkage != Linkage::Foreign || !w.reachable.functions[i]) continue;
        w.functions[i] = m.functions[i].name;
        w.names.declare(m.functions[i].name);
    }
    // Properties come first, because the reflection states their names.
    for (std::size_t i = 0; i < m.blocks.size(); ++i) {
        if (!w.reachable.blocks[i]) continue;
        for (const BlockMember& member : m.blocks[i].members) {
            w.block_members[i].push_back(member.declared_in.empty() ? w.names.declare(member.name) : member.name);
        }
    }
    for (std::size_t i = 0; i < m.globals.size(); ++i) {
        const Global& global = m.globals[i];
        if (!w.reachable.globals[i]) continue;
        if (!global.decoder.empty() && w.names.is_free(global.decoder)) w.names.declare(global.decoder);
        if (global.is_foreign()) {
            w.globals[i] = global.spelling;
            continue;
        }
        w.globals[i] = global.in_block() ? w.block_members[global.block][global.member] : w.names.declare(global.name);
    }
    for (std::size_t i = 0; i < m.blocks.size(); ++i) {
        if (w.reachable.blocks[i]) w.blocks[i] = w.names.declare(m.blocks[i].name);
    }
    for (std::size_t i = 0; i < m.structs.size(); ++i) {
        if (!w.reachable.structs[i]) continue;
        w.structs[i] = w.names.declare(m.structs[i].name);
        Names members(w.options.taken, Names::Of::Members);
        for (const Member& member : m.structs[i].members) w.members[i].push_back(members.declare(member.name));
    }
    for (std::size_t i = 0; i < m.functions.size(); ++i) {
        if (!w.reachable.functions[i]) continue;
        if (m.stage.entry.index != i && w.functions[i].empty()) w.functions[i] = w.names.declare(m.functions[i].name);
        // Named after their function: if the texts of several passes have the same function, the helpers have the same
        // names.
        for (const std::string& helper : m.functions[i].code.helpers)
            w.helpers[i].push_back(w.names.declare(w.functions[i] + "_" + helper));
    }
}

// Everything that `print` prints is one declaration.
template <class Print>
void print_piece(Writer& w, Piece::Kind kind, std::string name, const Print& print) {
    Piece piece{.kind = kind, .name = std::move(name), .begin = w.text.size(), .line = w.next_line};
    print();
    piece.end = w.text.size();
    if (piece.end > piece.begin) w.pieces.push_back(std::move(piece));
}

void print_members(Writer& w, std::size_t index, bool is_shared) {
    if (is_shared) open_guard(w, "PATINA_" + w.structs[index], "");
    const Syntax& syntax = *w.language.syntax;
    const std::vector<Member>& members = w.module.structs[index].members;
    const auto member = [&](Type type, std::string_view name) { w.line(1, w.member(type, name)); };
    w.line(0, syntax.open_struct(w.structs[index]));
    w.line(0, "{");
    for (std::size_t i = 0; i < members.size(); ++i) member(members[i].type, w.members[index][i]);
    // GLSL has no empty structs.
    if (members.empty()) member(kFloat, "nothing");
    w.line(0, syntax.close_struct);
    if (is_shared) w.line(0, syntax.end_guard);
}

// Prints a struct after the structs of its members. A struct of the engine is declared once, even if several texts are
// pasted into a shader.
void print_struct(Writer& w, std::size_t index, const std::vector<bool>& shared, std::vector<bool>& printed) {
    if (printed[index]) return;
    printed[index] = true;
    const Struct& structure = w.module.structs[index];
    for (const Member& member : structure.members) {
        Type type = member.type;
        while (type.kind == Kind::Array) type = w.module.arrays[type.ref].element;
        if (type.kind == Kind::Struct) print_struct(w, type.ref, shared, printed);
    }
    w.gap();
    print_piece(w, Piece::Kind::Struct, w.structs[index], [&] { print_members(w, index, shared[index]); });
}

// Declares what the engine provides. Repeated declarations of a function are allowed.
void print_declarations(Writer& w) {
    bool is_first = true;
    for (std::uint32_t i = 0; i < w.module.functions.size(); ++i) {
        if (!w.reachable.functions[i] || w.module.functions[i].linkage != Linkage::External) continue;
        w.gap();
        if (is_first) w.comment(0, "The engine provides these functions.");
        is_first = false;
        print_comment(w, w.module.functions[i].comment, {});
        Body(w, {i}, nullptr).print_declaration();
    }
}

void print_keyword(Writer& w, GlobalId id) {
    const Global& global = w.module.globals[id.index];
    const std::vector<std::string>& words = w.module.keywords[global.keyword].values;
    if (!words.empty()) w.comment(0, fmt::format("{}: {}", w.plain(global.name), numbered(words)));
    w.language.keyword(w, id);
}

void print_globals(Writer& w) {
    std::vector<bool> printed(w.module.structs.size());
    const std::vector<bool> shared = shared_structs(w.module);
    for (const bool is_shared : {true, false}) {
        for (std::size_t i = 0; i < printed.size(); ++i) {
            if (w.reachable.structs[i] && shared[i] == is_shared) print_struct(w, i, shared, printed);
        }
        if (is_shared) print_declarations(w);
    }
    for (std::size_t i = 0; i < w.module.blocks.size(); ++i) {
        if (!w.reachable.blocks[i]) continue;
        w.gap();
        print_piece(w, Piece::Kind::Uniform, w.blocks[i], [&] { w.language.block(w, w.module.blocks[i]); });
    }
    w.gap();
    for (std::uint32_t i = 0; i < w.module.globals.size(); ++i) {
        const Global& global = w.module.globals[i];
        if (!w.reachable.globals[i] || global.in_block() || global.is_foreign()) continue;
        print_piece(w, Piece::Kind::Uniform, w.globals[i], [&] {
            if (global.is_keyword())
                print_keyword(w, {i});
            else
                w.language.resource(w, {i});
        });
    }
}

// "vert" of "v2f vert(appdata_full v)"
std::string_view function_name(std::string_view signature) {
    const std::string_view before = signature.substr(0, signature.find('('));
    return before.substr(before.rfind(' ') + 1);
}

void print_function(Writer& w, FunctionId id, const EntryPoint* entry) {
    w.gap();
    print_piece(w, entry ? Piece::Kind::Entry : Piece::Kind::Function,
                entry ? std::string(function_name(entry->signature)) : w.functions[id.index], [&] {
                    const Function& function = w.module[id];
                    print_comment(w, function.comment, function.origin);
                    if (function.linkage == Linkage::Verbatim)
                        Body(w, id, nullptr).print_verbatim();
                    else
                        Body(w, id, entry).print();
                });
}

// A shader that pasted text goes into has its own preamble.
void print_preamble(Writer& w) {
    if (!w.options.pasting) return w.language.preamble(w);
    Writer lines(w.module, w.language, w.options, w.plans);
    lines.reachable = w.reachable;
    w.language.preamble(lines);
    if (!lines.text.empty()) print_comment(w, "The shader around it begins with:\n" + lines.text, {});
    if (std::none_of(w.module.globals.begin(), w.module.globals.end(), [&](const Global& global) {
            return w.reachable.globals[static_cast<std::size_t>(&global - w.module.globals.data())];
        }))
        return;
    w.gap();
    w.comment(0, "Another descriptor set, if it is defined before.");
    const Pasting& pasting = *w.options.pasting;
    open_guard(w, pasting.set_name(), fmt::format("{}{}", w.language.set_word, pasting.set));
    w.line(0, w.language.syntax->end_guard);
}

}  // namespace

Printed print(const Module& module, const Language& language, const PrintOptions& options) {
    Plans own(module);
    Writer w(module, language, options, options.plans ? *options.plans : own);
    w.reachable = find_reachable(module);
    name_globals(w);

    print_comment(w, options.header, {});
    print_preamble(w);
    print_globals(w);
    w.gap();
    const EntryPoint entry = module.stage.entry ? language.entry_point(w) : EntryPoint{};
    for (std::uint32_t i = 0; i < module.functions.size(); ++i) {
        const bool is_here = w.reachable.functions[i] &&
                             (!is_elsewhere(module.functions[i]) || module.functions[i].linkage == Linkage::Verbatim);
        if (is_here && module.stage.entry.index != i) print_function(w, {i}, nullptr);
    }
    if (module.stage.entry) print_function(w, module.stage.entry, &entry);
    return {std::move(w.text), std::move(w.lines), std::move(w.pieces), std::move(w.light_loops)};
}

}  // namespace patina::languages
