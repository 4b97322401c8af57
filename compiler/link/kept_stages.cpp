#include "compiler/link/kept_stages.h"

#include <algorithm>

#include "compiler/ir/content/content.h"

namespace patina::link {
namespace {

constexpr std::uint32_t kNoPlace = 0xffffffffu;

// All that link_fragment() or link_vertex() and the IR passes read.
class StageContent {
public:
    StageContent(const Linked& linked, const graph::LoweredPass& pass, const ir::Module* fragment)
        : linked_(linked),
          lowered_(linked.lowered),
          pass_(pass),
          kind_(fragment ? ir::StageKind::Vertex : ir::StageKind::Fragment),
          content_(lowered_.module),
          numbers_(linked.functions.size()),
          has_semantic_(lowered_.semantics.size()) {
        add_tables();
        add_pass();
        if (fragment) add_inputs(*fragment);
        add_function(fragment ? pass.vertex : pass.fragment);
        for (const ir::FunctionId wrap : {lowered_.wraps.position, lowered_.wraps.pixel, lowered_.wraps.reads})
            add_function(wrap);
        for (std::size_t i = 0; i < order_.size(); ++i) add_body(order_[i]);
    }

    const ir::Content& content() const { return content_; }
    std::string take() const { return content_.take(); }

private:
    // The numbers of globals and semantics are the same in all stages and in the reflection, so they count as they are.
    void add_tables() {
        const ir::Module& module = lowered_.module;
        content_.number(static_cast<std::uint64_t>(kind_) | std::uint64_t{module.tests_keywords} << 8 |
                        std::uint64_t{module.has_values_from_bottom} << 9 |
                        std::uint64_t{lowered_.keeps_functions} << 10);
        content_.number(module.blocks.size());
        for (const ir::UniformBlock& block : module.blocks) content_.block(block);
        content_.number(module.globals.size());
        for (const ir::Global& global : module.globals) content_.global(global);
        content_.number(module.keywords.size());
        for (const ir::Keyword& keyword : module.keywords) content_.keyword(keyword);
        content_.number(module.semantics.size());
        for (const auto& [name, type, rate, from_bottom] : module.semantics) {
            content_.text(name);
            content_.type(type);
            content_.number(static_cast<std::uint64_t>(rate) | std::uint64_t{from_bottom} << 8);
        }
        content_.number(lowered_.picture_reads.size());
        for (const std::uint32_t global : lowered_.picture_reads) content_.number(global);
    }

    void add_pass() {
        const graph::PassDecl& declared = *pass_.declaration;
        content_.number(std::uint64_t{declared.state.lights == PassLights::Shadowed} |
                        std::uint64_t{declared.state.draws == PassDraws::Objects} << 1 |
                        std::uint64_t{declared.state.targets.empty()} << 2);
        content_.number(declared.guards.size());
        for (const std::string_view guard : declared.guards) content_.text(guard);
        content_.texts(declared.vertex_texts);
        content_.texts(declared.fragment_texts);
        content_.number(pass_.attributes.size());
        for (const auto& [semantic, global] : pass_.attributes) {
            content_.number(semantic.index | std::uint64_t{global.index} << 32);
            add_semantic(semantic);
        }
    }

    void add_inputs(const ir::Module& fragment) {
        const auto is_at_end = [](const ir::StageText& text) { return text.place == "vertex end"; };
        content_.number(std::any_of(
            fragment.functions.begin(), fragment.functions.end(),
            [&](const ir::Function& each) { return std::any_of(each.texts.begin(), each.texts.end(), is_at_end); }));
        content_.number(fragment.stage.inputs.size());
        const std::vector<ir::Semantic>& semantics = lowered_.module.semantics;
        for (ir::StageVariable input : fragment.stage.inputs) {
            input.location = 0;  // link_vertex() numbers them
            const auto found = std::find_if(semantics.begin(), semantics.end(),
                                            [&](const ir::Semantic& each) { return each.name == input.name; });
            content_.variable(input);
            if (found != semantics.end()) add_semantic({static_cast<std::uint32_t>(found - semantics.begin())});
        }
    }

    // The function's number, by which its callers know it.
    std::uint32_t add(ir::FunctionId function) {
        if (!function) return 0;
        std::uint32_t& number = numbers_[function.index];
        if (number == 0) {
            order_.push_back(function);
            number = static_cast<std::uint32_t>(order_.size());
        }
        return number;
    }
    void add_function(ir::FunctionId function) { content_.number(add(function)); }

    void add_semantic(ir::SemanticId semantic) {
        content_.number(semantic.index);
        if (has_semantic_[semantic.index]) return;
        has_semantic_[semantic.index] = true;
        const auto& [source, recipe, location, hlsl, override, declaration] = lowered_.semantics[semantic.index];
        content_.number(static_cast<std::uint64_t>(source) |
                        static_cast<std::uint64_t>(declaration ? declaration->builtin : ir::Builtin::None) << 8 |
                        std::uint64_t{declaration != nullptr} << 16 | std::uint64_t{location.has_value()} << 17 |
                        std::uint64_t{location.value_or(0)} << 32);
        content_.text(hlsl);
        add_function(recipe);
        add_function(kind_ == ir::StageKind::Vertex ? override : ir::FunctionId{});
        const auto* given = pass_.recipe_of(semantic, kind_);
        add_function(given ? given->by : ir::FunctionId{});
    }

    void add_body(ir::FunctionId function) {
        content_.function(
            linked_.functions[function.index], [&](std::uint32_t callee) { return add({callee}); },
            [](std::uint32_t global) { return global; });
        const auto* other = pass_.replacement_of(function, kind_);
        add_function(other ? other->by : ir::FunctionId{});
        const std::vector<ir::SemanticId>& needs = linked_.needs[function.index];
        content_.number(needs.size());
        for (const ir::SemanticId semantic : needs) add_semantic(semantic);
    }

    const Linked& linked_;
    const graph::Lowered& lowered_;
    const graph::LoweredPass& pass_;
    ir::StageKind kind_;
    ir::Content content_;
    std::vector<std::uint32_t> numbers_;  // by function, from 1; 0: not mentioned yet
    std::vector<ir::FunctionId> order_;
    std::vector<bool> has_semantic_;
};

// The stage with the places of this graph's text.
ir::Module placed(const KeptStage& kept, const ir::Module& module, const std::vector<Span>& spans) {
    ir::Module made = kept.module;
    for (std::size_t i = 0; i < kept.places.size(); ++i)
        made.origins[i].span = kept.places[i] == kNoPlace ? Span{} : spans[kept.places[i]];
    for (std::size_t i = 0; i < made.globals.size(); ++i) made.globals[i].span = module.globals[i].span;
    return made;
}

// By origin: its place among the spans. Nothing if a pass has made a new place.
std::optional<std::vector<std::uint32_t>> places_of(const ir::Module& stage, const ir::Module& module,
                                                    const ir::Content& content) {
    std::vector<std::uint32_t> places(stage.origins.size(), kNoPlace);
    for (const ir::OriginId origin : content.origins())
        places[origin.index] = *content.place_of(stage.origins[origin.index].span);
    for (std::size_t i = module.origins.size(); i < stage.origins.size(); ++i) {
        const std::optional<std::uint32_t> place = content.place_of(stage.origins[i].span);
        if (!place) return {};
        places[i] = *place;
    }
    return places;
}

template <class Part>
std::size_t size_of(const std::vector<Part>& parts) {
    return sizeof(Part) * parts.size();
}

// About how many bytes it has. Short strings have none of their own.
std::size_t size_of(const ir::Module& module) {
    std::size_t bytes = sizeof module + 12 * module.names.size();  // and the hash table of the names
    bytes += size_of(module.names) + size_of(module.origins) + size_of(module.globals) + size_of(module.semantics) +
             size_of(module.functions) + size_of(module.structs) + size_of(module.blocks) + size_of(module.constants) +
             size_of(module.numbers);
    for (const ir::Struct& each : module.structs) bytes += size_of(each.members);
    for (const ir::UniformBlock& block : module.blocks) bytes += size_of(block.members);
    for (const ir::Function& function : module.functions)
        bytes += size_of(function.params) + size_of(function.insts) + size_of(function.operands) +
                 size_of(function.blocks) + sizeof(ir::Value) * function.insts.size() + function.comment.size();
    return bytes;
}

}  // namespace

ir::Module kept_stage(KeptResults* kept, const Linked& linked, const graph::LoweredPass& pass,
                      const ir::Module* fragment, const std::function<ir::Module()>& make) {
    if (!kept) return make();
    StageContent stage(linked, pass, fragment);
    const ir::Content& content = stage.content();
    const ir::Module& module = linked.lowered.module;
    if (const auto found = kept->stages.find(content.bytes())) return placed(*found, module, content.spans());
    ir::Module made = make();
    if (std::optional<std::vector<std::uint32_t>> places = places_of(made, module, content)) {
        const std::size_t bytes = size_of(made) + size_of(*places);
        kept->stages.keep(stage.take(), {.module = made, .places = std::move(*places)}, bytes);
    }
    return made;
}

}  // namespace patina::link
