#include "compiler/validate/expand_calls.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace patina::spirv {
namespace {

constexpr std::size_t kHeaderWords = 5;
constexpr std::size_t kBoundWord = 3;  // of the header: above all ids

bool is_about_an_id(spv::Op op) {
    return op == spv::OpName || op == spv::OpMemberName || op == spv::OpDecorate || op == spv::OpMemberDecorate;
}

class Expansion {
public:
    Expansion(const Spirv& module, const std::function<bool(std::uint32_t)>& is_owner)
        : module_(module), is_owner_(is_owner), bound_(module.words[kBoundWord]) {
        for (const Function& function : functions_of(module)) {
            functions_[function.id] = function;
            for (std::size_t i = function.begin; i < function.end; ++i)
                if (const std::uint32_t id = module.instructions[i].result) copies_[id];
        }
    }

    std::vector<std::uint32_t> run() {
        // The entry point is the first copy of its function, and keeps its ids.
        const std::uint32_t entry = entry_of(module_);
        if (!functions_.contains(entry)) return {};
        made_[{entry, 0}] = entry;
        copy_function(functions_[entry], {entry, 0}, true);
        while (!waiting_.empty()) {
            const Wanted wanted = waiting_.back();
            waiting_.pop_back();
            copy_function(functions_[wanted.function], wanted, false);
        }
        std::vector<std::uint32_t> words(module_.words.begin(), module_.words.begin() + kHeaderWords);
        add_declarations(words);
        words.insert(words.end(), body_.begin(), body_.end());
        words[kBoundWord] = bound_;
        return words;
    }

private:
    struct Wanted {
        std::uint32_t function = 0, call_line = 0;
        auto operator<=>(const Wanted&) const = default;
    };

    std::uint32_t copy_for(std::uint32_t function, std::uint32_t call_line) {
        const auto [found, is_new] = made_.emplace(Wanted{function, call_line}, bound_);
        if (is_new) {
            ++bound_;
            waiting_.push_back(found->first);
        }
        return found->second;
    }

    void copy_function(const Function& function, const Wanted& wanted, bool keeps_ids) {
        std::unordered_map<std::uint32_t, std::uint32_t> ids;
        for (std::size_t i = function.begin; i < function.end; ++i) {
            const std::uint32_t id = module_.instructions[i].result;
            if (id == 0) continue;
            ids[id] = keeps_ids ? id : id == function.id ? made_.at(wanted) : bound_++;
            copies_[id].push_back(ids[id]);
        }
        for (std::size_t i = function.begin; i < function.end; ++i)
            copy_instruction(module_.instructions[i], ids, wanted.call_line);
    }

    void copy_instruction(const Instruction& at, const std::unordered_map<std::uint32_t, std::uint32_t>& ids,
                          std::uint32_t call_line) {
        const std::size_t begin = body_.size();
        body_.insert(body_.end(), at.words.begin(), at.words.end());
        const std::span<std::uint32_t> words(body_.begin() + std::ptrdiff_t(begin), body_.end());
        if (at.op == spv::OpLine) words[3] = call_line;
        if (at.result != 0) words[at.type != 0 ? 2 : 1] = ids.at(at.result);
        for (const std::uint16_t word : at.reads) {
            const auto own = ids.find(words[word]);
            if (own != ids.end()) words[word] = own->second;
        }
        if (at.op == spv::OpFunctionCall) {
            const bool is_owner = call_line == 0 || is_owner_(at.line);
            const std::uint32_t copy = copy_for(at.words[3], is_owner ? at.line : call_line);
            body_[begin + 3] = copy;
        }
    }

    // What comes before the functions. What is said of an id holds for all its copies.
    void add_declarations(std::vector<std::uint32_t>& words) const {
        for (const Instruction& at : module_.instructions) {
            if (at.op == spv::OpFunction) return;
            const auto copies = is_about_an_id(at.op) ? copies_.find(at.words[1]) : copies_.end();
            if (copies == copies_.end()) {
                words.insert(words.end(), at.words.begin(), at.words.end());
                continue;
            }
            for (const std::uint32_t copy : copies->second) {
                words.insert(words.end(), at.words.begin(), at.words.end());
                words[words.size() - at.words.size() + 1] = copy;
            }
        }
    }

    const Spirv& module_;
    const std::function<bool(std::uint32_t)>& is_owner_;
    std::uint32_t bound_;
    std::unordered_map<std::uint32_t, Function> functions_;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> copies_;  // of ids that functions define
    std::map<Wanted, std::uint32_t> made_;
    std::vector<Wanted> waiting_;
    std::vector<std::uint32_t> body_;
};

}  // namespace

std::vector<std::uint32_t> expand_calls(const Spirv& module, const std::function<bool(std::uint32_t line)>& is_owner) {
    return module.instructions.empty() ? std::vector<std::uint32_t>() : Expansion(module, is_owner).run();
}

}  // namespace patina::spirv
