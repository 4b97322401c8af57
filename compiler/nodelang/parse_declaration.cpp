// Parses declarations: everything in a file outside functions, and their types, attributes and parameters.
#include <algorithm>

#include "compiler/nodelang/hlsl/jumps.h"
#include "compiler/nodelang/parser.h"

namespace patina::nodelang {
namespace {

// The attributes of each kind of declaration. ([light] is an attribute of loops.)
constexpr std::string_view kFunction = "a function", kParameter = "a parameter", kVariable = "a variable",
                           kMember = "a member";
struct AttributeInfo {
    std::string_view place, name;
    bool has_arguments = true;
};
constexpr AttributeInfo kAttributes[] = {
    {kFunction, "node"},
    {kFunction, "also"},
    {kFunction, "is"},
    {kFunction, "member", false},
    {kFunction, "semantic"},
    {kFunction, "extern"},
    {kFunction, "range"},
    {kFunction, "inline", false},
    {kFunction, "inFloat", false},
    {kFunction, "hlsl", false},
    // Functions that passes call, and how the slots among them are derived.
    {kFunction, "slot", false},
    {kFunction, "part"},
    {kFunction, "without"},
    {kFunction, "pack"},
    {kFunction, "unpack"},
    {kFunction, "otherwise"},
    // Functions for an engine that draws with its own shaders.
    {kFunction, "export"},
    // A pass and how it draws.
    {kFunction, "pass"},
    {kFunction, "vertex", false},
    {kFunction, "fragment", false},
    {kFunction, "gives"},
    {kFunction, "draws"},
    {kFunction, "each"},
    {kFunction, "lights"},
    {kFunction, "camera"},
    {kFunction, "fallback"},
    {kFunction, "cull"},
    {kFunction, "blend"},
    {kFunction, "depth"},
    {kFunction, "depthTarget"},
    {kFunction, "depthBias"},
    {kFunction, "stencil"},
    {kFunction, "target"},
    {kFunction, "optional"},
    {kFunction, "extra"},
    {kFunction, "alone"},
    {kFunction, "along"},
    {kFunction, "needs"},
    {kFunction, "holds"},
    {kFunction, "excludes"},
    {kFunction, "lacks"},
    // What every pass does while a switch is on.
    {kFunction, "wraps"},
    {kFunction, "with"},
    // Values, functions and lines of an engine's own file.
    {kFunction, "foreign"},
    {kFunction, "decodes"},
    {kFunction, "lighting"},
    {kFunction, "tag"},
    {kFunction, "text"},
    {kFunction, "perObject", false},
    {kParameter, "also"},
    {kParameter, "range"},
    {kParameter, "color", false},
    {kParameter, "unit"},
    {kParameter, "hidden", false},
    {kParameter, "is"},
    {kParameter, "perLight", false},
    {kVariable, "attribute", false},
    {kVariable, "extern"},
    {kVariable, "with"},
    {kVariable, "reads"},
    {kVariable, "builtin"},
    {kVariable, "semantic"},
    {kVariable, "given", false},
    {kVariable, "static"},
    {kVariable, "switch"},
    {kVariable, "otherwise"},
    {kVariable, "perObject", false},
    {kVariable, "vertexOutput", false},
    {kVariable, "uv", false},
    {kVariable, "foreign"},
    {kVariable, "text"},
    {kVariable, "gives"},
    {kMember, "hdr", false},
    {kMember, "is"},
    {kMember, "target"},
    {kMember, "optional", false},
    {kMember, "onlyIf"},
};

bool is_number(const Expr& expr) {
    const bool is_signed = expr.kind == Expr::Kind::Unary && (expr.text == "-" || expr.text == "+");
    return (is_signed ? *expr.args[0] : expr).kind == Expr::Kind::Number;
}

// The words of [is] (resolve/meanings.cpp).
bool is_meaning(std::string_view word) {
    constexpr std::string_view kWords[] = {"texel", "normalMap", "data", "position", "direction"};
    constexpr std::string_view kSpaces[] = {"OS", "WS", "VS", "TS"};
    return std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords) ||
           std::any_of(std::begin(kSpaces), std::end(kSpaces),
                       [&](std::string_view space) { return word.ends_with(space); });
}

// Behind the '}' that closes the '{' at `begin`, without those in comments and strings. npos: there is none.
std::size_t end_of_code(std::string_view text, std::size_t begin) {
    const auto behind = [&](std::string_view what, std::size_t from) {
        const std::size_t found = text.find(what, from);
        return found == text.npos ? text.size() : found + what.size();
    };
    int depth = 0;
    for (std::size_t at = begin; at < text.size();) {
        const char c = text[at++];
        if (c == '/' && text.substr(at).starts_with("/")) {
            at = behind("\n", at);
        } else if (c == '/' && text.substr(at).starts_with("*")) {
            at = behind("*/", at + 1);
        } else if (c == '"' || c == '\'') {
            while (at < text.size() && text[at] != c && text[at] != '\n') at += text[at] == '\\' ? 2 : 1;
            ++at;
        } else if (c == '{') {
            ++depth;
        } else if (c == '}' && --depth == 0) {
            return at;
        }
    }
    return text.npos;
}

FunctionMarks marks_of(const FunctionDecl& function) {
    const Attribute* foreign = function.attribute("foreign");
    return {.is_stage = function.attribute("pass") != nullptr,
            .is_slot = function.attribute("slot") != nullptr,
            .is_inlined = function.attribute("inline") != nullptr,
            .is_member = function.attribute("member") != nullptr,
            .is_in_float = function.attribute("inFloat") != nullptr,
            .is_of_object = function.attribute("perObject") != nullptr,
            .is_of_hlsl = function.attribute("hlsl") != nullptr,
            .is_foreign = foreign != nullptr,
            .spelling = foreign && !foreign->args.empty() ? foreign->args[0]->text : std::string_view()};
}

}  // namespace

// An unknown attribute has no effect, and neither has an argument that nothing reads, so they are reported.
void Parser::check_attributes(std::span<const Attribute> marks, std::string_view what) {
    for (const Attribute& mark : marks) {
        const auto* const row =
            std::find_if(std::begin(kAttributes), std::end(kAttributes),
                         [&](const AttributeInfo& each) { return each.name == mark.name && each.place == what; });
        if (row == std::end(kAttributes)) {
            std::vector<std::string_view> known;
            for (const AttributeInfo& each : kAttributes) {
                if (each.place == what) known.push_back(each.name);
            }
            diagnostics_.report(Code::BadAttribute, mark.span, mark.name, fmt::format("is not allowed before {}", what))
                .note(Diagnostics::suggestion(mark.name, known));
        } else if (!row->has_arguments && !mark.args.empty()) {
            diagnostics_.report(Code::BadAttribute, mark.span, mark.name, "takes no arguments");
        } else if (mark.name == "range" &&
                   !(mark.args.size() == 2 && is_number(*mark.args[0]) && is_number(*mark.args[1]))) {
            diagnostics_.report(Code::BadAttribute, mark.span, mark.name, "takes two numbers: [range(0, 1)]");
        } else if (mark.name == "is" && (mark.args.empty() || !is_meaning(mark.args[0]->text))) {
            diagnostics_.report(
                Code::BadAttribute, mark.span, mark.name,
                "takes a name with its space, such as \"normalTS\", or texel, normalMap, data, position "
                "or direction");
        }
    }
}

void Parser::file() {
    while (now().kind != Token::Kind::End) {
        if (take_if(";")) continue;
        if (!declaration()) skip_declaration();
    }
}

bool Parser::declaration() {
    std::string_view doc = now().doc;
    std::vector<Attribute> marks;
    if (!attributes(marks)) return false;
    if (doc.empty()) doc = now().doc;
    if (now().is_word("struct")) return structure(std::move(marks), doc);
    if (now().is_word("enum")) {
        for (const Attribute& mark : marks) {
            diagnostics_.report(Code::BadAttribute, mark.span, mark.name, "is not allowed before an enum");
        }
        return enumeration(doc);
    }
    const std::size_t begin = now().begin;
    bool is_const = false;
    if (is_hlsl())
        qualifiers(is_const);
    else
        is_const = take_word("const");
    TypeName type;
    Token word;
    if (!type_name(type, "a declaration") || !name("a name", word)) return false;
    const bool is_function = (!is_const || is_hlsl()) && now().is("(");
    check_attributes(marks, is_function ? kFunction : kVariable);
    if (is_function) {
        FunctionDecl decl{.name = word.text,
                          .name_span = span(word),
                          .result = type,
                          .attributes = std::move(marks),
                          .is_hlsl = is_hlsl(),
                          .doc = doc,
                          .doc_begin = doc.empty() ? 0 : text_.at(offset_of(doc))};
        return function(std::move(decl), begin);
    }
    for (;;) {
        VariableDecl decl{.type = type,
                          .name = word.text,
                          .span = span(word),
                          .is_const = is_const,
                          .is_hlsl = is_hlsl(),
                          .attributes = marks,
                          .doc = doc};
        if (!variable(decl)) return false;
        // "static const float a = 1, b = 2;"
        const bool has_next = is_hlsl() && take_if(",");
        if (decl.doc.empty()) decl.doc = now().trailing_doc;
        const bool ended = has_next || end_of_statement();
        if (decl.doc.empty() && !has_next) decl.doc = now().trailing_doc;
        ast_.variables.push_back(std::move(decl));
        if (!has_next) return ended;
        if (!name("a name", word)) return false;
    }
}

// --- types and attributes

bool Parser::type_name(TypeName& into, std::string_view what) {
    Token word;
    if (is_hlsl() && now().is_word("unsigned") && after().is_word("int")) {
        into = {.name = "uint", .span = span(take())};
        take();
        return true;
    }
    if (!name(what, word)) return false;
    into.name = word.text;
    into.span = span(word);
    // "Texture2D<float4>": what is read of it is always a float4.
    if (is_hlsl() && now().is("<")) {
        while (!now().is(">") && !now().is(";") && now().kind != Token::Kind::End) take();
        return expect(">", "'>'");
    }
    return true;
}

// The [4] behind the name of an array.
bool Parser::array_size(TypeName& into) {
    while (now().is("[") && (is_hlsl() || !into.array_size)) {
        if (into.array_size) lacks(span(now()), "an array of arrays: write one with the product of the sizes");
        const Token open = take();
        const Node size = expression();
        if (!size || !expect_close("]", open)) return false;
        into.array_size = size.expr;
    }
    return true;
}

bool Parser::attributes(std::vector<Attribute>& into) {
    while (now().is("[")) {
        const Token open = take();
        if (!attribute(into.emplace_back()) || !expect_close("]", open)) return false;
    }
    return true;
}

bool Parser::attribute(Attribute& into) {
    if (now().kind != Token::Kind::Word) {
        expected("the name of an attribute");
        return false;
    }
    const Token word = take();
    into.name = word.text;
    const Token open = now();
    if (take_if("(") && !take_if(")")) {
        do {
            const Node argument = now().kind == Token::Kind::String ? leaf(Expr::Kind::File, take()) : expression();
            if (!argument) return false;
            into.args.push_back(argument.expr);
        } while (take_if(","));
        if (!expect_close(")", open, "','")) return false;
    }
    into.span = span_from(word.begin);
    return true;
}

// Reads the separator and a `///<` behind it, or behind the last element of a list.
std::string_view Parser::trailing_doc_and(std::string_view separator, bool& found) {
    const std::string_view doc = now().trailing_doc;
    found = take_if(separator);
    return doc.empty() && found ? now().trailing_doc : doc;
}

// Reports a name that the list has already.
void Parser::declare_once(std::unordered_set<std::string_view>& names, const Token& name) {
    if (!names.insert(name.text).second) diagnostics_.report(Code::Redefinition, span(name), name.text);
}

// --- struct, enum, variable

bool Parser::structure(std::vector<Attribute> marks, std::string_view doc) {
    take();
    Token word;
    if (!name("a name for the struct", word)) return false;
    StructDecl decl{.name = word.text, .span = span(word), .attributes = std::move(marks), .doc = doc};
    std::unordered_set<std::string_view> names;
    const Token open = now();
    if (!expect("{", "'{'")) return false;
    while (!now().is("}")) {
        MemberDecl first;
        if (!attributes(first.attributes)) return false;
        check_attributes(first.attributes, kMember);
        if (!type_name(first.type, "a member or '}'")) return false;
        // "float2 center, size;"
        for (bool more = true; more;) {
            MemberDecl& member = decl.members.emplace_back(first);
            Token member_name;
            if (!name("a name for the member", member_name)) return false;
            declare_once(names, member_name);
            member.name = member_name.text;
            member.span = span(member_name);
            if (!array_size(member.type)) return false;
            skip_semantic();
            more = is_hlsl() && take_if(",");
        }
        bool found = false;
        decl.members.back().doc = trailing_doc_and(";", found);
        if (!found && !end_of_statement()) return false;
    }
    if (!expect_close("}", open)) return false;
    ast_.structs.push_back(std::move(decl));
    return end_of_statement();
}

bool Parser::enumeration(std::string_view doc) {
    take();
    Token word;
    if (!name("a name for the enum", word)) return false;
    EnumDecl decl{.name = word.text, .span = span(word), .doc = doc};
    std::unordered_set<std::string_view> names;
    const Token open = now();
    if (!expect("{", "'{'")) return false;
    for (bool more = true; more && !(now().is("}") && !decl.values.empty());) {
        Token value;
        if (!name("a name for a value of the enum", value)) return false;
        declare_once(names, value);
        decl.values.push_back(value.text);
        decl.docs.push_back(trailing_doc_and(",", more));
    }
    if (!expect_close("}", open, "','")) return false;
    ast_.enums.push_back(std::move(decl));
    return end_of_statement();
}

bool Parser::variable(VariableDecl& decl) {
    if (!array_size(decl.type)) return false;
    if (!decl.is_const && decl.attributes.empty() && is_hlsl()) {
        lacks(decl.type.span, "a variable of the file is 'const', or a parameter brings it");
    } else if (!decl.is_const && decl.attributes.empty()) {
        diagnostics_.report(Code::Syntax, decl.type.span, "'const' or an attribute before a variable of the file",
                            fmt::format("'{}'", decl.type.name));
    }
    if (take_if("=")) {
        const Node value = initializer();
        if (!value) return false;
        decl.value = value.expr;
    } else if (decl.is_const) {
        expected("'=' and the value of the constant");
        return false;
    }
    return true;
}

// --- functions

bool Parser::function(FunctionDecl decl, std::size_t begin) {
    decl.marks = marks_of(decl);
    if (!parameters(decl)) return false;
    skip_semantic();
    if (decl.has_body) {
        // The text of a foreign function has been taken already.
    } else if (now().is("{")) {
        decl.has_body = true;
        if (bodies_ == Bodies::WhenAsked) {
            leave_unread(decl);
        } else if (!block(decl.body)) {
            return false;
        }
        if (is_hlsl()) remove_jumps(decl, ast_, diagnostics_);
    } else if (!end_of_statement()) {
        return false;
    } else if (is_hlsl()) {
        return true;  // it only announces the function
    }
    decl.span = span_from(begin);
    ast_.functions.push_back(std::move(decl));
    return true;
}

// Moves behind the '}' that closes the '{' here, and records both places.
void Parser::leave_unread(FunctionDecl& function) {
    const std::size_t begin = now().begin;
    std::size_t at = begin;
    int depth = 0;
    while (at < text_.text.size()) {
        const char c = text_.text[at++];
        if (c == '/' && text_.text.substr(at).starts_with("/"))
            at = std::min(text_.text.find('\n', at), text_.text.size());
        if (c == '/' && text_.text.substr(at).starts_with("*"))
            at = std::min(text_.text.find("*/", at), text_.text.size());
        if (c == '{') ++depth;
        if (c == '}' && --depth == 0) break;
    }
    auto unread = std::make_shared<UnreadBody>();
    unread->text = {.text = text_.text.substr(begin, at - begin), .base = text_.at(begin)};
    function.unread = std::move(unread);
    go_to(at);
}

void Parser::go_to(std::size_t offset) {
    lexer_.go_to(offset);
    if (preprocessor_) preprocessor_->forget_ahead();
    last_end_ = offset;
    now_ = next_token();
    after_ = next_token();
}

// Takes the ')' here and the text of the body after it, from '{' to the matching '}'. No token of the text is read: it
// need not consist of words of the node language.
bool Parser::foreign_code(FunctionDecl& function) {
    const std::string_view text = text_.text;
    const std::size_t begin = after().begin;
    const std::size_t end = end_of_code(text, begin);
    if (end == text.npos) {
        diagnostics_.report(Code::Syntax, lexer_.span(text.size(), text.size()), "'}'", "the end of the file")
            .note(span(after()), "to close this '{'");
        go_to(text.size());
        return false;
    }
    function.has_body = true;
    function.marks.is_in_float = true;
    function.code = text.substr(begin + 1, end - begin - 2);
    go_to(end);
    return true;
}

bool Parser::parameters(FunctionDecl& function) {
    const Token open = take();
    std::unordered_set<std::string_view> names;
    if (is_hlsl() && after().is(")")) take_word("void");
    for (bool more = !now().is(")"); more;) {
        ParamDecl& param = function.params.emplace_back();
        if (!parameter(param)) return false;
        if (!names.insert(param.name).second) diagnostics_.report(Code::Redefinition, param.span, param.name);
        param.doc = trailing_doc_and(",", more);
    }
    if (function.marks.is_foreign && now().is(")") && after().is("{")) return foreign_code(function);
    return expect_close(")", open, "','");
}

bool Parser::parameter(ParamDecl& into) {
    if (!attributes(into.attributes)) return false;
    check_attributes(into.attributes, kParameter);
    if (is_hlsl()) return hlsl_parameter(into);
    into.is_const = take_word("const");
    into.is_out = !into.is_const && take_word("out");
    if ((now().is_word("in") || now().is_word("inout")) && after().kind == Token::Kind::Word) {
        expected("a type").note("a parameter is an input; write 'out' before its type to make it an output");
        return false;
    }
    return typed_parameter(into);
}

bool Parser::typed_parameter(ParamDecl& into) {
    Token word;
    if (!type_name(into.type, "a parameter") || !name("a name for the parameter", word)) return false;
    into.name = word.text;
    into.span = span(word);
    if (!array_size(into.type)) return false;
    skip_semantic();
    if (into.is_out || !take_if("=")) return true;
    const Node initial = expression();
    into.initial = initial.expr;
    return into.initial != nullptr;
}

}  // namespace patina::nodelang
