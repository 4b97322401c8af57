#include "compiler/lower/place.h"

#include <algorithm>

namespace patina::lower {
namespace {

bool is_texture(const ir::Global& global) {
    return global.type.is_texture();
}

bool is_sampler(const ir::Global& global) {
    return global.type.kind == ir::Kind::Sampler;
}

// How many blocks or textures an owner has, and which number each has among them. A sampler has the number of the
// texture before it; samplers before the first texture are numbered after all others.
class Numbers {
public:
    explicit Numbers(const std::map<std::string, std::uint32_t, std::less<>>* known) : known_(known) {}

    std::uint32_t of(const std::string& name) { return known_ ? known_->at(name) : next_++; }
    std::uint32_t count(std::size_t declared) const {
        return static_cast<std::uint32_t>(known_ ? known_->size() : declared);
    }

private:
    const std::map<std::string, std::uint32_t, std::less<>>* known_;  // null: in the order of declaration
    std::uint32_t next_ = 0;
};

}  // namespace

std::vector<SetShifts> place_globals(ir::Module& module, const engines::Engine& engine, const Numbering& numbering) {
    std::vector<SetShifts> shifts;
    for (const ir::Group group : {ir::Group::Engine, ir::Group::Material, ir::Group::Targets}) {
        const engines::Places& places = engine.places_of(group);
        const auto count = [&](const auto& all, const auto& is_kind) {
            return static_cast<std::size_t>(std::count_if(
                all.begin(), all.end(), [&](const auto& each) { return each.group == group && is_kind(each); }));
        };
        const bool is_library = group != ir::Group::Material;
        Numbers blocks(group == ir::Group::Engine ? &numbering.blocks : nullptr);
        Numbers textures(is_library ? &numbering.textures[static_cast<std::size_t>(group)] : nullptr);
        SetShifts first{.set = places.set, .buffers = places.buffers.value_or(0)};
        first.textures = places.textures.value_or(
            first.buffers + blocks.count(count(module.blocks, [](const ir::UniformBlock&) { return true; })));
        first.samplers = places.samplers.value_or(first.textures + textures.count(count(module.globals, is_texture)));
        // Owners that share a set share its registers, so all of them have the same distance from the bindings.
        auto shift =
            std::find_if(shifts.begin(), shifts.end(), [&](const SetShifts& each) { return each.set == places.set; });
        if (shift == shifts.end()) shift = shifts.insert(shift, first);
        const auto place = [&](std::uint32_t binding, std::uint32_t distance) {
            return ir::BindingPlace{.set = places.set, .binding = binding, .slot = binding - distance};
        };
        for (ir::UniformBlock& block : module.blocks) {
            if (block.group != group) continue;
            block.place = place(first.buffers + blocks.of(block.name), shift->buffers);
            block.matrices_by_rows = engine.matrices == MatrixOrder::Rows;
        }
        const auto texture_count = textures.count(count(module.globals, is_texture));
        std::uint32_t number = 0, before_textures = 0;
        bool has_texture = false;
        for (ir::Global& global : module.globals) {
            if (global.group != group || global.in_block()) continue;
            if (is_texture(global)) {
                number = textures.of(global.name);
                has_texture = true;
                global.place = place(first.textures + number, shift->textures);
            }
            if (!is_sampler(global)) continue;
            // The sampler follows its texture, or the first of the textures that share it.
            const std::uint32_t own = has_texture ? number : texture_count + before_textures++;
            global.place = place(first.samplers + own, shift->samplers);
        }
    }
    return shifts;
}

}  // namespace patina::lower
