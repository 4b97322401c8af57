#include "compiler/importers/shadergraph/read/misreads.h"

#include <fmt/format.h>

#include <algorithm>

namespace patina::importers::shadergraph {
namespace {

thread_local Misreads* t_current = nullptr;

std::string said(const Json& value) {
    switch (value.kind) {
        case Json::Kind::Null: return "null";
        case Json::Kind::Bool: return value.boolean ? "true" : "false";
        case Json::Kind::Number: return fmt::format("{}", value.number);
        case Json::Kind::String: return fmt::format("\"{}\"", json::shown(value.string));
        case Json::Kind::Array: return "a list";
        case Json::Kind::Object: return "an object";
    }
    return {};
}

}  // namespace

Misreads::Misreads(const Documents& documents) : documents_(documents), outer_(t_current) {
    t_current = this;
}

Misreads::~Misreads() {
    t_current = outer_;
}

std::string Misreads::take() {
    std::string made;
    for (const auto& [value, text] : notes_) made += (made.empty() ? "" : "; ") + text;
    notes_.clear();
    return made;
}

void note_misread(const Json& value, std::string_view key, std::string_view wanted, std::string_view taken) {
    if (!t_current) return;
    auto& notes = t_current->notes_;
    if (std::ranges::any_of(notes, [&](const auto& each) { return each.first == &value; })) return;
    const Place at = t_current->documents_.place(value);
    notes.push_back({&value, fmt::format("'{}' ({}:{}) is {}, not {}: {} is taken", key, at.line, at.column,
                                         said(value), wanted, taken)});
}

void note_broken(const Json& value, std::string_view key, std::string_view wanted) {
    if (!t_current || !t_current->broken_.empty()) return;
    const Place at = t_current->documents_.place(value);
    t_current->broken_ = fmt::format("{}:{}:{}: '{}' is {}, not {}", t_current->documents_.path(), at.line, at.column,
                                     key, said(value), wanted);
}

std::string take_misreads() {
    return t_current ? t_current->take() : std::string();
}

}  // namespace patina::importers::shadergraph
