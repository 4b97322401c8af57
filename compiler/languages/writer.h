// The growing text of one shader, and the parts that all its functions share: needed functions, types and globals, and
// their names. Function bodies are printed by body.h.
#pragma once

#include "compiler/languages/language.h"
#include "compiler/languages/names.h"
#include "compiler/languages/print.h"

namespace patina::languages {

// Everything that the entry function uses, indexed like the module's vectors. Nothing else is printed.
struct Reachable {
    std::vector<bool> functions, structs, blocks, globals;
    bool half = false;         // the type is used
    bool samplerless = false;  // a texture is read without a sampler
};
Reachable find_reachable(const ir::Module& module);

struct Writer {
    Writer(const ir::Module& module, const Language& language, const PrintOptions& options, Plans& plans)
        : module(module), language(language), options(options), plans(plans), names(options.taken) {}

    const ir::Module& module;
    const Language& language;
    const PrintOptions& options;
    Plans& plans;
    Reachable reachable;
    Names names;
    std::vector<std::string> functions, structs, blocks, globals;  // names, indexed like the module's vectors
    std::vector<std::vector<std::string>> helpers;                 // of functions: names for ForeignCode::helpers
    std::vector<std::vector<std::string>> members;                 // of structs
    std::vector<std::vector<std::string>> block_members;

    std::string text;
    int next_line = 1;
    std::vector<PrintedLine> lines;
    std::vector<Piece> pieces;
    std::vector<int> light_loops;
    int paddings = 0;

    // Prints one statement or declaration; breaks it after commas if it is too wide.
    void line(unsigned indent, std::string_view content, ir::OriginId origin = {});
    // Prints whole lines as they are.
    void verbatim(std::string_view lines, ir::OriginId origin = {});
    void comment(unsigned indent, std::string_view content, ir::OriginId origin = {});
    // Prints an empty line, unless there is one already or the text is empty.
    void gap();

    std::string type(ir::Type type) const;
    // "vec3 n", "float k[4]"
    // `form`: null: a local's
    std::string declaration(ir::Type type, std::string_view name, Syntax::Declaration form = nullptr) const;
    // The line of a member of a struct or a block.
    std::string member(ir::Type type, std::string_view name) const {
        return declaration(type, name, language.syntax->member).append(language.syntax->member_end);
    }
    // A name without the prefix of pasted texts.
    std::string_view plain(std::string_view name) const;
    // The value of a keyword until another one is set: "true", "2".
    std::string keyword_value(const ir::Global& global) const;
    // A descriptor set: "1", "space1", or its name.
    std::string set(ir::Group group, const ir::BindingPlace& place) const;
    // Prints the members of a uniform block between braces, with padding if the language needs it.
    void block_body(const ir::UniformBlock& block);
    // The type of a value in a uniform block or between stages, where `half` becomes float.
    static ir::Type stored(ir::Type type) {
        return type.is_numeric() && type.scalar == ir::Scalar::Half ? type.with_scalar(ir::Scalar::Float) : type;
    }
};

// The whole shader.
Printed print(const ir::Module& module, const Language& language, const PrintOptions& options);

}  // namespace patina::languages
