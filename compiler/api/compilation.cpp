#include "compiler/api/compilation.h"

#include <algorithm>

#include "compiler/api/dumps.h"
#include "compiler/format/read_graph.h"
#include "compiler/ir/verify.h"
#include "compiler/link/check_limits.h"
#include "compiler/link/check_reads.h"
#include "compiler/link/dumps.h"
#include "compiler/link/target_reads.h"
#include "patina/output_name.h"

namespace patina {
namespace {

bool may_go_on(const Compilation& c) {
    return !resolve::must_stop(c.session) && !c.session.diagnostics.has_errors();
}

// The extra passes that were requested and can be drawn.
void choose_passes(Compilation& c) {
    resolve::Session& session = c.session;
    const std::vector<std::string>& wanted = session.request.passes;
    for (const std::unique_ptr<resolve::Material>& each : c.file.passes) {
        const format::ExtraPass& pass = *each->pass;
        const bool is_named = std::find(wanted.begin(), wanted.end(), pass.name) != wanted.end();
        if (session.request.functions) {
            session.diagnostics.report(Code::PassLeftOut, pass.name_span, pass.name,
                                       "--functions writes only the functions of the material itself");
        } else if (wanted.empty() ? lower::draws_extra(session, c.lowered.front()) : is_named) {
            c.materials.push_back(each.get());
        }
    }
}

output::Compiled compiled(const Compilation& c) {
    return {.session = c.session,
            .material = *c.materials.front(),
            .lowered = c.linked.front().lowered,
            .passes = c.passes,
            .linked = c.linked.front(),
            .name = output_name(c.path)};
}

std::optional<Budget::Limit> limit_of(const std::optional<format::Budget::Limit>& limit, const SourceMap& sources) {
    if (!limit) return std::nullopt;
    return Budget::Limit{.most = static_cast<std::uint32_t>(limit->most),
                         .place = format::place_of(sources, limit->span)};
}

}  // namespace

bool accept(Compilation& c) {
    c.writer = &writers::writer_of(c.session);
    return c.writer->accepts(c.session);
}

bool find_path(Compilation& c) {
    if (!c.session.request.functions) resolve::find_path(c.session);
    return true;  // the library's passes are used then, so that errors in the graph are still found
}

bool read_material(Compilation& c) {
    c.file = resolve::read_material(c.session, c.source, c.path);
    if (!c.file.material) return false;
    c.materials = {c.file.material.get()};
    dump_graph(c.result, c.session, *c.file.material);
    return !resolve::must_stop(c.session);  // lowering checks types even after errors, to report as many as possible
}

bool lower_material(Compilation& c) {
    c.lowered.push_back(lower::lower(c.session, *c.materials.front(), {.fold = true}));
    if (!may_go_on(c)) return false;
    resolve::warn_unused(c.session, *c.materials.front());
    ir::check_if_verifying(c.lowered.front().module, "lowered");
    link::dump_stage(c.result, c.session.options, "ir", "ir", c.lowered.front().module);
    return true;
}

bool lower_passes(Compilation& c) {
    choose_passes(c);
    for (std::size_t i = 1; i < c.materials.size(); ++i)
        c.lowered.push_back(lower::lower(c.session, *c.materials[i], {.fold = true}));
    return may_go_on(c);
}

bool link_materials(Compilation& c) {
    for (lower::Lowered& lowered : c.lowered) {
        c.writer->name(c.session, lowered);
        c.linked.push_back(link::link(std::move(lowered)));
    }
    return true;
}

// Removes targets whose values no other pass of this material reads. All passes must be there to know that.
void leave_out_targets(Compilation& c, std::size_t material, std::size_t first_pass) {
    const PassesRequest* request = c.session.options.passes();
    if (!request || !request->only.empty()) return;
    const auto passes = std::span(c.passes).subspan(first_pass);
    for (link::LinkedPass& made : passes) {
        const lower::LoweredPass& pass = *made.pass;
        if (const std::uint32_t unread = link::unread_targets(pass, passes))
            made = link::link_pass(*c.materials[material], c.linked[material], pass, c.session, c.result, unread);
    }
}

bool link_stages(Compilation& c) {
    for (std::size_t i = 0; i < c.materials.size(); ++i) {
        const std::size_t first_pass = c.passes.size();
        for (const lower::LoweredPass& pass : c.linked[i].lowered.passes) {
            c.pass = pass.name;
            link::LinkedPass made = link::link_pass(*c.materials[i], c.linked[i], pass, c.session, c.result);
            if (c.writer->takes(c.session, c.linked[i], made)) {
                link::check_varyings(made, c.session);
                c.passes.push_back(std::move(made));
            }
            if (!may_go_on(c)) return false;
        }
        leave_out_targets(c, i, first_pass);
    }
    c.pass = std::string_view();
    return true;
}

bool check_stages(Compilation& c) {
    link::check_reads(c.session, c.linked.front().lowered, c.passes);
    link::check_limits(c.session, *c.materials.front(), c.linked.front().lowered, c.passes);
    std::vector<const ir::Module*> stages;
    for (const link::LinkedPass& pass : c.passes) stages.insert(stages.end(), {&pass.fragment, &pass.vertex});
    const Span graph = c.materials.front()->graph->graph->span;
    link::check_foreign(c.session, stages, {graph.begin, graph.begin + 1});
    return may_go_on(c);
}

bool order_passes(Compilation& c) {
    c.writer->order(c.passes);
    return true;
}

bool reflect(Compilation& c) {
    c.result.reflection = output::reflect(*c.materials.front(), c.linked.front().lowered, c.passes, c.session);
    const format::Graph& graph = *c.materials.front()->graph->graph;
    for (const format::Node& node : graph.nodes) c.result.nodes.push_back(node.id);
    c.result.budget = {.instructions = limit_of(graph.budget.instructions, c.session.sources),
                       .textures = limit_of(graph.budget.textures, c.session.sources)};
    return true;
}

bool check_files(Compilation& c) {
    c.writer->check(compiled(c), c.result.reflection);
    return true;
}

bool write_files(Compilation& c) {
    c.writer->write(compiled(c), c.result);
    for (Pass& pass : c.result.reflection.passes) {
        for (const Shader& shader : c.result.shaders) {
            if (shader.pass == pass.name)
                pass.shaders.push_back(
                    {.stage = shader.stage, .language = shader.target.language, .file = shader.file_name});
        }
    }
    return may_go_on(c);
}

bool keep_programs(Compilation& c) {
    if (c.session.options.keep_programs && !c.session.request.functions)
        c.result.program = link::keep_program(c.session, c.materials);
    return true;
}

}  // namespace patina
