// Results that are kept because a later request may have the same key. Any thread may use the object. If a key gets a
// second result, the cache has that result from then on.
//
//   Cache<Result> results(16 << 20);
//   const auto [cached, is_asked_again] = results.ask(key);
//   if (cached) return *cached;
//   if (is_asked_again) results.keep(key, made, size_of(made));
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace patina {

template <class Value>
class Cache {
public:
    // `most`: about how many bytes of keys, values and entries are kept.
    explicit Cache(std::size_t most) : most_(most), asked_(kMostAsked) {}

    struct Answer {
        std::shared_ptr<const Value> value;  // null if there is none
        // If so, the value that is made now should be kept. Most requests of a new graph never come again. To cache
        // their results would take more time and memory than it can save.
        bool is_asked_again = false;
    };
    Answer ask(std::string_view key) {
        const auto [entry, is_asked_again] = look_up(hash_of(key));
        if (!entry || entry->key != key) return {nullptr, is_asked_again};
        return {{entry, &entry->value}, is_asked_again};
    }

    // `bytes`: about how many the value has.
    void keep(std::string key, Value value, std::size_t bytes) {
        const std::uint64_t hash = hash_of(key);
        const std::size_t size = sizeof(Entry) + key.size() + bytes;
        auto entry = std::make_shared<const Entry>(Entry{std::move(key), std::move(value), size});
        const std::lock_guard lock(mutex_);
        add(hash, std::move(entry));
    }

private:
    struct Entry {
        std::string key;
        Value value;
        std::size_t size = 0;
    };
    static constexpr std::size_t kMostAsked = 8192;
    using Entries = std::unordered_map<std::uint64_t, std::shared_ptr<const Entry>>;  // by the hash of the key

    // Keys are long, so it reads eight letters at a time. It need not be strong, because ask() compares the keys.
    static std::uint64_t hash_of(std::string_view key) {
        std::uint64_t hash = key.size();
        const auto add = [&](std::uint64_t letters) {
            hash = (hash ^ letters) * 0x9e3779b97f4a7c15u;  // 2^64 over the golden ratio
            hash ^= hash >> 29;
        };
        std::uint64_t letters = 0;
        for (; key.size() >= sizeof letters; key.remove_prefix(sizeof letters)) {
            std::memcpy(&letters, key.data(), sizeof letters);
            add(letters);
        }
        letters = 0;
        if (!key.empty()) std::memcpy(&letters, key.data(), key.size());
        add(letters);
        return hash;
    }

    std::pair<std::shared_ptr<const Entry>, bool> look_up(std::uint64_t hash) {
        const std::lock_guard lock(mutex_);
        const auto mark = static_cast<std::uint32_t>(hash >> 32);
        const bool is_asked_again = std::exchange(asked_[hash % kMostAsked], mark) == mark;
        return {entry_of(hash), is_asked_again};
    }

    // What is used again moves to the newer half.
    std::shared_ptr<const Entry> entry_of(std::uint64_t hash) {
        if (const auto found = newer_.find(hash); found != newer_.end()) return found->second;
        const auto found = older_.find(hash);
        if (found == older_.end()) return nullptr;
        std::shared_ptr<const Entry> entry = std::move(found->second);
        older_.erase(found);
        add(hash, entry);
        return entry;
    }

    // If the newer half is full, it becomes the older one, and the older one is dropped.
    void add(std::uint64_t hash, std::shared_ptr<const Entry> entry) {
        const std::size_t size = entry->size;
        if (size > most_ / 2) return;
        if (size_ + size > most_ / 2) {
            older_ = std::exchange(newer_, {});
            size_ = 0;
        }
        std::shared_ptr<const Entry>& place = newer_[hash];
        size_ += size - (place ? place->size : 0);
        place = std::move(entry);
    }

    std::size_t most_;
    std::mutex mutex_;
    // Halves of the hashes of the keys that were asked for last. Another one may take the place.
    std::vector<std::uint32_t> asked_;
    Entries newer_, older_;
    std::size_t size_ = 0;  // of newer_
};

}  // namespace patina
