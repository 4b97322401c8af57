// A hash table of values for value numbering. It remembers the order in which values came, so that the builder can
// leave a scope by shrinking the table to an earlier size. It does not look at instructions: the caller gives the hash
// and the comparison. It allocates when it doubles, and not for each value.
//
//   std::size_t outer = table.size();
//   table.insert(hash, value);
//   Value same = table.find(hash, [&](Value v) { return equal(v); });
//   table.shrink(outer);
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "compiler/ir/ir.h"

namespace patina::ir {

class ValueTable {
public:
    std::size_t size() const { return size_; }

    void reserve(std::size_t count) {
        if (slots_.size() < 2 * count) grow(std::bit_ceil(2 * count));
    }

    template <class Equal>
    Value find(std::uint32_t hash, const Equal& equal) const {
        if (slots_.empty()) return {};
        for (std::uint32_t at = hash & mask(); slots_[at].value; at = (at + 1) & mask()) {
            if (slots_[at].hash == hash && equal(slots_[at].value)) return slots_[at].value;
        }
        return {};
    }

    void insert(std::uint32_t hash, Value value) {
        if (2 * (size_ + 1) > slots_.size()) grow(slots_.empty() ? 32 : 2 * slots_.size());
        place(hash, value);
    }

    // Values leave in the opposite order of their coming. So all values that were placed because of a later one have
    // left before, and freeing a slot breaks no probe sequence.
    void shrink(std::size_t size) {
        while (size_ > size) {
            Slot& last = slots_[last_];
            last_ = last.before;
            last.value = {};
            size_--;
        }
    }

private:
    struct Slot {
        std::uint32_t hash = 0;
        Value value{};             // none: free
        std::uint32_t before = 0;  // slot of the value that came before this one
    };

    std::uint32_t mask() const { return static_cast<std::uint32_t>(slots_.size() - 1); }

    void place(std::uint32_t hash, Value value) {
        std::uint32_t at = hash & mask();
        while (slots_[at].value) at = (at + 1) & mask();
        slots_[at] = {hash, value, last_};
        last_ = at;
        size_++;
    }

    void grow(std::size_t count) {
        std::vector<Slot> in_order(size_), larger(count);  // both before anything changes: either may fail
        for (std::size_t i = size_; i-- > 0; last_ = slots_[last_].before) in_order[i] = slots_[last_];
        slots_ = std::move(larger);
        size_ = 0;
        for (const Slot& slot : in_order) place(slot.hash, slot.value);
    }

    std::vector<Slot> slots_;  // a power of two of them, at most half full
    std::uint32_t last_ = 0;
    std::size_t size_ = 0;
};

}  // namespace patina::ir
