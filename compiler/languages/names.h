// Chooses identifiers of the emitted text: avoids words that a language reserves, and names that are taken. An author's
// name is kept; a number is added only on a clash.
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

#include "compiler/languages/print.h"

namespace patina::languages {

class Names {
public:
    enum class Of { Declarations, Members };
    // `taken`: may be null
    explicit Names(const TakenNames* taken = nullptr, Of of = Of::Declarations) : taken_(taken), of_(of), scopes_(1) {
        next_.reserve(64);
    }
    Names(const Names&) = delete;

    // Makes a name from the wanted one that is free in every open scope, and takes it in the innermost scope.
    std::string declare(std::string_view wanted);
    bool is_free(std::string_view name) const;
    void open() { scopes_.emplace_back(); }
    // Frees the names of the innermost scope.
    void close();

private:
    struct Taken {
        const std::string* name;  // in next_
        unsigned* number;         // the counter of the wanted name: also in next_
    };
    bool is_taken(const std::string& name) const {
        return taken_ && (of_ == Of::Members ? taken_->macros : taken_->names).contains(name);
    }

    const TakenNames* taken_;
    Of of_;
    std::unordered_map<std::string, unsigned> next_;  // taken names, and the number for the next clash
    std::vector<std::vector<Taken>> scopes_;
};

}  // namespace patina::languages
