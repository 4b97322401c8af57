#include "compiler/link/known_passes.h"

#include <cstring>
#include <memory>
#include <utility>

namespace patina::link {
namespace {

// Appends values to a key. What has no fixed length has its length before it, so no two lists of values make one key.
class Key {
public:
    template <class Number>
    requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
    void add(Number number) { std::memcpy(grow(sizeof number), &number, sizeof number); }
    template <class Tag>
    void add(Id<Tag> id) {
        add(id.index);
    }
    void add(const void* address) { append(&address, sizeof address); }
    void add(std::string_view text) {
        add(text.size());
        append(text.data(), text.size());
    }
    void add(const std::string& text) { add(std::string_view(text)); }
    void add(ir::Type type) { add(packed(type)), add(type.ref); }
    template <class Item>
    void add(const std::vector<Item>& list) {
        add(list.size());
        for (const Item& item : list) add(item);
    }
    template <class Item>
    void add(const std::optional<Item>& item) {
        add(item.has_value());
        if (item) add(*item);
    }

    void add(const ir::Param& p) { add(p.name), add(p.type), add(p.rate), add(p.is_semantic), add(p.from_bottom); }
    void add(const ir::StageText& text) { add(text.place), add(text.line); }
    void add(const ir::Block& block) { add_ids(block.insts); }
    void add(const ir::Member& member) { add(member.name), add(member.type); }
    void add(const ir::Struct& structure) { add(structure.name), add(structure.members); }
    void add(const ir::Array& array) { add(array.element), add(array.count); }
    void add(const ir::Constant& constant) { add(constant.type), add(constant.first); }
    void add(const ir::Place& place) { add(place.set), add(place.binding), add(place.slot); }
    void add(const ir::BlockMember& m) {
        add(m.name), add(m.type), add(m.offset), add(m.padding), add(m.stored_as), add(m.is_of_instance);
        add(m.declared_in);
    }
    void add(const ir::UniformBlock& block) {
        add(block.name), add(block.group), add(block.place), add(block.matrices_by_rows), add(block.size);
        add(block.members);
    }
    void add(const ir::Global& g) {
        add(g.name), add(g.type), add(g.block), add(g.member), add(g.keyword), add(g.group), add(g.place);
        add(g.spelling), add(g.decoder), add(g.follower), add(g.at_once), add(g.is_of_object), add(g.from_bottom);
    }
    void add(const ir::Keyword& k) { add(k.property), add(k.constant_id), add(k.value), add(k.values); }
    void add(const ir::Semantic& s) { add(s.name), add(s.type), add(s.rate), add(s.from_bottom); }
    void add(const ir::Origin& origin) { add(origin.label), add(origin.is_note), add(origin.id); }
    void add(const ir::Function& f) {
        add(f.name), add(f.params), add(f.result);
        add_insts(f.insts);
        add_ids(f.operands);
        add(f.blocks), add(f.origin), add(f.comment), add(f.result_docs), add(f.always_inline), add(f.linkage);
        add(f.spelling), add(f.texts), add(f.is_of_object);
    }
    void add(const graph::SemanticRecipe& s) {
        add(s.source), add(s.recipe), add(s.location), add(s.hlsl), add(s.override);
        add(static_cast<const void*>(s.declaration));
    }
    template <class What>
    void add(const graph::Given<What>& given) {
        add(given.what), add(given.by), add(given.in_vertex_stage), add(given.in_fragment_stage);
    }

    std::string take() const { return {begin_.get(), size_}; }

private:
    static std::uint32_t packed(ir::Type type) {
        return static_cast<std::uint32_t>(type.kind) | static_cast<std::uint32_t>(type.scalar) << 8 |
               static_cast<std::uint32_t>(type.rows) << 16 | static_cast<std::uint32_t>(type.cols) << 24;
    }
    // Room for so many bytes more.
    char* grow(std::size_t by) {
        if (room_ - size_ < by) make_room(by);
        return begin_.get() + std::exchange(size_, size_ + by);
    }
    void make_room(std::size_t by) {
        room_ = 2 * room_ + by;
        std::unique_ptr<char[]> wider(new char[room_]);
        std::memcpy(wider.get(), begin_.get(), size_);
        begin_ = std::move(wider);
    }
    void append(const void* data, std::size_t size) {
        char* const to = grow(size);
        if (size > 0) std::memcpy(to, data, size);
    }
    template <class Tag>
    void add_ids(const std::vector<Id<Tag>>& ids) {
        static_assert(std::has_unique_object_representations_v<Id<Tag>>);
        add(ids.size());
        append(ids.data(), ids.size() * sizeof ids[0]);
    }
    // Most of a key. An Inst has padding, so it is not copied as it is.
    void add_insts(const std::vector<ir::Inst>& insts) {
        using Words = std::uint32_t[8];
        add(insts.size());
        char* to = grow(insts.size() * sizeof(Words));
        for (const ir::Inst& inst : insts) {
            const std::uint32_t op = static_cast<std::uint32_t>(inst.op) | (inst.is_light_loop ? 0x100u : 0u);
            const Words words = {op,        packed(inst.type), inst.type.ref,  inst.first_operand, inst.operand_count,
                                 inst.data, inst.origin.index, inst.name.index};
            std::memcpy(to, words, sizeof words);
            to += sizeof words;
        }
    }

    std::size_t room_ = 100'000;  // enough for most materials
    std::unique_ptr<char[]> begin_{new char[room_]};
    std::size_t size_ = 0;
};

}  // namespace

std::string key_of(const Linked& linked, const engines::Engine& engine) {
    const graph::Lowered& lowered = linked.lowered;
    const ir::Module& module = lowered.module;
    Key key;
    key.add(static_cast<const void*>(&engine));
    key.add(linked.functions);
    key.add(linked.needs);
    key.add(module.structs), key.add(module.arrays), key.add(module.constants), key.add(module.numbers);
    key.add(module.blocks), key.add(module.globals), key.add(module.keywords), key.add(module.tests_keywords);
    key.add(module.has_values_from_bottom), key.add(module.semantics), key.add(module.origins), key.add(module.names);
    key.add(lowered.semantics);
    key.add(lowered.picture_reads.size());
    for (const std::uint32_t global : lowered.picture_reads) key.add(global);
    key.add(lowered.wraps.position), key.add(lowered.wraps.pixel), key.add(lowered.wraps.reads);
    key.add(lowered.wraps.own_pixel);
    key.add(lowered.keeps_functions);
    return key.take();
}

std::string key_of(const std::string& key_of_material, const graph::LoweredPass& pass) {
    Key key;
    key.add(static_cast<const void*>(pass.declaration));
    key.add(pass.vertex), key.add(pass.fragment), key.add(pass.recipes), key.add(pass.replaced);
    key.add(pass.attributes.size());
    for (const auto& [semantic, global] : pass.attributes) key.add(semantic), key.add(global);
    return key_of_material + key.take();
}

// Measured: the stages of the examples have a quarter to the whole of their key's bytes, because the key has functions
// of all passes.
std::size_t bytes_of(const std::string& key) {
    return 2 * key.size();
}

}  // namespace patina::link
