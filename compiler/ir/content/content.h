// What a function is made of, as bytes. Two functions with equal bytes are equal but for the places of their nodes in
// the text (Span), and for the numbers that their modules give to constants, names, origins, structs and arrays. The
// bytes are keys of kept results (base/remembered.h); nobody reads them.
//
//   Content content(module);
//   content.function(module.functions[2]);
//   kept.find(content.bytes());
#pragma once

#include <cstring>
#include <optional>
#include <unordered_map>

#include "compiler/ir/ir.h"

namespace patina::ir {

class Content {
public:
    explicit Content(const Module& module)
        : module_(module),
          names_(module.names.size()),
          origins_(module.origins.size()),
          constants_(module.constants.size()),
          structs_(module.structs.size()),
          arrays_(module.arrays.size()) {}

    // --- the parts, one after the other
    void number(std::uint64_t value) { put(value); }
    void text(std::string_view value) {
        number(value.size());
        raw(value.data(), value.size());
    }
    void type(Type type);
    void variable(const StageVariable& variable);
    void global(const Global& global);
    void block(const UniformBlock& block);
    void member(const BlockMember& member);
    void keyword(const Keyword& keyword);
    void texts(const std::vector<StageText>& texts);
    // `callee(index)` and `read(index)` give the numbers that are written for the functions that it calls and the
    // globals that it reads. What these numbers mean, the caller adds.
    template <class Callee, class Read>
    void function(const Function& function, const Callee& callee, const Read& read) {
        signature(function);
        for (const Inst& inst : function.insts)
            instruction(function, inst,
                        inst.op == Op::Call     ? callee(inst.data)
                        : inst.op == Op::Global ? read(inst.data)
                                                : inst.data);
        blocks(function);
    }

    std::string_view bytes() const { return std::string_view(bytes_).substr(0, size_); }
    // Without the room that more bytes would have had: keys are kept long, and their sizes are counted.
    std::string take() const { return std::string(bytes()); }
    // The origins that have been mentioned, in order of first mention.
    const std::vector<OriginId>& origins() const { return mentioned_; }
    // The structs that have been mentioned, as indices, in order of first mention. More may come while they are read.
    const std::vector<std::uint32_t>& structs() const { return mentioned_structs_; }
    // The different places of these origins, in order.
    const std::vector<Span>& spans() const { return spans_; }
    std::optional<std::uint32_t> place_of(Span span) const;

private:
    // Most parts are a few bytes: a call of a function for each would take longer than the rest.
    template <class Part>
    void put(const Part& part) {
        if (size_ + sizeof part > bytes_.size()) grow(sizeof part);
        std::memcpy(&bytes_[size_], &part, sizeof part);
        size_ += sizeof part;
    }
    void raw(const void* data, std::size_t size);
    void grow(std::size_t more);
    void signature(const Function& function);
    void instruction(const Function& function, const Inst& inst, std::uint32_t data);
    void blocks(const Function& function);
    void constant(std::uint32_t index);
    bool is_new(OriginId id);  // and from now on it is mentioned
    void origin(OriginId id);

    const Module& module_;
    std::string bytes_;  // longer than what has been written
    std::size_t size_ = 0;
    // By index in the module: the place in the order of first mention, from 1; 0: not mentioned yet.
    std::vector<std::uint32_t> names_, origins_, constants_, structs_, arrays_;
    std::uint32_t last_name_ = 0, last_constant_ = 0, last_array_ = 0;
    std::vector<OriginId> mentioned_;
    std::vector<std::uint32_t> mentioned_structs_;
    std::vector<Span> spans_;
    std::unordered_map<std::uint64_t, std::uint32_t> places_;  // of spans_, by both ends
};

}  // namespace patina::ir
