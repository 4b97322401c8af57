// What a pure function made of its inputs, kept so that the next caller with equal inputs need not compute it. The key
// holds all that the function reads, not a hash of it, so equal keys give equal values. Any thread may ask. What nobody
// has asked for lately is dropped when the values together pass a number of bytes.
//
//   Remembered<std::string, Text> texts(1 << 20);
//   std::shared_ptr<const Text> text = texts.find(key);
//   if (!text) text = texts.keep(std::move(key), std::make_shared<const Text>(print(...)), bytes);
#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>

namespace patina {

template <class Key, class Value, class Hash = std::hash<Key>>
class Remembered {
public:
    explicit Remembered(std::size_t most_bytes) : most_bytes_(most_bytes) {}

    // Null if it is not known.
    std::shared_ptr<const Value> find(const Key& key) {
        const std::lock_guard lock(mutex_);
        const auto found = entries_.find(key);
        if (found == entries_.end()) return nullptr;
        by_use_.splice(by_use_.begin(), by_use_, found->second.place);
        return found->second.value;
    }

    // Returns the value that is kept: that of another thread, if it came first. A value that would fill more than a
    // quarter of the room is not kept.
    std::shared_ptr<const Value> keep(Key key, std::shared_ptr<const Value> value, std::size_t bytes) {
        if (bytes > most_bytes_ / 4) return value;
        const std::lock_guard lock(mutex_);
        const auto [entry, is_new] = entries_.try_emplace(std::move(key));
        if (!is_new) return entry->second.value;
        by_use_.push_front(&entry->first);
        entry->second = {.value = value, .bytes = bytes, .place = by_use_.begin()};
        bytes_ += bytes;
        while (bytes_ > most_bytes_) drop_oldest();
        return value;
    }

private:
    struct Entry {
        std::shared_ptr<const Value> value{};
        std::size_t bytes = 0;
        typename std::list<const Key*>::iterator place{};
    };

    void drop_oldest() {
        const auto oldest = entries_.find(*by_use_.back());
        by_use_.pop_back();
        bytes_ -= oldest->second.bytes;
        entries_.erase(oldest);
    }

    const std::size_t most_bytes_;
    std::mutex mutex_;
    std::size_t bytes_ = 0;
    std::unordered_map<Key, Entry, Hash> entries_;
    std::list<const Key*> by_use_;  // the latest first
};

}  // namespace patina
