// [foreign] functions whose body is text that the node language does not read.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/letters.h"
#include "compiler/emit/functions.h"

namespace patina::emit {
namespace {

// Behind the comment, the string, the number or the word at `at`, or else behind one character.
std::size_t behind(std::string_view text, std::size_t at) {
    const auto end = [&](std::string_view what, std::size_t from) {
        const std::size_t found = text.find(what, from);
        return found == text.npos ? text.size() : found + what.size();
    };
    if (text.substr(at).starts_with("//")) return end("\n", at);
    if (text.substr(at).starts_with("/*")) return end("*/", at + 2);
    if (text[at] == '"') return end("\"", at + 1);
    if (!is_word_letter(text[at])) return at + 1;
    while (at < text.size() && is_word_letter(text[at])) ++at;
    return at;
}

// Calls `take(text, is_word)` for each part of the text, in order: words and what is between them.
template <class Take>
void each_part(std::string_view text, const Take& take) {
    std::size_t begin = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = behind(text, at);
        if (is_word_start(text[at])) {
            if (at > begin) take(text.substr(begin, at - begin), false);
            take(text.substr(at, end - at), true);
            begin = end;
        }
        at = end;
    }
    if (begin < text.size()) take(text.substr(begin), false);
}

// The lines of a body without the empty ones around them; a body of one line is indented.
std::string lines_of(std::string_view body) {
    std::string text;
    for (const char c : body)
        if (c != '\r') text += c;
    const std::size_t first = text.find_first_not_of(" \t\n");
    if (first == text.npos) return {};
    const std::size_t line = text.rfind('\n', first);
    const std::size_t last = text.find_last_not_of(" \t\n");
    return line == text.npos ? "    " + text.substr(first, last + 1 - first) : text.substr(line + 1, last - line);
}

class CodeText {
public:
    explicit CodeText(const Declarations& home) : home_(home) {}

    ir::ForeignCode run(const FunctionDecl& function) {
        find_helpers(function);
        for (std::size_t i = 0; i < helpers_.size(); ++i) {
            print(*helpers_[i], static_cast<std::uint32_t>(i + 1), false);
            add("\n");
        }
        print(function, ir::ForeignCode::kOwn, true);
        for (const FunctionDecl* helper : helpers_) made_.helpers.emplace_back(helper->name);
        return std::move(made_);
    }

private:
    const FunctionDecl* foreign(std::string_view name) const {
        const FunctionDecl* found = home_.function(name);
        return found && found->marks.is_foreign && found->has_body ? found : nullptr;
    }

    // In the order of their file: as in any file of that language, a function comes before its callers.
    void find_helpers(const FunctionDecl& function) {
        std::vector<const FunctionDecl*> found = {&function};
        for (std::size_t i = 0; i < found.size(); ++i) {
            each_part(found[i]->code, [&](std::string_view word, bool is_word) {
                const FunctionDecl* named = is_word ? foreign(word) : nullptr;
                if (named && std::find(found.begin(), found.end(), named) == found.end()) found.push_back(named);
            });
        }
        helpers_.assign(found.begin() + 1, found.end());
        std::sort(helpers_.begin(), helpers_.end(),
                  [](const FunctionDecl* a, const FunctionDecl* b) { return a->name_span.begin < b->name_span.begin; });
    }

    void add(std::string_view text) {
        if (made_.parts.empty() || made_.parts.back().name != ir::ForeignCode::kEnd) made_.parts.emplace_back();
        made_.parts.back().text += text;
    }
    void add_name(std::uint32_t name) {
        add("");
        made_.parts.back().name = name;
    }

    void print(const FunctionDecl& function, std::uint32_t name, bool outputs_last) {
        std::vector<const ParamDecl*> params;
        for (const ParamDecl& param : function.params) params.push_back(&param);
        if (outputs_last)
            std::stable_partition(params.begin(), params.end(), [](const ParamDecl* param) { return !param->is_out; });
        add(fmt::format("{} ", function.result.name));
        add_name(name);
        add("(");
        for (const ParamDecl* param : params)
            add(fmt::format("{}{}{} {}", param == params.front() ? "" : ", ", param->is_out ? "out " : "",
                            param->type.name, param->name));
        add(")\n{\n");
        each_part(lines_of(function.code), [&](std::string_view part, bool is_word) {
            const FunctionDecl* found = is_word ? foreign(part) : nullptr;
            const auto helper = std::find(helpers_.begin(), helpers_.end(), found);
            if (found && helper != helpers_.end())
                add_name(static_cast<std::uint32_t>(helper - helpers_.begin()) + 1);
            else
                add(part);
        });
        add("\n}\n");
    }

    const Declarations& home_;
    std::vector<const FunctionDecl*> helpers_{};
    ir::ForeignCode made_{};
};

}  // namespace

ir::ForeignCode foreign_code(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                             std::span<const ir::Type> types) {
    const auto bad = [&](Span span, std::string_view why) {
        emitter.diagnostics.report(Code::BadAttribute, span, "foreign", why);
    };
    std::size_t outputs = 0;
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const ParamDecl& param = function.params[i];
        outputs += param.is_out ? 1 : 0;
        if (!types[i].is_numeric() || param.is_const || param.type.name == "floatN")
            bad(param.span, "applies only to a function of numbers, vectors and matrices of fixed types");
    }
    if ((function.result.name == "void") == (outputs == 0))
        bad(function.name_span, "needs a function with either a result or out parameters, if it has a body");
    return CodeText(home).run(function);
}

bool needs_quad(const ir::ForeignCode& code) {
    constexpr std::string_view kWords[] = {"ddx", "ddy", "fwidth", "ddx_fine", "ddy_fine", "ddx_coarse", "ddy_coarse"};
    bool found = false;
    for (const ir::ForeignCode::Part& part : code.parts)
        each_part(part.text, [&](std::string_view word, bool is_word) {
            found = found || (is_word && std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords));
        });
    return found;
}

}  // namespace patina::emit
