// What the compiler refuses becomes a constant. So a file whose slots are not those of its nodes is imported as far as
// it makes sense.
#include "compiler/importers/refusals.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/importers/shadergraph/graph_maker.h"
#include "compiler/importers/shadergraph/lost_settings.h"

namespace patina::importers::shadergraph {
namespace {

// In an object whose text is ready.
bool has_constant_in(std::string& object, const std::string& key, const Value& constant) {
    const std::string before = text(key).json + ": \"";
    const std::size_t begin = object.find(before);
    const std::size_t end = begin == object.npos ? begin : object.find('"', begin + before.size());
    if (end == object.npos) return false;
    object.replace(begin + before.size() - 1, end + 2 - begin - before.size(), constant.json);
    return true;
}

// Classes of nodes that only a pipeline or a fork has.
struct Stranger {
    std::string_view classes, reason;
};
constexpr Stranger kStrangers[] = {
    {"HDSceneColorNode HDSceneDepthNode HDSampleBufferNode CustomColorBufferNode CustomDepthBufferNode",
     "the buffers of the high definition pipeline are not known to a graph"},
    {"DiffusionProfileNode", "a diffusion profile is an asset of the high definition pipeline"},
    {"EmissionNode", "it computes with the camera's exposure of the high definition pipeline"},
    {"RaytracingQualityNode", "it asks how the high definition pipeline traces rays"},
    {"CirclePupilAnimation CorneaRefraction EyeSurfaceTypeDebug IrisLimbalRing IrisOffset IrisOutOfBoundColorClamp "
     "IrisUVLocation ScleraIrisBlend ScleraLimbalRing ScleraUVLocation",
     "it is for the eyes of the high definition pipeline, which this importer does not know"},
    {"UVCombine ThreadMapDetail",
     "it is for the fabrics of the high definition pipeline, which this importer does not know"},
    {"GetLocalVariableNode LocalVariableRegisterNode ForLoopStartNode ForLoopEndNode CustomSpecularNode "
     "RgbToLuminanceNode",
     "it is a node of Tuanjie, a fork of Unity, which this importer does not know"},
};

}  // namespace

std::string reason_for_unknown(const Node& node) {
    for (const Stranger& each : kStrangers)
        if (names(each.classes, node.kind)) return std::string(each.reason);
    if (node.kind.ends_with("_Water"))
        return "it is for the water of the high definition pipeline, which this importer does not know";
    const std::string_view type = text_of(node.json, "m_Type");
    const std::string_view owner = type.starts_with("UnityEditor.Rendering.HighDefinition.")
                                       ? "the high definition pipeline"
                                   : type.starts_with("UnityEditor.Rendering.Universal.") ? "the universal pipeline"
                                                                                          : "Shader Graph";
    return fmt::format("'{}' is no node of {} that this importer knows", node.kind, owner);
}

bool GraphMaker::has_constant_for(const Diagnostic& wrong) {
    if (wrong.node == "surface") {
        const bool is_color = wrong.port == "baseColor" || wrong.port == "color";
        return has_constant(file_, wrong, is_color ? Type::Float3 : Type::Float);
    }
    if (const auto part = std::ranges::find(file_.more, wrong.node, &Member::key); part != file_.more.end()) {
        const auto output = std::ranges::find(ports_.outputs, wrong.port, &SubgraphPorts::Output::name);
        const Term constant = stand_in(output == ports_.outputs.end() ? Type::Float3 : output->type);
        return has_constant_in(part->value.json, wrong.port, text("= " + constant.text()));
    }
    const auto type = types_.find(wrong.node);
    return has_constant(file_, wrong, type == types_.end() ? Type::Float4 : type->second);
}

std::string GraphMaker::refuse_invalid() {
    const auto report = [&](const Diagnostic& wrong, const std::string& reason) {
        const auto owner = owners_.find(wrong.node);
        if (owner == owners_.end()) {
            remark(Remark::Kind::LeftOut, fmt::format("'{}.{}'", wrong.node, wrong.port), reason, {});
            return;
        }
        outcomes_[owner->second] = {.kind = Remark::Kind::LeftOut, .text = reason};
        project_.has_refused = true;
    };
    const std::string error = importers::refuse_invalid(
        file_, project_.files, [&](const Diagnostic& wrong) { return has_constant_for(wrong); }, report);
    return error.empty() ? error : fmt::format("{}: {}", graph_.path, error);
}

}  // namespace patina::importers::shadergraph
