#include "patina/spirv_size.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>

namespace patina {
namespace {

constexpr std::uint32_t kMagic = 0x07230203u;
constexpr std::size_t kHeaderWords = 5;

// SPIR-V specification, section 3.49.
enum Opcode : std::uint32_t {
    kFunction = 54,
    kFunctionEnd = 56,
    kFunctionCall = 57,
    kLoopMerge = 246,
    kLabel = 248,
    kBranch = 249,
    kBranchConditional = 250,
    kSwitch = 251,
};

// A block, or a whole function.
struct Block {
    std::size_t instructions = 0;
    std::vector<std::uint32_t> calls{};       // ids of functions, one for each call
    std::vector<std::uint32_t> successors{};  // labels
    std::uint32_t loop_end = 0;               // if the block is a loop's header: the label after the loop
};

struct Function {
    Block whole{};
    std::map<std::uint32_t, Block> blocks{};  // by label
    std::vector<std::uint32_t> order{};       // labels in the order of the text
};

class Reader {
public:
    explicit Reader(std::span<const std::uint32_t> spirv) {
        for (std::size_t at = kHeaderWords; at < spirv.size();) {
            const std::size_t words = std::max<std::size_t>(spirv[at] >> 16, 1);
            instruction(spirv.subspan(at, std::min(words, spirv.size() - at)));
            at += words;
        }
    }

    SpirvSize size() const {
        SpirvSize size = size_;
        for (const auto& [id, function] : functions_) add_loops(function, size);
        return size;
    }

private:
    void instruction(std::span<const std::uint32_t> words) {
        const std::uint32_t op = words[0] & 0xffffu;
        ++size_.instructions;
        if (op == kFunction && words.size() > 2) {
            function_ = &functions_[words[2]];
            block_ = nullptr;
        }
        if (!function_) return;
        ++size_.in_functions;
        ++function_->whole.instructions;
        if (op == kLabel && words.size() > 1) {
            block_ = &function_->blocks[words[1]];
            function_->order.push_back(words[1]);
        }
        if (block_) in_block(op, words);
        if (op == kFunctionEnd) function_ = nullptr;
    }

    void in_block(std::uint32_t op, std::span<const std::uint32_t> words) {
        ++block_->instructions;
        const auto word = [&](std::size_t i) { return i < words.size() ? words[i] : 0u; };
        if (op == kFunctionCall) {
            block_->calls.push_back(word(3));
            function_->whole.calls.push_back(word(3));
        } else if (op == kLoopMerge) {
            block_->loop_end = word(1);
        } else if (op == kBranch) {
            block_->successors = {word(1)};
        } else if (op == kBranchConditional) {
            block_->successors = {word(2), word(3)};
        } else if (op == kSwitch) {
            block_->successors = {word(2)};
            for (std::size_t i = 4; i < words.size(); i += 2) block_->successors.push_back(words[i]);
        }
    }

    // SPIR-V has no recursion.
    std::size_t with_calls(const Block& block) const {
        std::size_t count = block.instructions;
        for (const std::uint32_t callee : block.calls) {
            const auto found = functions_.find(callee);
            if (found != functions_.end()) count += with_calls(found->second.whole);
        }
        return count;
    }

    void add_loops(const Function& function, SpirvSize& size) const {
        std::set<std::uint32_t> counted;
        for (const std::uint32_t label : function.order) {
            if (function.blocks.at(label).loop_end == 0 || counted.contains(label)) continue;
            ++size.loops;
            // All blocks that are reached from the header before the end.
            std::vector<std::uint32_t> work = {label};
            while (!work.empty()) {
                const std::uint32_t at = work.back();
                work.pop_back();
                const auto block = function.blocks.find(at);
                if (at == function.blocks.at(label).loop_end || block == function.blocks.end()) continue;
                if (!counted.insert(at).second) continue;
                size.in_loops += with_calls(block->second);
                work.insert(work.end(), block->second.successors.begin(), block->second.successors.end());
            }
        }
    }

    SpirvSize size_;
    std::map<std::uint32_t, Function> functions_;
    Function* function_ = nullptr;
    Block* block_ = nullptr;
};

}  // namespace

SpirvSize size_of(const std::vector<std::uint32_t>& spirv) {
    if (spirv.size() < kHeaderWords || spirv[0] != kMagic) return {};
    return Reader(spirv).size();
}

}  // namespace patina
