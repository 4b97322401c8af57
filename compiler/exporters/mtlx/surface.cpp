#include "compiler/exporters/mtlx/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace patina::exporters::mtlx {
namespace {

enum class Form { Plain, Inverse, Normal, Unit };
struct InputRow {
    std::string_view shader, member, input, type, otherwise;
    Form form;
};
constexpr InputRow kInputs[] = {
#define MTLX_INPUT(shader, member, input, type, otherwise, form) {shader, #member, #input, type, otherwise, Form::form},
#define MTLX_DETAIL(shader, input, of)
#include "compiler/exporters/mtlx/surfaces.def"
#undef MTLX_DETAIL
#undef MTLX_INPUT
};
// An input that only matters if another one has a value, and whose default is not that of graphs.
struct DetailRow {
    std::string_view shader, input, of;
};
constexpr DetailRow kDetails[] = {
#define MTLX_INPUT(shader, member, input, type, otherwise, form)
#define MTLX_DETAIL(shader, input, of) {shader, #input, #of},
#include "compiler/exporters/mtlx/surfaces.def"
#undef MTLX_DETAIL
#undef MTLX_INPUT
};
// What the kind of the surface decides.
constexpr std::string_view kAlphaInputs[] = {"alpha", "alphaClip"};

// Empty: none has this workflow.
std::string shader_of(const resolve::Material& material) {
    const std::string& workflow = material.workflow->graph->name;
    if (workflow == "unlit") return "surface_unlit";
    if (workflow == "specular-glossiness") return "UsdPreviewSurface";
    if (workflow != "metallic-roughness" && workflow != "metallic-smoothness") return {};
    return material.lighting_name == "openpbr" ? "open_pbr_surface" : "gltf_pbr";
}

class SurfaceWriter {
public:
    SurfaceWriter(resolve::Session& session, const resolve::Material& material, const ir::Module& module,
                  NodeWriter& writer, std::string graph_name)
        : session_(session),
          material_(material),
          graph_(*material.graph->graph),
          module_(module),
          writer_(writer),
          graph_name_(std::move(graph_name)) {}

    SurfaceParts write(const std::string& name) {
        shader_ = shader_of(material_);
        if (shader_.empty()) {
            const Span span = graph_.workflow_span ? graph_.workflow_span : graph_.span;
            session_.diagnostics.report(Code::NoCounterpart, span,
                                        fmt::format("the workflow '{}'", material_.workflow->graph->name));
            return {};
        }
        const std::string_view model = shader_ == "open_pbr_surface" ? "openpbr" : "gltf";
        if (shader_ != "surface_unlit" && material_.lighting_name != model)
            writer_.differs(
                graph_.lighting.present ? graph_.lighting.span : graph_.span,
                fmt::format("'{}' has a lighting model of its own, and not '{}'", shader_, material_.lighting_name));
        parts_.shader = {.category = shader_, .attributes = {{"name", name}, {"type", "surfaceshader"}}};
        check_stated();
        if (shader_ == "UsdPreviewSurface")
            add({.name = "useSpecularWorkflow", .value = {.numbers = {1}}, .type = "integer"});
        for (const InputRow& row : kInputs)
            if (row.shader == shader_ && matters(row.input)) add_row(row);
        if (shader_ == "UsdPreviewSurface") add_tangent_normal();
        add_alpha();
        report_render_state();
        return std::move(parts_);
    }

private:
    Span span_of(std::string_view member) const {
        for (const format::PortValue& port : graph_.surface) {
            if (port.name == member) return port.value_span;
            for (const format::Input* input : material_.surface_inputs())
                if (input->name == port.name && input->gives == member) return port.value_span;
        }
        return graph_.span;
    }

    std::optional<ir::Value> member(std::string_view name) const {
        const ir::Function& function = writer_.function();
        const ir::Value returned = function.args(function.blocks[0].insts.back())[0];
        const std::vector<ir::Member>& members = module_.structs[function.result.ref].members;
        for (std::size_t i = 0; i < members.size(); ++i)
            if (members[i].name == name && function[returned].op == ir::Op::Construct)
                return function.args(returned)[i];
        return std::nullopt;
    }

    // An input of a lighting model that is not the shader's.
    void check_stated() {
        for (const format::PortValue& port : graph_.surface) {
            std::string name = port.name;
            for (const format::Input* input : material_.surface_inputs())
                if (input->name == name && !input->gives.empty()) name = input->gives;
            const bool is_known =
                std::any_of(std::begin(kInputs), std::end(kInputs),
                            [&](const InputRow& row) { return row.shader == shader_ && row.member == name; }) ||
                std::find(std::begin(kAlphaInputs), std::end(kAlphaInputs), name) != std::end(kAlphaInputs) ||
                (shader_ == "UsdPreviewSurface" && name == "normalWS");
            if (!is_known)
                writer_.differs(port.name_span,
                                fmt::format("'{}' is left out: '{}' has no such input", port.name, shader_));
        }
    }

    bool matters(std::string_view input) const {
        const auto row = std::find_if(std::begin(kDetails), std::end(kDetails), [&](const DetailRow& each) {
            return each.shader == shader_ && each.input == input;
        });
        const std::vector<Element>& added = parts_.shader.children;
        return row == std::end(kDetails) || std::any_of(added.begin(), added.end(), [&](const Element& each) {
                   return each.attributes[0].second == row->of;
               });
    }

    void add_row(const InputRow& row) {
        const auto found = member(row.member);
        if (!found) return;
        writer_.set_reader(span_of(row.member), row.input);
        if (row.form == Form::Normal && is_mesh_normal(*found)) return;
        Ref value = writer_.value(*found);
        if (row.form == Form::Inverse) value = inverse(value);
        if (row.form == Form::Unit) {
            if (value.is_all(0)) return;
            add({.name = std::string(row.otherwise), .value = {.numbers = {1}}, .type = "float"});
        } else if (!row.otherwise.empty() && value.is_number() &&
                   std::all_of(value.numbers.begin(), value.numbers.end(), [&](double each) {
                       return static_cast<float>(each) == std::strtof(std::string(row.otherwise).c_str(), nullptr);
                   })) {
            return;
        }
        add({.name = std::string(row.input), .value = value, .type = std::string(row.type)});
    }

    bool is_mesh_normal(ir::Value value) const {
        return writer_.semantic(value) == "geometryNormalWS" || writer_.semantic(value) == "normalWS";
    }

    Ref inverse(const Ref& value) {
        if (value.is_number()) return {.numbers = {1 - value.numbers[0]}};
        return writer_.combine("subtract", {.numbers = {1}}, value);
    }

    // The shader of USD takes a normal of a normal map, and no other one.
    void add_tangent_normal() {
        const auto found = member("normalWS");
        if (!found || is_mesh_normal(*found)) return;
        writer_.set_reader(span_of("normalWS"), "normal");
        const auto tangent = writer_.tangent_normal(*found);
        if (!tangent) return writer_.refuse(*found, "a normal that is not in tangent space");
        add({.name = "normal", .value = *tangent, .type = "vector3"});
    }

    void add_alpha() {
        const SurfaceKind kind = graph_.render.surface;
        if (kind == SurfaceKind::Opaque) return;
        if (kind == SurfaceKind::Additive || kind == SurfaceKind::Multiply)
            session_.diagnostics.report(Code::NoCounterpart, graph_.render.surface_span,
                                        "a surface that adds or multiplies");
        const auto alpha_value = member("alpha"), clip_value = member("alphaClip");
        if (!alpha_value || !clip_value) return;
        writer_.set_reader(span_of("alpha"), "alpha");
        Ref alpha = writer_.value(*alpha_value);
        const bool is_cutout = kind == SurfaceKind::Cutout;
        const auto clip = [&] { return writer_.value(*clip_value); };
        if (shader_ == "gltf_pbr") {
            add({.name = "alpha_mode", .value = {.numbers = {is_cutout ? 1.0 : 2.0}}, .type = "integer"});
            if (is_cutout) add({.name = "alpha_cutoff", .value = clip(), .type = "float"});
            add({.name = "alpha", .value = alpha, .type = "float"});
        } else if (shader_ == "UsdPreviewSurface") {
            if (is_cutout) add({.name = "opacityThreshold", .value = clip(), .type = "float"});
            add({.name = "opacity", .value = alpha, .type = "float"});
        } else {
            if (is_cutout) {
                writer_.differs(graph_.render.surface_span, "a cutout is an opacity of 0 or 1");
                alpha = writer_.node("ifgreatereq", "float",
                                     {{.name = "value1", .value = alpha, .type = "float"},
                                      {.name = "value2", .value = clip(), .type = "float"},
                                      {.name = "in1", .value = {.numbers = {1}}, .type = "float"},
                                      {.name = "in2", .value = {.numbers = {0}}, .type = "float"}});
            }
            const bool is_unlit = shader_ == "surface_unlit";
            add({.name = is_unlit ? "opacity" : "geometry_opacity", .value = alpha, .type = "float"});
        }
        const bool is_glass = shader_ == "UsdPreviewSurface";
        if ((kind == SurfaceKind::Transparent && !is_glass) || (kind == SurfaceKind::Fade && is_glass))
            writer_.differs(graph_.render.surface_span, is_glass ? "the highlights of a surface that fades stay"
                                                                 : "highlights fade with the surface");
    }

    void report_render_state() {
        if (graph_.render.cull != Cull::Back) writer_.differs(graph_.render.span, "no side of a surface is left out");
        for (const format::ExtraPass& pass : graph_.passes)
            writer_.differs(pass.name_span, fmt::format("the pass '{}' is left out", pass.name));
        for (const format::Node& node : graph_.nodes)
            if (node.stage == format::NodeStage::Vertex)
                writer_.differs(node.span, fmt::format("'{}' is computed at each pixel", node.id));
        for (const format::PortValue& port : graph_.vertex)
            writer_.differs(port.name_span, fmt::format("the vertex output '{}' is left out", port.name));
    }

    void add(Argument argument) {
        argument.value = writer_.as(argument.value, argument.type);
        if (argument.value.is_number()) return NodeWriter::write_input(parts_.shader, argument);
        // An output reads nodes only.
        writer_.set_reader({}, argument.name);
        if (argument.value.kind == Ref::Kind::Input)
            argument.value =
                writer_.node("dot", argument.type, {{.name = "in", .value = argument.value, .type = argument.type}});
        parts_.outputs.push_back(
            {"output", {{"name", argument.name + "_out"}, {"type", argument.type}, {"nodename", argument.value.name}}});
        parts_.shader.children.push_back({"input",
                                          {{"name", argument.name},
                                           {"type", argument.type},
                                           {"nodegraph", graph_name_},
                                           {"output", argument.name + "_out"}}});
    }

    resolve::Session& session_;
    const resolve::Material& material_;
    const format::Graph& graph_;
    const ir::Module& module_;
    NodeWriter& writer_;
    std::string graph_name_, shader_{};
    SurfaceParts parts_{};
};

}  // namespace

SurfaceParts write_surface(resolve::Session& session, const resolve::Material& material, const ir::Module& module,
                           NodeWriter& writer, const std::string& graph_name, const std::string& shader_name) {
    return SurfaceWriter(session, material, module, writer, graph_name).write(shader_name);
}

}  // namespace patina::exporters::mtlx
