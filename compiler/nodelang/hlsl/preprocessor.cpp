#include "compiler/nodelang/hlsl/preprocessor.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/cancellation.h"
#include "compiler/nodelang/hlsl/condition.h"

namespace patina::nodelang {
namespace {

constexpr std::size_t kMostMade = 1u << 18;  // tokens of macros in one file
constexpr int kDeepest = 64;                 // macros in macros, and #if in #if

std::string described(const Token& token) {
    return token.kind == Token::Kind::End ? "the end of the line" : fmt::format("'{}'", token.text);
}

}  // namespace

void Preprocessor::wrong(const Token& at, std::string_view expected, std::string_view found) {
    diagnostics_.report(Code::Syntax, span(at), expected, found);
}

Token Preprocessor::raw() {
    if (ahead_.empty()) return lexer_.next();
    const Token token = ahead_.front();
    ahead_.pop_front();
    return token;
}

Token Preprocessor::next() {
    for (;;) {
        if (!made_.empty()) {
            const Token token = made_.front();
            made_.pop_front();
            return token;
        }
        Token token = raw();
        if (token.is("#") && token.begins_line) {
            directive(token);
        } else if (token.kind == Token::Kind::End) {
            for (const Branch& open : branches_) wrong(open.mark, "'#endif' after this", "the end of the file");
            branches_.clear();
            return token;
        } else if (is_open()) {
            Tokens list;
            begins_line_ = begins_line_ || token.begins_line;
            const bool is_replaced = replace(token, list, nullptr, {});
            if (is_replaced && list.empty()) continue;
            (is_replaced ? list.front() : token).begins_line = begins_line_;
            begins_line_ = false;
            if (!is_replaced) return token;
            made_.assign(list.begin(), list.end());
        }
    }
}

// Reads the line behind a '#'.
void Preprocessor::directive(const Token& mark) {
    Tokens line;
    lexer_.report_to(unread_);
    std::size_t end = mark.end;
    for (Token token = raw(); token.kind != Token::Kind::End && !token.begins_line; token = raw()) {
        end = token.end;
        line.push_back(token);
    }
    read_line(mark, std::move(line));
    // The text that follows is read again, to report its errors.
    lexer_.report_to(is_open() ? diagnostics_ : unread_);
    lexer_.go_to(end);
}

void Preprocessor::read_line(const Token& mark, Tokens line) {
    if (line.empty()) return;
    const Token word = line.front();
    line.erase(line.begin());
    if (word.text == "if" || word.text == "ifdef" || word.text == "ifndef" || word.text == "elif" ||
        word.text == "else" || word.text == "endif") {
        branch(mark, word, line);
    } else if (is_open()) {
        if (word.text == "define") {
            define(line);
        } else if (word.text == "undef") {
            if (!line.empty()) macros_.erase(line[0].text);
        } else if (word.text == "error") {
            wrong(word, "a text that its own '#error' lets pass", "'#error'");
        } else if (word.text != "include" && word.text != "pragma" && word.text != "line" && word.text != "warning" &&
                   word.text != "include_with_pragmas") {
            wrong(word, "a directive of the preprocessor", described(word));
        }
    }
}

void Preprocessor::define(const Tokens& line) {
    if (line.empty() || line[0].kind != Token::Kind::Word) {
        const Token at = line.empty() ? Token{} : line[0];
        if (!line.empty()) wrong(at, "the name of a macro", described(at));
        return;
    }
    Macro macro;
    std::size_t i = 1;
    // Only a bracket directly behind the name begins parameters.
    if (line.size() > 1 && line[1].is("(") && line[1].begin == line[0].end) {
        macro.has_parameters = true;
        for (i = 2; i < line.size() && !line[i].is(")"); ++i) {
            if (line[i].is(",")) continue;
            // "..."
            if (line[i].is(".") && i + 3 < line.size() && line[i + 1].is(".") && line[i + 2].is(".") &&
                line[i + 3].is(")")) {
                macro.takes_more = true;
                macro.parameters.push_back("__VA_ARGS__");
                i += 2;
                continue;
            }
            if (line[i].kind != Token::Kind::Word) return wrong(line[i], "a parameter or ')'", described(line[i]));
            macro.parameters.push_back(line[i].text);
        }
        if (i == line.size()) return wrong(line[1], "')' to close this", "the end of the line");
        ++i;
    }
    for (; i < line.size(); ++i) {
        if (line[i].kind == Token::Kind::Bad) return wrong(line[i], "a token", described(line[i]));
        macro.body.push_back(line[i]);
    }
    macros_[line[0].text] = std::move(macro);
}

void Preprocessor::branch(const Token& mark, const Token& word, const Tokens& line) {
    if (word.text == "if" || word.text == "ifdef" || word.text == "ifndef") {
        // What lies in a part that is left out is not asked.
        const bool is_taken = is_open() && holds(word, line);
        const bool is_outside_open = is_open();
        branches_.push_back({.is_open = is_taken, .was_open = is_taken || !is_outside_open, .mark = mark});
        if (branches_.size() == std::size_t{kDeepest}) diagnostics_.report(Code::TooDeep, span(mark), kDeepest);
        return;
    }
    if (branches_.empty()) return wrong(word, "'#if' before this", fmt::format("'#{}'", word.text));
    if (word.text == "endif") {
        branches_.pop_back();
        return;
    }
    Branch& last = branches_.back();
    const bool may_open = !last.was_open;
    last.is_open = may_open && (word.text == "else" || holds(word, line));
    last.was_open = last.was_open || last.is_open;
}

bool Preprocessor::holds(const Token& word, const Tokens& line) {
    if (line.empty()) {
        wrong(word, "a condition after this", "the end of the line");
        return false;
    }
    if (word.text == "ifdef" || word.text == "ifndef") return macros_.contains(line[0].text) == (word.text == "ifdef");
    const Tokens condition = replaced(with_defined_decided(line), {});
    const Decision decision = decide(condition, zeros_);
    if (!decision.error.empty())
        diagnostics_.report(Code::Syntax, decision.at.kind == Token::Kind::End ? span(word) : span(decision.at),
                            decision.error,
                            decision.at.kind == Token::Kind::End ? "the end of the line" : described(decision.at));
    return decision.holds;
}

// "defined(X)" and "defined X" as 1 or 0.
Preprocessor::Tokens Preprocessor::with_defined_decided(const Tokens& line) {
    Tokens made;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (!line[i].is_word("defined")) {
            made.push_back(line[i]);
            continue;
        }
        const bool has_bracket = i + 1 < line.size() && line[i + 1].is("(");
        const std::size_t name = i + (has_bracket ? 2 : 1);
        Token number = line[i];
        number.kind = Token::Kind::Number;
        number.number = name < line.size() && macros_.contains(line[name].text) ? 1 : 0;
        made.push_back(number);
        i = name + (has_bracket && name + 1 < line.size() && line[name + 1].is(")") ? 1 : 0);
    }
    return made;
}

// Appends the tokens that replace the name; false: it is no macro. The arguments are read from the head of `rest`, or,
// if that is null, from the text.
bool Preprocessor::replace(const Token& name, Tokens& into, Rest* rest, const Active& active) {
    Cancellation::step();
    if (name.kind != Token::Kind::Word || active.contains(name.text)) return false;
    const auto found = macros_.find(name.text);
    if (found == macros_.end()) return false;
    const Macro& macro = found->second;
    if (active.size() >= std::size_t{kDeepest} || depth_ >= kMaxNesting) {
        diagnostics_.report(Code::TooDeep, span(name), depth_ >= kMaxNesting ? kMaxNesting : kDeepest);
        made_count_ = kMostMade + 1;  // this ends the work
        return true;
    }
    if (made_count_ > kMostMade) return true;  // reported
    std::vector<Tokens> given;
    if (macro.has_parameters) {
        if (!arguments(name, rest, macro.takes_more ? macro.parameters.size() : kMostMade, given)) return false;
        if (macro.parameters.empty() && given.size() == 1 && given[0].empty()) given.clear();  // "F()"
        if (given.size() != macro.parameters.size()) {
            diagnostics_.report(Code::ArgumentCount, span(name), name.text, macro.parameters.size(), given.size());
            return true;
        }
    }
    ++depth_;
    replace_by(macro, name, into, given, active);
    --depth_;
    return true;
}

// Appends the macro's text with the arguments in the places of its parameters.
void Preprocessor::replace_by(const Macro& macro, const Token& name, Tokens& into, const std::vector<Tokens>& given,
                              const Active& active) {
    const auto parameter = [&](const Token& token) {
        const auto at = std::find(macro.parameters.begin(), macro.parameters.end(), token.text);
        return token.kind == Token::Kind::Word ? static_cast<std::size_t>(at - macro.parameters.begin())
                                               : macro.parameters.size();
    };
    Tokens list;
    for (std::size_t i = 0; i < macro.body.size(); ++i) {
        const bool joins = i + 1 < macro.body.size() && macro.body[i + 1].is("##");
        if (macro.body[i].is("##") && i + 1 < macro.body.size() && !list.empty()) {
            const std::size_t k = parameter(macro.body[++i]);
            const Tokens right = k < macro.parameters.size() ? given[k] : Tokens{macro.body[i]};
            if (right.empty()) continue;
            list.back() = pasted(list.back(), right.front());
            list.insert(list.end(), right.begin() + 1, right.end());
            continue;
        }
        const std::size_t k = parameter(macro.body[i]);
        if (k < macro.parameters.size()) {
            Tokens argument = joins ? given[k] : replaced(given[k], active);
            if (!argument.empty()) argument.front().follows_space = macro.body[i].follows_space;
            list.insert(list.end(), argument.begin(), argument.end());
        } else {
            list.push_back(macro.body[i]);
        }
        if (list.size() > kMostMade) break;
    }
    Active inner = active;
    inner.insert(name.text);
    list = replaced(list, inner);
    const bool was_fine = made_count_ <= kMostMade;
    made_count_ += list.size();
    if (made_count_ > kMostMade) {
        if (was_fine) diagnostics_.report(Code::TooMany, span(name), made_count_, "tokens of macros", kMostMade);
        return;
    }
    for (Token& token : list) {
        token.begin = name.begin;
        token.end = name.end;
        token.begins_line = false;
        token.doc = token.trailing_doc = {};
    }
    if (!list.empty()) {
        list.front().doc = name.doc;
        list.front().follows_space = name.follows_space;
    }
    into.insert(into.end(), list.begin(), list.end());
}

// False if no bracket follows: then the name is an ordinary word. The last of the `most` arguments has all that follow.
bool Preprocessor::arguments(const Token& name, Rest* rest, std::size_t most, std::vector<Tokens>& into) {
    const auto take = [&] {
        if (!rest) return raw();
        if (rest->empty()) return Token{};
        const Token token = rest->front();
        rest->pop_front();
        return token;
    };
    if (rest) {
        if (rest->empty() || !rest->front().is("(")) return false;
        take();
    } else {
        const Token open = raw();
        if (!open.is("(")) {
            ahead_.push_front(open);
            return false;
        }
    }
    into.emplace_back();
    for (int depth = 1;;) {
        const Token token = take();
        if (token.kind == Token::Kind::End) {
            diagnostics_.report(Code::Syntax, span(name), fmt::format("')' behind the arguments of '{}'", name.text),
                                "the end of the file");
            if (!rest) ahead_.push_front(token);
            return true;
        }
        if (token.is("(") || token.is("[")) ++depth;
        if (token.is(")") || token.is("]")) --depth;
        if (depth == 0) return true;
        if (depth == 1 && token.is(",") && into.size() < most)
            into.emplace_back();
        else
            into.back().push_back(token);
    }
}

Preprocessor::Tokens Preprocessor::replaced(const Tokens& list, const Active& active) {
    Tokens made;
    Rest rest(list.begin(), list.end());
    while (!rest.empty()) {
        const Token token = rest.front();
        rest.pop_front();
        if (!replace(token, made, &rest, active)) made.push_back(token);
        if (made.size() > kMostMade) break;
    }
    return made;
}

// Two tokens as one: "a ## 1" is a1.
Token Preprocessor::pasted(const Token& left, const Token& right) {
    Token made = left;
    made.text = ast_.texts.emplace_back(std::string(left.text) + std::string(right.text));
    return made;
}

}  // namespace patina::nodelang
