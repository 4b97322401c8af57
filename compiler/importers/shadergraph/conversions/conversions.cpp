#include "compiler/importers/shadergraph/conversions/conversions.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "compiler/importers/shadergraph/conversions/typed_reader.h"

namespace patina::importers::shadergraph {
namespace {

constexpr std::string_view kAssigning[] = {"=", "+=", "-=", "*=", "/="};

bool is_one_of(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, text) != words.end();
}

}  // namespace

std::vector<Parameter> parameters_in(std::string_view text) {
    std::vector<Parameter> made;
    const std::vector<Token> tokens = tokens_of(text);
    int depth = 0;
    Parameter now;
    bool is_named = false;
    for (const Token& each : tokens) {
        const std::string_view word = each.text;
        if (word.empty() || (word == "," && depth == 0)) {
            if (!now.name.empty()) made.push_back(now);
            now = {};
            is_named = false;
            continue;
        }
        if (is_one_of(word, {"(", "["})) ++depth;
        if (is_one_of(word, {")", "]"})) --depth;
        // An array: "float k[4]".
        if (word == "[" && depth == 1 && !now.name.empty()) now.type.is_array = true;
        is_named |= word == "=" || word == ":";
        if (depth > 0 || is_named || !is_letter(word[0])) continue;
        if (word == "out" || word == "inout")
            now.is_out = true;
        else if (now.type.kind == Kind::Unknown && now.name.empty() && type_of(word).kind != Kind::Unknown)
            now.type = type_of(word);
        else
            now.name = word;
    }
    return made;
}

TypedReader::TypedReader(const HlslFunction& function, const std::vector<HlslFunction>& others, std::string_view values)
    : body_(function.body), tokens_(tokens_of(body_)), function_(function), others_(others) {
    for (const Token& each : tokens_) texts_.push_back({.text = std::string(each.text)});
    for (const std::string_view list : {std::string_view(function.parameters), values})
        for (const Parameter& each : parameters_in(list)) scope_[each.name] = {.type = each.type};
}

const Token& TypedReader::at(std::size_t ahead) const {
    return tokens_[std::min(next_ + ahead, tokens_.size() - 1)];
}

bool TypedReader::take(std::string_view text) {
    if (is_lost_ || !is(text)) return false;
    ++next_;
    return true;
}

void TypedReader::need(std::string_view text) {
    if (!take(text)) give_up();
}

// The tokens with all that is written around them.
std::string TypedReader::written(std::size_t begin, std::size_t end) const {
    std::string made;
    for (std::size_t i = begin; i < end; ++i) {
        made += texts_[i].before + texts_[i].text + texts_[i].after;
        if (i + 1 == end) break;
        const char* behind = tokens_[i].text.data() + tokens_[i].text.size();
        const std::string_view gap(behind, static_cast<std::size_t>(tokens_[i + 1].text.data() - behind));
        const std::string& next = texts_[i + 1].text;
        const bool is_close = next.empty() || next == "," || next == ";" || texts_[i].text.ends_with("(");
        if (gap != " " || !is_close) made += gap;
    }
    return made;
}

std::string TypedReader::run() {
    find_limits();
    while (!is_lost_ && !at().text.empty()) statement(true);
    if (is_lost_) return std::string(body_);
    if (open_ > 0) texts_[tokens_.size() - 2].after += std::string(open_, '}');
    const std::size_t first = static_cast<std::size_t>(tokens_[0].text.data() - body_.data());
    return std::string(body_.substr(0, first)) + written(0, tokens_.size());
}

// --- statements

void TypedReader::statement(bool is_in_block) {
    if (is("[") || (is_word() && at().text.starts_with("UNITY_") && is_one_of(at(1).text, {"if", "for"}))) attribute();
    return_ = kNone;
    if (++depth_ > kDeepest) give_up();
    if (is_lost_ || take(";")) {
    } else if (take("{")) {
        const Scope outside = scope_;
        ++blocks_;
        while (!is_lost_ && !at().text.empty() && !is("}")) statement(true);
        need("}");
        --blocks_;
        scope_ = outside;
    } else if (take("if")) {
        if_statement();
    } else if (take("for")) {
        for_loop();
        return_ = kNone;
    } else if (take("return")) {
        return_statement();
    } else if (is("sincos") && at(1).text == "(") {
        sincos(is_in_block);
    } else if (is_void_call()) {
        void_call(is_in_block);
    } else if (!declaration(is_in_block)) {
        assignment_statement();
    }
    --depth_;
}

// "if (a) { b; return; } c;" -> "if (a) { b; } else { c; }", where nothing follows in the function.
void TypedReader::if_statement() {
    need("(");
    Value condition = expression();
    to_bool(condition);
    need(")");
    ++blocks_;
    statement(false);
    --blocks_;
    const std::size_t returns = return_;
    if (take("else")) {
        ++blocks_;
        statement(false);
        --blocks_;
    } else if (returns != kNone && blocks_ == 0) {
        texts_[returns].text = "{ }";
        texts_[returns + 1].text.clear();
        texts_[next_ - 1].after += " else {";
        ++open_;
    }
    return_ = kNone;
}

void TypedReader::return_statement() {
    if (!is(";")) {
        Value value = expression();
        convert(value, type_of(function_.result));
    } else if (blocks_ == 0 && open_ > 0 && at(1).text.empty()) {
        texts_[next_ - 1].text.clear();
    } else {
        return_ = next_ - 1;
    }
    need(";");
}

// Hints for the engine's compiler change no value. "[unroll(4)]" may, so it stays.
void TypedReader::attribute() {
    if (is_word()) {
        texts_[next_++].text.clear();
        return;
    }
    const bool is_hint = at(2).text == "]" && (is_one_of(at(1).text, {"branch", "flatten", "loop", "fastopt"}) ||
                                               (at(1).text == "unroll" && at(3).text != "for"));
    if (is_hint)
        for (std::size_t i = next_; i < next_ + 3; ++i) texts_[i].text.clear();
    while (!is_lost_ && !at().text.empty() && !is("]")) ++next_;
    need("]");
}

// "const float a = 1, b[2] = { 0, 1 };": a declaration for each.
bool TypedReader::declaration(bool is_in_block) {
    const std::size_t begin = next_;
    std::size_t ahead = 0;
    if (at().text == "static" && at(1).text == "const") texts_[next_].text.clear();
    while (is_one_of(at(ahead).text, {"static", "const"})) ++ahead;
    if (!is_word(ahead) || !is_word(ahead + 1)) return ahead > 0 ? (give_up(), true) : false;
    if (at().text == "static" && at(1).text != "const") return give_up(), true;
    next_ += ahead;
    const bool is_const = ahead > 0;
    const std::string word(at().text);
    const Type type = type_of(word);
    ++next_;
    for (std::size_t name_at = next_; !is_lost_; name_at = next_) {
        if (!is_word()) return give_up(), true;
        const std::string_view name = at().text;
        Variable made{.type = type};
        ++next_;
        while (take("[")) {
            made.type.is_array = true;
            if (!is("]")) expression();
            need("]");
        }
        // A limit of a loop is a constant. If the code assigns to it later, the compiler says so.
        const bool is_limit =
            !is_const && type.kind == Kind::Int && type.size == 1 && is("=") && limits_.contains(name);
        if (is_limit) {
            std::string& before = texts_[name_at == begin + 1 ? begin : name_at].before;
            before = "const " + before;
        }
        if (take("=")) {
            if (is("{")) {
                list_of(made.type);
            } else {
                Value value = expression();
                convert(value, type);
            }
        }
        scope_[name] = made;
        if (!is(",")) break;
        if (!is_in_block) return give_up(), true;
        texts_[next_].text = ";";
        texts_[next_ + 1].before = fmt::format("{}{} ", is_const ? "const " : "", word);
        ++next_;
    }
    need(";");
    return true;
}

// "{ 0, 1 }": of a vector, of an array, and of a matrix, whose numbers a constructor takes.
void TypedReader::list_of(const Type& type) {
    const std::size_t begin = next_++;
    int count = 0;
    while (!is_lost_ && !is("}")) {
        if (is("{")) return give_up();
        Value value = expression();
        Type element = type;
        element.is_array = false;
        if (!type.is_array) element = {.kind = type.kind};
        convert(value, element);
        if (!type.is_array && value.type.size != 1) give_up();
        ++count;
        if (!take(",")) break;
    }
    need("}");
    if (type.columns == 0 || type.is_array || is_lost_) return;
    if (count != type.size * type.columns) return give_up();
    texts_[begin].text = fmt::format("float{}x{}(", type.size, type.columns);
    texts_[next_ - 1].text = ")";
}

// "sincos(x, s, c);" -> "s = sin(x); c = cos(x);"
void TypedReader::sincos(bool is_in_block) {
    const std::size_t begin = next_;
    next_ += 2;
    Value angle = expression();
    if (angle.type.is_vector()) convert(angle, {.kind = Kind::Float, .size = angle.type.size});
    need(",");
    Value sine = expression();
    need(",");
    Value cosine = expression();
    need(")");
    if (!is(";") || angle.type.kind != Kind::Float || angle.type.size != sine.type.size ||
        sine.type.size != cosine.type.size || sine.type.kind != Kind::Float || cosine.type.kind != Kind::Float)
        return give_up();
    // The cosine is that of the angle before anything is assigned.
    for (std::size_t i = angle.begin; i < angle.end; ++i)
        if (is_letter(tokens_[i].text[0]) && tokens_[i].text == tokens_[sine.begin].text) return give_up();
    const std::string x = written(angle.begin, angle.end), s = written(sine.begin, sine.end),
                      c = written(cosine.begin, cosine.end);
    replace_statement(begin, fmt::format("{} = sin({}); {} = cos({})", s, x, c, x), is_in_block);
}

// The statement from `begin` on, up to its semicolon.
void TypedReader::replace_statement(std::size_t begin, const std::string& text, bool is_in_block) {
    for (std::size_t i = begin; i < next_; ++i) texts_[i] = {};
    texts_[begin].text = (is_in_block ? "" : "{ ") + text;
    if (!is_in_block) texts_[next_].after = " }";
    need(";");
}

const HlslFunction* TypedReader::own_function(std::string_view name) const {
    const auto found = std::ranges::find(others_, name, &HlslFunction::name);
    return found == others_.end() ? nullptr : &*found;
}

bool TypedReader::is_void_call() const {
    const HlslFunction* called = at(1).text == "(" ? own_function(at().text) : nullptr;
    return called && called->result == "void";
}

// "Polar(uv, radius, angle);" -> "radius = Polar(uv).r; angle = Polar(uv).a;"
void TypedReader::void_call(bool is_in_block) {
    const std::size_t begin = next_++;
    const std::vector<Parameter> parameters = parameters_in(own_function(tokens_[begin].text)->parameters);
    std::vector<Value> values = arguments();
    if (is_lost_ || !is(";") || values.size() != parameters.size()) return give_up();
    std::string inputs;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (parameters[i].is_out) continue;
        convert(values[i], parameters[i].type);
        inputs += (inputs.empty() ? "" : ", ") + written(values[i].begin, values[i].end);
    }
    const auto outputs = std::ranges::count_if(parameters, &Parameter::is_out);
    std::string made;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!parameters[i].is_out) continue;
        const Type &is = values[i].type, &out = parameters[i].type;
        // All inputs are read before anything is assigned.
        const bool is_read = outputs > 1 && has_identifier(inputs, tokens_[values[i].begin].text);
        if (is_read || !is.is_known() || is.kind != out.kind || is.size != out.size || is.columns != out.columns)
            return give_up();
        made += fmt::format("{}{} = {}({}).{}", made.empty() ? "" : "; ", written(values[i].begin, values[i].end),
                            tokens_[begin].text, inputs, parameters[i].name);
    }
    if (made.empty()) return give_up();
    replace_statement(begin, made, is_in_block);
}

void TypedReader::assignment_statement() {
    const bool is_before = is("++") || is("--");
    if (is_before) ++next_;
    const std::size_t begin = next_;
    // A counter of a loop is not assigned.
    if (const auto found = scope_.find(at().text);
        !is_word() || (found != scope_.end() && !found->second.read_as.empty()))
        return give_up();
    ++next_;
    while (is(".") || is("[")) {
        int depth = is("[") ? 1 : 0;
        next_ += depth > 0 ? 1 : 2;
        for (; depth > 0 && !at().text.empty(); ++next_) depth += is("[") ? 1 : is("]") ? -1 : 0;
    }
    const std::size_t behind = next_;
    if (is_before || is("++") || is("--")) {
        const std::size_t sign = is_before ? begin - 1 : behind;
        const char op = tokens_[sign].text[0];
        texts_[sign].text.clear();
        texts_[behind - 1].after += fmt::format(" {}= 1", op);
        next_ = is_before ? behind : behind + 1;
        need(";");
        return;
    }
    if (std::ranges::find(kAssigning, at().text) == std::end(kAssigning)) return give_up();
    const std::string_view op = at().text;
    next_ = begin;
    const Value to = postfix();
    if (is_lost_) return;
    next_ = behind + 1;
    Value value = expression();
    const bool is_mixed = op != "=" && to.type.kind != Kind::Float && to.type.kind != value.type.kind;
    if (to.type.is_known() && is_mixed && !value.type.is_loose) return give_up();
    convert(value, to.type);
    need(";");
}

std::string with_conversions(const HlslFunction& function, const std::vector<HlslFunction>& others,
                             std::string_view values) {
    return TypedReader(function, others, values).run();
}

std::string functions_for_conversions(std::string_view body) {
    std::string made;
    for (int size = 2; size <= 4; ++size) {
        if (!has_identifier(body, fmt::format("choose{}", size))) continue;
        std::string components;
        for (int i = 0; i < size; ++i)
            components += fmt::format("{0}condition.{1} ? yes.{1} : no.{1}", i > 0 ? ", " : "", "xyzw"[i]);
        made += fmt::format(
            "float{0} choose{0}(bool{0} condition, float{0} yes, float{0} no) {{\n    return float{0}({1});\n}}\n\n",
            size, components);
    }
    return made;
}

}  // namespace patina::importers::shadergraph
