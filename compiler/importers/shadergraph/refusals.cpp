// What the compiler refuses becomes a constant. So a file whose slots are not those of its nodes is imported as far as
// it makes sense.

#include <fmt/format.h>

#include <algorithm>

#include "compiler/importers/shadergraph/graph_maker.h"
#include "compiler/importers/shadergraph/lost_settings.h"

namespace patina::importers::shadergraph {
namespace {

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

std::string GraphMaker::refuse_invalid() {
    const std::string error =
        file_.refuse_invalid(project_.files, [&](const Diagnostic& wrong, const std::string& reason) {
            remark(Remark::Kind::LeftOut, fmt::format("'{}.{}'", wrong.node, wrong.port), reason, {});
        });
    return error.empty() ? error : fmt::format("{}: {}", graph_.path, error);
}

}  // namespace patina::importers::shadergraph
