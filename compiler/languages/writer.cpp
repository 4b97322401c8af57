#include "compiler/languages/writer.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/ir/passes/passes.h"

namespace patina::languages {

using namespace ir;

namespace {

void mark_type(const Module& module, Type type, Reachable& reachable) {
    if (type.is_numeric()) reachable.half |= type.scalar == Scalar::Half;
    if (type.kind == Kind::Array) mark_type(module, module.arrays[type.ref].element, reachable);
    if (type.kind != Kind::Struct || reachable.structs[type.ref]) return;
    reachable.structs[type.ref] = true;
    for (const Member& member : module.structs[type.ref].members) mark_type(module, member.type, reachable);
}

// The struct that the entry function makes only to return it. Its members are the stage's outputs, so its type is not
// declared.
Value returned_construct(const Function& function) {
    const Inst& last = function[function.blocks[0].insts.back()];
    if (last.op != Op::Return || last.operand_count == 0) return {};
    const Value value = function.args(last)[0];
    const auto uses = std::count(function.operands.begin(), function.operands.end(), value);
    return function[value].op == Op::Construct && uses == 1 ? value : Value{};
}

void mark_keywords(const Module& module, const Function& function, Value v, std::vector<bool>& read) {
    const Inst& inst = function[v];
    if (inst.op == Op::Global && module.globals[inst.data].is_keyword()) read[inst.data] = true;
    for (const Value arg : function.args(inst)) mark_keywords(module, function, arg, read);
}

// Keywords that are read as values, in addition to tests of the preprocessor.
std::vector<bool> keywords_read(const Module& module, const Function& function) {
    std::vector<bool> read(module.globals.size(), false);
    const std::vector<std::uint8_t> tests = keyword_values(module, function);
    for (std::uint32_t i = 0; i < function.insts.size(); ++i) {
        const Inst& inst = function.insts[i];
        if (tests[i] != 0) continue;
        const auto args = function.args(inst);
        for (std::size_t k = 0; k < args.size(); ++k) {
            const bool is_test = inst.op == Op::If && k == 0;
            if (!is_test && tests[args[k].index] != 0) mark_keywords(module, function, args[k], read);
        }
    }
    return read;
}

void mark_function(const Module& module, const Function& function, bool is_entry, Reachable& reachable) {
    const std::vector<bool> keywords =
        module.tests_keywords ? keywords_read(module, function) : std::vector<bool>(module.globals.size(), true);
    const Value outputs = is_entry ? returned_construct(function) : Value{};
    if (!outputs) mark_type(module, function.result, reachable);
    for (const Param& param : function.params) mark_type(module, param.type, reachable);
    for (const Block& block : function.blocks) {
        for (Value v : block.insts) {
            const Inst& inst = function[v];
            if (v != outputs) mark_type(module, inst.type, reachable);
            if (inst.op == Op::Call) reachable.functions[inst.data] = true;
            if (inst.op == Op::TexelLoad || inst.op == Op::TextureSize) reachable.samplerless = true;
            if (inst.op != Op::Global || (module.globals[inst.data].is_keyword() && !keywords[inst.data])) continue;
            reachable.globals[inst.data] = true;
            if (module.globals[inst.data].in_block()) reachable.blocks[module.globals[inst.data].block] = true;
        }
    }
}

// Where a line that is too wide may be broken: after a comma that is not too near its beginning.
std::size_t break_of(std::string_view content, std::size_t room) {
    if (content.size() <= room) return content.size();
    const std::size_t comma = content.rfind(", ", room - 1);
    return comma == std::string_view::npos || comma < room / 4 ? content.size() : comma + 1;
}

void append_one_line(std::string& text, std::string_view content) {
    for (const char c : content) {
        const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
        // A backslash at the end would continue the comment into the next line.
        text += is_control ? ' ' : c == '\\' ? '/' : c;
    }
}

}  // namespace

Reachable find_reachable(const Module& module) {
    Reachable reachable;
    const FunctionId entry = module.stage.entry;
    reachable.functions.resize(module.functions.size(), !entry);
    reachable.structs.resize(module.structs.size());
    reachable.blocks.resize(module.blocks.size());
    reachable.globals.resize(module.globals.size());
    if (entry) reachable.functions[entry.index] = true;
    // Callees are printed before their callers.
    for (std::size_t i = module.functions.size(); i-- > 0;) {
        if (reachable.functions[i]) mark_function(module, module.functions[i], entry.index == i, reachable);
    }
    for (std::size_t i = 0; i < module.blocks.size(); ++i) {
        if (!reachable.blocks[i]) continue;
        for (const BlockMember& member : module.blocks[i].members) {
            if (!member.type.is_numeric()) mark_type(module, member.type, reachable);
        }
    }
    return reachable;
}

void Writer::line(unsigned indent, std::string_view content, OriginId origin) {
    if (lines.empty() ? static_cast<bool>(origin) : lines.back().origin != origin) lines.push_back({next_line, origin});
    for (unsigned extra = 0; !content.empty(); extra = 1) {
        const std::size_t margin = 4 * (indent + extra);
        const std::size_t end = break_of(content, options.width - std::min<std::size_t>(margin, options.width / 2));
        text.append(margin, ' ').append(content.substr(0, end)).append("\n");
        ++next_line;
        content.remove_prefix(end);
        content.remove_prefix(std::min(content.find_first_not_of(' '), content.size()));
    }
}

void Writer::comment(unsigned indent, std::string_view content, OriginId origin) {
    if (lines.empty() ? static_cast<bool>(origin) : lines.back().origin != origin) lines.push_back({next_line, origin});
    // A broken line continues with more indentation.
    const std::size_t lead = std::min(content.find_first_not_of(' '), content.size());
    const std::size_t margin = 4 * indent + 3;
    for (std::size_t hanging = 0;; hanging = lead > 0 ? lead + 2 : 0) {
        const std::size_t room = options.width - std::min(margin + hanging, options.width / 2);
        const std::size_t space = content.size() > room ? content.rfind(' ', room) : content.npos;
        const std::size_t end = space == content.npos || space < room / 2 ? content.size() : space;
        text.append(4 * indent, ' ').append(content.empty() ? "//" : "// ").append(hanging, ' ');
        append_one_line(text, content.substr(0, end));
        text += '\n';
        ++next_line;
        content.remove_prefix(std::min(end + 1, content.size()));
        if (content.empty()) return;
    }
}

void Writer::verbatim(std::string_view whole_lines, OriginId origin) {
    if (lines.empty() ? static_cast<bool>(origin) : lines.back().origin != origin) lines.push_back({next_line, origin});
    text += whole_lines;
    next_line += static_cast<int>(std::count(whole_lines.begin(), whole_lines.end(), '\n'));
}

void Writer::gap() {
    if (text.empty() || text.ends_with("\n\n")) return;
    text += '\n';
    ++next_line;
}

std::string Writer::type(Type type) const {
    switch (type.kind) {
        case Kind::Void: return "void";
        case Kind::Array:
            return fmt::format("{}[{}]", this->type(module.arrays[type.ref].element), module.arrays[type.ref].count);
        case Kind::Struct: return structs[type.ref];
        case Kind::Numeric:
        case Kind::Texture2D:
        case Kind::TextureCube:
        case Kind::Texture2DArray:
        case Kind::Texture3D:
        case Kind::Sampler: return language.type_name(type);
        case Kind::Error: return {};
    }
    return {};
}

std::string Writer::declaration(Type type, std::string_view name, Syntax::Declaration form) const {
    std::string sizes;
    for (; type.kind == Kind::Array; type = module.arrays[type.ref].element) {
        sizes += fmt::format("[{}]", module.arrays[type.ref].count);
    }
    return (form ? form : language.syntax->local)(this->type(type), name, sizes);
}

std::string_view Writer::plain(std::string_view name) const {
    if (options.pasting && name.starts_with(options.pasting->prefix))
        name.remove_prefix(options.pasting->prefix.size());
    return name;
}

std::string Writer::keyword_value(const Global& global) const {
    const double value = module.keywords[global.keyword].value;
    if (global.type == kBool) return value != 0 ? "true" : "false";
    return std::to_string(static_cast<int>(value));
}

std::string Writer::set(Group group, const BindingPlace& place) const {
    if (options.pasting && group == Group::Material) return options.pasting->set_name();
    return fmt::format("{}{}", language.set_word, place.set);
}

void Writer::block_body(const UniformBlock& block) {
    const auto index = static_cast<std::size_t>(&block - module.blocks.data());
    line(0, "{");
    for (std::size_t i = 0; i < block.members.size(); ++i) {
        for (std::uint32_t n = 0; language.pads_blocks && n < block.members[i].padding; ++n) {
            const std::string name =
                fmt::format("{}pad{}", options.pasting ? options.pasting->prefix : "_", paddings++);
            line(1, member(kFloat, names.declare(name)));
        }
        Type element = block.members[i].type;
        while (element.kind == Kind::Array) element = module.arrays[element.ref].element;
        const bool by_rows = block.matrices_by_rows && element.is_matrix();
        line(1, std::string(by_rows ? language.row_major : "") +
                    member(stored(block.members[i].type), block_members[index][i]));
    }
}

}  // namespace patina::languages
