// The store of the functions that have been emitted. A function of the language becomes several IR functions
// ("instances"): one for each width of floatN, each precision, each list of constant arguments and each view of its
// textures in a call.
//
// An instance is passing if its body depends on a result of Known::make_static that is valid only for the pass that is
// now lowered. The code that gives such an answer calls note_passing_answer(); forget_passing() then drops these
// instances, and they are emitted again for the next pass.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "compiler/emit/scope.h"

namespace patina::emit {

struct Instance {
    ir::FunctionId id;  // null if the body has an error
    ir::Type result{};
    const Outputs* outputs = nullptr;
    bool needs_quad = false;
    double rounds = 0;  // of its loops
    bool is_passing = false;
};

struct InstanceKey {
    const FunctionDecl* function = nullptr;
    unsigned width = 0;
    bool half = false;
    std::vector<std::uint64_t> constants{};  // the bits of the constant arguments, which are doubles
    std::vector<std::uint32_t> textures{};   // the struct types of its textures, one for each view
    friend bool operator<(const InstanceKey& a, const InstanceKey& b) {
        const auto key = [](const InstanceKey& k) {
            return std::tie(k.function, k.width, k.half, k.constants, k.textures);
        };
        return key(a) < key(b);
    }
};

// One of the instances of a function.
struct InstanceInfo {
    ir::FunctionId id;
    bool half = false;
};

class Instances {
public:
    // Null if there is none yet. A passing instance makes the function that calls it passing too.
    const Instance* find(const InstanceKey& key);
    const Instance& add(const InstanceKey& key, const Instance& instance) { return made_[key] = instance; }
    // Those without an error.
    std::vector<InstanceInfo> of(const FunctionDecl& function) const;

    void note_passing_answer() { ++passing_answers_; }
    // Counts answers and uses of passing instances: what is emitted while the number grows is passing.
    unsigned passing_answers() const { return passing_answers_; }
    void forget_passing();

private:
    std::map<InstanceKey, Instance> made_;
    unsigned passing_answers_ = 0;
};

}  // namespace patina::emit
