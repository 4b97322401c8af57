#include "compiler/cli/node_sheet/drawings.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/cli/node_sheet/drawings_data.h"
#include "compiler/json/json_document.h"

namespace patina::cli {
namespace {

using Json = JsonValue;

std::string text(const Json& json) {
    return json.IsString() ? json.GetString() : fmt::format("{}", json.GetDouble());
}

std::string member(const Json& json, const char* name) {
    const auto found = json.FindMember(name);
    return found == json.MemberEnd() ? std::string() : text(found->value);
}

PlotWish read_plot(const Json& json) {
    PlotWish made{.node = member(json, "node"), .over = member(json, "over"), .label = member(json, "label")};
    if (json.HasMember("in"))
        for (const auto& each : json["in"].GetObject())
            made.inputs.emplace_back(each.name.GetString(), text(each.value));
    if (json.HasMember("curves")) {
        const auto& curve = *json["curves"].MemberBegin();
        made.curve = curve.name.GetString();
        for (const Json& each : curve.value.GetArray()) made.curves.push_back(text(each));
    }
    if (json.HasMember("outputs")) {
        made.outputs.clear();
        const Json& outputs = json["outputs"];
        if (outputs.IsArray())
            for (const Json& each : outputs.GetArray()) made.outputs.emplace_back(text(each), text(each));
        else
            for (const auto& each : outputs.GetObject())
                made.outputs.emplace_back(each.name.GetString(), text(each.value));
    }
    if (json.HasMember("limits")) made.limits = {json["limits"][0].GetDouble(), json["limits"][1].GetDouble()};
    made.is_log = member(json, "y") == "log";
    made.is_strip = json.HasMember("strip");
    return made;
}

}  // namespace

const PlotWish* plot_wish(std::string_view node) {
    static const std::vector<PlotWish> kAll = [] {
        JsonDocument document;
        document.Parse(kNodePlots);
        std::vector<PlotWish> made;
        for (const Json& each : document["plots"].GetArray()) made.push_back(read_plot(each));
        return made;
    }();
    const auto found = std::ranges::find(kAll, node, &PlotWish::node);
    return found == kAll.end() ? nullptr : &*found;
}

std::optional<PanelWish> panel_wish(std::string_view node) {
    static const JsonDocument kAll = [] {
        JsonDocument document;
        document.Parse(kNodePanels);
        return document;
    }();
    for (const Json& each : kAll["pictures"].GetArray())
        for (const auto& panel : each["panels"].GetObject())
            if (member(each, "node") == node && text(panel.value).find("$_Texture") == std::string::npos)
                return PanelWish{.expression = text(panel.value), .mesh = member(each, "mesh")};
    return std::nullopt;
}

}  // namespace patina::cli
