#include "compiler/languages/names.h"

#include <algorithm>

#include "compiler/base/letters.h"
#include "compiler/base/spelling.h"

namespace patina::languages {
namespace {

// Keeps only letters, digits and single underscores, with no digit first.
std::string plain_identifier(std::string_view word) {
    const auto is_letter_or_digit = [](char c) { return is_letter(c) || is_digit(c); };
    // Most names are valid already, so check before copying letter by letter.
    if (!word.empty() && is_letter(word[0]) && std::all_of(word.begin(), word.end(), is_letter_or_digit)) {
        return std::string(word);
    }
    std::string plain;
    plain.reserve(word.size() + 1);
    for (char c : word) {
        const char next = is_letter_or_digit(c) ? c : '_';
        if (next == '_' && !plain.empty() && plain.back() == '_') continue;
        plain += next;
    }
    if (plain.empty() || plain == "_") return "value";
    if (is_digit(plain[0])) plain.insert(plain.begin(), '_');
    return plain;
}

}  // namespace

std::string safe_identifier(std::string_view word) {
    std::string name = plain_identifier(word);
    if (name.starts_with("gl_")) name.erase(2, 1);
    if (is_reserved_word(name)) name += '_';
    return name;
}

bool Names::is_free(std::string_view name) const {
    const std::string text(name);
    return !next_.contains(text) && !is_taken(text);
}

std::string Names::declare(std::string_view wanted) {
    std::string safe = safe_identifier(wanted);
    const auto begins_so = [&](const std::string& prefix) { return safe.starts_with(prefix); };
    if (taken_ && std::any_of(taken_->prefixes.begin(), taken_->prefixes.end(), begins_so)) safe = joined("own", safe);
    const auto [entry, is_new] = next_.try_emplace(std::move(safe), 2);
    const std::string& base = entry->first;
    unsigned& number = entry->second;
    const std::string* name = &base;
    for (bool is_free = is_new && !is_taken(base); !is_free;) {
        const auto made = next_.try_emplace(numbered(base, number++), 2);
        name = &made.first->first;
        is_free = made.second && !is_taken(*name);
    }
    scopes_.back().push_back({name, &number});
    return *name;
}

// From the last to the first: a numbered name is removed before the name that it was made from.
void Names::close() {
    for (auto taken = scopes_.back().rbegin(); taken != scopes_.back().rend(); ++taken) {
        *taken->number = 2;
        next_.erase(next_.find(*taken->name));
    }
    scopes_.pop_back();
}

}  // namespace patina::languages
