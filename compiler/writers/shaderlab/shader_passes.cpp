// Joins both stages of a pass into the declarations of one program. A name has one meaning in it: if the stages differ,
// the vertex stage's declaration gets another name.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "compiler/base/letters.h"
#include "compiler/base/spelling.h"
#include "compiler/ir/verify.h"
#include "compiler/writers/shaderlab/dialect.h"
#include "compiler/writers/shaderlab/share_samplers.h"

namespace patina::writers::shaderlab {
namespace {

using Declaration = PassText::Declaration;
using Kind = languages::Piece::Kind;

constexpr std::size_t kIndent = 12;  // indentation of a pass's text in the file

// Variables that UNITY_LIGHT_ATTENUATION and UNITY_APPLY_FOG declare. They do not matter to members.
constexpr const char* kLocals[] = {"lightCoord", "shadow", "unityFogFactor"};

std::vector<Declaration> declarations(const languages::Printed& printed) {
    std::vector<Declaration> made;
    for (const languages::Piece& piece : printed.pieces) {
        Declaration& next = made.emplace_back();
        next.kind = piece.kind;
        next.name = piece.name;
        next.text = printed.text.substr(piece.begin, piece.end - piece.begin);
        const int count = static_cast<int>(std::count(next.text.begin(), next.text.end(), '\n'));
        ir::OriginId before{};
        for (const languages::PrintedLine& line : printed.lines) {
            if (line.line <= piece.line) before = line.origin;
            if (line.line > piece.line && line.line < piece.line + count)
                next.lines.push_back({.line = line.line - piece.line, .origin = line.origin});
        }
        next.lines.insert(next.lines.begin(), {.line = 0, .origin = before});
    }
    return made;
}

// A name with another meaning outside the pass gets the pass's name added.
void rename(ir::Module& stage, const std::vector<std::string>& taken, std::string_view pass) {
    const auto rename_if_taken = [&](std::string& name) {
        if (std::find(taken.begin(), taken.end(), name) != taken.end()) name = joined(name, camel_case(pass));
    };
    for (ir::Function& function : stage.functions) rename_if_taken(function.name);
    for (ir::Struct& structure : stage.structs) rename_if_taken(structure.name);
}

bool is_unsigned(ir::Type type) {
    return type.is_numeric() && type.scalar == ir::Scalar::Uint;
}

// Notes what shader model 3.0 lacks.
void note_modern(const ir::Module& stage, PassText& pass) {
    using ir::Builtin;
    const auto is_modern_input = [](const ir::StageVariable& input) {
        return input.builtin == Builtin::FrontFacing || input.builtin == Builtin::VertexIndex ||
               input.builtin == Builtin::InstanceIndex || is_unsigned(input.type);
    };
    const auto is_modern_inst = [](const ir::Inst& inst) {
        return inst.op == ir::Op::TexelLoad || inst.op == ir::Op::TextureSize || is_unsigned(inst.type) ||
               inst.type.kind == ir::Kind::Texture2DArray;
    };
    const auto& inputs = stage.stage.inputs;
    pass.is_modern |= std::any_of(inputs.begin(), inputs.end(), is_modern_input);
    for (const ir::Function& function : stage.functions) {
        if (std::none_of(function.insts.begin(), function.insts.end(), is_modern_inst)) continue;
        if (stage.stage.entry && &function == &stage[stage.stage.entry])
            pass.is_modern = true;
        else
            pass.modern_functions.push_back(function.name);
    }
}

std::vector<Declaration> printed(ir::Module stage, PassText& pass, const languages::TakenNames& engine_names,
                                 const std::vector<std::string>& taken) {
    stage.stage.texts = pass.texts;
    stage = legalize(std::move(stage));
    ir::check_if_verifying(stage, "legalized");
    note_modern(stage, pass);
    return declarations(
        print(stage, {.header = {}, .taken = &engine_names, .also_taken = taken, .width = 120 - kIndent}));
}

const Declaration* find(const std::vector<Declaration>& list, const std::string& name) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const Declaration& d) { return d.name == name; });
    return found == list.end() ? nullptr : &*found;
}

bool is_entry(const Declaration& each) {
    return each.kind == Kind::Entry;
}

}  // namespace

std::string_view name_of(const LinkedPass& pass) {
    const paths::PassDecl& declared = *pass.pass->declaration;
    const auto tag =
        std::find_if(declared.tags.begin(), declared.tags.end(), [](const auto& each) { return each.first == "Name"; });
    const bool is_added = pass.pass->name != declared.name;
    return is_added || tag == declared.tags.end() ? std::string_view(pass.pass->name) : std::string_view(tag->second);
}

bool mentions(std::string_view text, std::string_view name) {
    const auto is_comment = [&](std::size_t at) {
        const std::size_t begin = text.rfind('\n', at) + 1;
        return text.substr(std::min(text.find_first_not_of(' ', begin), text.size())).starts_with("//");
    };
    for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        const bool is_whole =
            (at == 0 || !is_word_letter(text[at - 1])) && (end == text.size() || !is_word_letter(text[end]));
        if (is_whole && !is_comment(at)) return true;
    }
    return false;
}

languages::TakenNames taken_names(const engines::Names& names) {
    languages::TakenNames made{
        .names = {names.taken.begin(), names.taken.end()}, .macros = {}, .prefixes = names.prefixes};
    made.names.insert(names.own.begin(), names.own.end());
    made.macros = made.names;
    for (const char* local : kLocals) made.macros.erase(local);
    return made;
}

PassText pass_text(const LinkedPass& pass, const engines::Engine& engine, const languages::TakenNames& engine_names,
                   const SamplerUse& samplers, const std::vector<std::string>& taken_around) {
    PassText made;
    made.texts = texts_of(pass);
    const auto named = [&](ir::Module stage) {
        for (ir::Function& function : stage.functions) {
            if (function.linkage != ir::Linkage::Foreign) function.name = engine.function_name(function.name);
        }
        rename(stage, taken_around, name_of(pass));
        share_samplers(stage, samplers);
        return stage;
    };
    const std::vector<Declaration> fragment = printed(named(pass.fragment), made, engine_names, taken_around);
    std::vector<Declaration> vertex;
    std::vector<std::string> taken = taken_around;
    for (bool differ = true; differ;) {
        differ = false;
        vertex = printed(named(pass.vertex), made, engine_names, taken);
        for (const Declaration& each : vertex) {
            const Declaration* other = find(fragment, each.name);
            if (!other || other->text == each.text) continue;
            taken.push_back(each.name);
            differ = true;
        }
    }
    for (Declaration& each : vertex) {
        for (languages::PrintedLine& line : each.lines) {
            if (line.origin) line.origin.index += static_cast<std::uint32_t>(pass.fragment.origins.size());
        }
    }
    for (const Kind kind : {Kind::Uniform, Kind::Struct, Kind::Function}) {
        for (const auto* stage : std::array{&fragment, &std::as_const(vertex)}) {
            for (const Declaration& each : *stage) {
                if (each.kind == kind && !find(made.declarations, each.name)) made.declarations.push_back(each);
            }
        }
    }
    for (const auto* stage : std::array{&std::as_const(vertex), &fragment}) {
        for (const Declaration& each : *stage) {
            if (is_entry(each)) made.declarations.push_back(each);
        }
    }
    const std::string& entry = std::find_if(vertex.begin(), vertex.end(), is_entry)->text;
    for (Declaration& each : made.declarations)
        each.is_of_vertex = each.text == entry || (each.kind == Kind::Struct && entry.starts_with(each.name + " "));
    return made;
}

}  // namespace patina::writers::shaderlab
