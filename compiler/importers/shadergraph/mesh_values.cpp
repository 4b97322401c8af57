// Values of the mesh, the camera and the screen that a slot reads if nothing is connected to it.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/importers/shadergraph/graph_maker.h"

namespace patina::importers::shadergraph {
namespace {

struct Bound {
    std::string_view kind;
    std::string_view spaces[4];  // object, view, world, tangent
};
constexpr Bound kBound[] = {
    {"Normal", {"@normalOS", "@normalVS", "@normalWS", "float3(0, 0, 1)"}},
    {"Tangent", {"@tangentOS.xyz", "TangentVector(View)", "@tangentWS", "float3(1, 0, 0)"}},
    {"Bitangent", {"BitangentVector(Object)", "BitangentVector(View)", "@bitangentWS", "float3(0, 1, 0)"}},
    {"Position", {"@positionOS", "@positionVS", "@positionWS", "Position(Tangent)"}},
    {"ViewDirection", {"ViewDirection(Object)", "ViewDirection(View)", "@viewDirWS", "ViewDirection(Tangent)"}},
};

}  // namespace

Term GraphMaker::coordinates(std::size_t index, int channel) {
    if (channel < 0 || channel > 3)
        approximate(index, "there are four sets of texture coordinates: it reads the first or the last one");
    const int set = std::clamp(channel, 0, 3);
    const std::string name = set == 0 ? "uv" : fmt::format("uv{}", set);
    const Term parts[] = {link(name, Type::Float2), number_term(0), number_term(1)};
    Term made = terms::vector_of(Type::Float4, parts);
    made.from_top = nodelang::name(fmt::format("@uv{}", set));
    return made;
}

Term GraphMaker::bound(std::size_t index, const Slot& slot, const Term& otherwise) {
    if (slot.kind == "UV") return converted(coordinates(index, whole_of(slot.json, "m_Channel")), Type::Float2);
    if (slot.kind == "VertexColor") return link("@vertexColor", Type::Float4);
    if (slot.kind == "ScreenPosition") {
        const int mode = whole_in(slot.json, "m_ScreenSpaceType", 0, 0, 4);
        if (mode == 0) {
            Term made = expression("float4(@screenUV.x, 1 - @screenUV.y, 0, 0)", Type::Float4);
            made.from_top = nodelang::name("@screenUV");
            return made;
        }
        static constexpr std::string_view kModes[] = {"Default", "Raw", "Center", "Tiled", "Pixel"};
        return expression(fmt::format("ScreenPosition({}, Bottom)", kModes[mode]), Type::Float4);
    }
    const auto row = std::ranges::find(kBound, slot.kind, &Bound::kind);
    if (row == std::end(kBound)) return otherwise;
    const int space = whole_in(slot.json, "m_Space", 0, 0, 4);
    return expression(std::string(row->spaces[space == 4 ? 2 : space]), Type::Float3);
}

Term GraphMaker::without_slot(std::size_t index, int slot) {
    const std::string_view value = value_without_slot(node(index).kind, slot);
    if (value.empty()) return number_term(0);
    if (value.starts_with("m_")) return number_term(number_of(node(index).json, value));
    if (value.starts_with("uv")) return converted(coordinates(index, value == "uv" ? 0 : value[2] - '0'), Type::Float2);
    if (value == "screen") return bound(index, {.kind = "ScreenPosition"}, {});
    std::vector<double> numbers;
    for (const std::string_view each : split(value, ", "))
        if (const auto number = read_number(each)) numbers.push_back(*number);
    if (numbers.empty()) return expression(std::string(value), Type::Float3);
    const bool is_dynamic = numbers.size() == 4;
    const Term made = constant(std::move(numbers));
    return is_dynamic ? converted(made, dynamic_types_[index].vector) : made;
}

}  // namespace patina::importers::shadergraph
