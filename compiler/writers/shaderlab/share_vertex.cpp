#include "compiler/writers/shaderlab/share_vertex.h"

#include <algorithm>

namespace patina::writers::shaderlab {
namespace {

using link::LinkedPass;

// How many vectors a pass may compute for another one alone: each costs an interpolator.
constexpr std::size_t kMostUnread = 1;

bool is_varying(const ir::StageVariable& variable) {
    return variable.builtin == ir::Builtin::None && variable.spelling.empty();
}

// What the stage interface and its texts say in the two places of a v2f and of a vertex function.
bool is_of_vertex_stage(const ir::StageText& text) {
    return text.place == "first interpolator" || text.place == "interpolators" || text.place == "vertex begin" ||
           text.place == "vertex end" || text.place == "vertex result";
}

// The lines that the vertex function does not write: a pass must keep its own.
bool is_of_program(const ir::StageText& text) {
    return !is_of_vertex_stage(text) && text.place != "include" && text.place != "light mode";
}

template <class Wanted>
std::vector<ir::StageText> texts(const LinkedPass& pass, const Wanted& wanted) {
    std::vector<ir::StageText> made = link::texts_of(pass);
    std::erase_if(made, [&](const ir::StageText& text) { return !wanted(text); });
    return made;
}

bool is_same(const std::vector<ir::StageText>& a, const std::vector<ir::StageText>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& x, const auto& y) { return x.place == y.place && x.line == y.line; });
}

const ir::StageVariable* output_of(const LinkedPass& pass, const ir::StageVariable& input) {
    const auto& outputs = pass.vertex.stage.outputs;
    const auto found = std::find_if(outputs.begin(), outputs.end(), [&](const ir::StageVariable& output) {
        return is_varying(output) && output.name == input.name && output.type == input.type &&
               output.flat == input.flat;
    });
    return found == outputs.end() ? nullptr : &*found;
}

template <class What>
bool has_all_of(const std::vector<lower::Given<What>>& list, const std::vector<lower::Given<What>>& other) {
    return std::all_of(other.begin(), other.end(), [&](const lower::Given<What>& wanted) {
        return !wanted.in_vertex_stage || std::any_of(list.begin(), list.end(), [&](const lower::Given<What>& each) {
            return each.in_vertex_stage && each.what == wanted.what && each.span.begin == wanted.span.begin;
        });
    });
}

// True if a value means the same at the vertices of both passes.
bool computes_alike(const lower::LoweredPass& a, const lower::LoweredPass& b) {
    return has_all_of(a.recipes, b.recipes) && has_all_of(b.recipes, a.recipes) && has_all_of(a.replaced, b.replaced) &&
           has_all_of(b.replaced, a.replaced);
}

bool can_serve(const LinkedPass& maker, const LinkedPass& reader) {
    if (maker.material != reader.material || maker.pass->declaration->vertex != reader.pass->declaration->vertex ||
        !computes_alike(*maker.pass, *reader.pass))
        return false;
    const auto& outputs = maker.vertex.stage.outputs;
    const auto& inputs = reader.fragment.stage.inputs;
    const auto made = std::count_if(outputs.begin(), outputs.end(), is_varying);
    const auto read = std::count_if(inputs.begin(), inputs.end(), is_varying);
    if (made < read || static_cast<std::size_t>(made - read) > kMostUnread) return false;
    return std::all_of(inputs.begin(), inputs.end(),
                       [&](const ir::StageVariable& input) { return !is_varying(input) || output_of(maker, input); }) &&
           is_same(texts(maker, is_of_vertex_stage), texts(reader, is_of_vertex_stage));
}

void serve(const LinkedPass& maker, LinkedPass& reader) {
    LinkedPass served = reader;
    served.vertex = maker.vertex;
    served.vertex.stage.texts = reader.vertex.stage.texts;
    for (ir::StageVariable& input : served.fragment.stage.inputs) {
        if (is_varying(input)) input.location = output_of(maker, input)->location;
    }
    if (is_same(texts(served, is_of_program), texts(reader, is_of_program))) reader = std::move(served);
}

}  // namespace

void share_vertex_stages(std::vector<LinkedPass>& passes) {
    for (LinkedPass& reader : passes) {
        const auto maker = std::find_if(passes.begin(), passes.end(), [&](const LinkedPass& each) {
            return &each != &reader && each.vertex.stage.outputs.size() > reader.vertex.stage.outputs.size() &&
                   can_serve(each, reader);
        });
        if (maker != passes.end()) serve(*maker, reader);
    }
}

}  // namespace patina::writers::shaderlab
