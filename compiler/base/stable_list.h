// A list that only grows, and whose elements never move: references to them stay valid, also when the list itself is
// moved. Unlike a std::deque, an empty list allocates nothing: the library has thousands of lists, and most of them are
// empty.
//
//   StableList<Expr> exprs;
//   Expr* made = &exprs.emplace_back(...);   // valid as long as the list
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace patina {

template <class T>
class StableList {
public:
    class const_iterator {
    public:
        using iterator_category = std::forward_iterator_tag;
        using value_type = T;
        using difference_type = std::ptrdiff_t;
        using pointer = const T*;
        using reference = const T&;

        const_iterator() = default;
        const_iterator(const StableList* list, std::size_t chunk) : list_(list), chunk_(chunk) {}
        const T& operator*() const { return list_->chunks_[chunk_][at_]; }
        const T* operator->() const { return &**this; }
        const_iterator& operator++() {
            if (++at_ == list_->chunks_[chunk_].size()) {
                ++chunk_;
                at_ = 0;
            }
            return *this;
        }
        const_iterator operator++(int) {
            const const_iterator before = *this;
            ++*this;
            return before;
        }
        friend bool operator==(const const_iterator&, const const_iterator&) = default;

    private:
        const StableList* list_ = nullptr;
        std::size_t chunk_ = 0, at_ = 0;
    };

    bool empty() const { return chunks_.empty(); }
    std::size_t size() const { return size_; }
    const_iterator begin() const { return {this, 0}; }
    const_iterator end() const { return {this, chunks_.size()}; }
    const T& front() const { return chunks_.front().front(); }
    const T& back() const { return chunks_.back().back(); }
    // Steps from chunk to chunk.
    const T& operator[](std::size_t index) const {
        std::size_t chunk = 0;
        while (index >= chunks_[chunk].size()) index -= chunks_[chunk++].size();
        return chunks_[chunk][index];
    }

    template <class... Args>
    T& emplace_back(Args&&... args) {
        if (chunks_.empty() || chunks_.back().size() == chunks_.back().capacity())
            add_chunk(std::forward<Args>(args)...);
        else
            chunks_.back().emplace_back(std::forward<Args>(args)...);
        ++size_;
        return chunks_.back().back();
    }
    T& push_back(T value) { return emplace_back(std::move(value)); }

private:
    static constexpr std::size_t kFirst = 4, kMost = 256;  // elements of a chunk

    // With its first element. If that cannot be made, the list is as it was.
    template <class... Args>
    void add_chunk(Args&&... args) {
        const std::size_t count = chunks_.empty() ? kFirst : std::min(2 * chunks_.back().capacity(), kMost);
        std::vector<T> chunk;
        chunk.reserve(count);
        chunk.emplace_back(std::forward<Args>(args)...);
        chunks_.push_back(std::move(chunk));
    }

    // None is empty. A chunk never grows beyond what was reserved for it.
    std::vector<std::vector<T>> chunks_;
    std::size_t size_ = 0;
};

}  // namespace patina
