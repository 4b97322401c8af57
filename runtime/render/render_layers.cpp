#include "runtime/render/render_layers.h"

#include <algorithm>

namespace patina::runtime {
namespace {

void add_news(const RenderOutcome& drawn, RenderOutcome& all) {
    for (const Diagnostic& each : drawn.diagnostics) {
        const auto is_same = [&](const Diagnostic& known) { return to_text(known) == to_text(each); };
        if (std::ranges::none_of(all.diagnostics, is_same)) all.diagnostics.push_back(each);
    }
    for (const std::string& file : drawn.dependencies) {
        if (std::ranges::find(all.dependencies, file) == all.dependencies.end()) all.dependencies.push_back(file);
    }
}

}  // namespace

LayersOutcome render_layers(const Compiler& compiler, const RenderRequest& request, std::span<const std::string> names,
                            RenderMachine& machine) {
    LayersOutcome made;
    RenderRequest beauty = request;
    beauty.light.reset();
    beauty.object.clear();
    beauty.material.clear();
    made.drawn = render(compiler, beauty, machine);
    if (!made.drawn.ok) return made;
    for (const std::string& name : names) {
        RenderRequest one = request;
        one.options.preview = name;
        one.background = "none";
        one.keeps_values = true;
        RenderOutcome drawn = render(compiler, one, machine);
        add_news(drawn, made.drawn);
        if (!drawn.ok) {
            made.drawn.ok = false;
            made.drawn.error = drawn.error;
            made.drawn.missing_machine = drawn.missing_machine;
            return made;
        }
        made.layers.push_back({name, std::move(drawn.image)});
    }
    return made;
}

}  // namespace patina::runtime
