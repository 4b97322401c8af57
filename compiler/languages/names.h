// Identifiers of the emitted text: which words no target allows, and which are already taken where a new name is
// wanted. A name that the author chose is kept; a number is added only on a clash.
//
//   Names names;
//   names.declare("albedo");  // albedo
//   names.declare("albedo");  // albedo2
//   names.declare("texture"); // texture_
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace patina::targets {

class Names {
public:
    Names() : scopes_(1) { next_.reserve(64); }
    Names(const Names&) = delete;

    // A name that is free in every open scope, made from the wanted one; taken in the innermost scope.
    std::string declare(std::string_view wanted);
    bool is_free(std::string_view name) const { return !next_.contains(std::string(name)); }
    void open() { scopes_.emplace_back(); }
    // Names of the innermost scope are free again.
    void close();

private:
    struct Taken {
        const std::string* name;  // in next_
        unsigned* number;         // of the name that was wanted: in next_, too
    };
    std::unordered_map<std::string, unsigned> next_;  // taken names, and the number that the next one like it gets
    std::vector<std::vector<Taken>> scopes_;
};

}  // namespace patina::targets
