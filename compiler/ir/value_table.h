// A hash table of values for value numbering: it remembers in which order values came, so that a scope is left by
// shrinking it to an earlier size. Knows nothing of instructions: the caller brings the hash and the comparison. One
// allocation per doubling, none per value.
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
    std::size_t size() const { return entries_.size(); }

    void reserve(std::size_t count) {
        if (slots_.size() < 2 * count) grow(std::bit_ceil(2 * count));
    }

    template <class Equal>
    Value find(std::uint32_t hash, const Equal& equal) const {
        if (slots_.empty()) return {};
        for (std::uint32_t slot = hash & mask(); slots_[slot] != kFree; slot = (slot + 1) & mask()) {
            const Entry& entry = entries_[slots_[slot]];
            if (entry.hash == hash && equal(entry.value)) return entry.value;
        }
        return {};
    }

    void insert(std::uint32_t hash, Value value) {
        entries_.push_back({hash, value});
        if (2 * entries_.size() > slots_.size()) {
            grow(slots_.empty() ? 32 : 2 * slots_.size());
        } else {
            place(static_cast<std::uint32_t>(entries_.size() - 1));
        }
    }

    // Entries leave in the opposite order of their coming, so whatever was placed because of a later one is gone
    // already, and freeing a slot breaks no probe sequence.
    void shrink(std::size_t size) {
        while (entries_.size() > size) {
            const auto last = static_cast<std::uint32_t>(entries_.size() - 1);
            std::uint32_t slot = entries_[last].hash & mask();
            while (slots_[slot] != last) slot = (slot + 1) & mask();
            slots_[slot] = kFree;
            entries_.pop_back();
        }
    }

private:
    struct Entry {
        std::uint32_t hash;
        Value value;
    };
    static constexpr std::uint32_t kFree = 0xffffffffu;

    std::uint32_t mask() const { return static_cast<std::uint32_t>(slots_.size() - 1); }

    void place(std::uint32_t index) {
        std::uint32_t slot = entries_[index].hash & mask();
        while (slots_[slot] != kFree) slot = (slot + 1) & mask();
        slots_[slot] = index;
    }

    void grow(std::size_t slots) {
        entries_.reserve(slots / 2);
        slots_.assign(slots, kFree);
        for (std::uint32_t index = 0; index < entries_.size(); index++) place(index);
    }

    std::vector<std::uint32_t> slots_;  // a power of two of them, at most half full
    std::vector<Entry> entries_;
};

}  // namespace patina::ir
