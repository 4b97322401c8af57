// The functions of the Compiler class that do not compile (compile_graph.cpp does): the library, its descriptions,
// single nodes, fmt and schema.
#include <algorithm>
#include <cmath>

#include "compiler/api/check_library.h"
#include "compiler/api/compiler_impl.h"
#include "compiler/api/describe/describe.h"
#include "compiler/api/evaluate.h"
#include "compiler/api/report.h"
#include "compiler/base/file_names.h"
#include "compiler/base/text.h"
#include "compiler/format/canonical_form.h"
#include "compiler/format/read_graph.h"
#include "compiler/format/scene/read_scene.h"
#include "compiler/format/schema/schema.h"
#include "compiler/json/json.h"
#include "compiler/nodelang/other_names.h"
#include "compiler/nodelang/parse.h"
#include "compiler/resolve/check_graph.h"
#include "compiler/seam/seam.h"
#include "compiler/writers/writers.h"
#include "patina/complaints.h"
#include "patina/output_name.h"
#include "patina/version.h"

namespace patina {
namespace {

// "0.5", "0,0,1", "Reoriented", "#ff8800", "[[1, 0], [0, 1]]": the graph format's values, as a command line spells
// them.
const nodelang::Expr* read_argument(const std::string& text, SourceMap& sources, nodelang::Ast& ast,
                                    Diagnostics& diagnostics) {
    const std::uint32_t base = sources.add("argument", text);
    const std::string_view stored = sources.file_text(base);
    const Span span{base, base + static_cast<std::uint32_t>(text.size())};
    if (text.starts_with('#')) {
        json::Json json;
        json.kind = json::Json::Kind::String;
        // read_value expects the span of a JSON string, with its quotes.
        json.span = {span.begin - 1, span.end + 1};
        json.string = text;
        return format::read_value(json, sources, ast, diagnostics);
    }
    if (text.starts_with('{') || text.starts_with('[')) {
        const std::unique_ptr<json::Json> json = json::parse_json(sources, base, diagnostics);
        return json ? format::read_value(*json, sources, ast, diagnostics) : nullptr;
    }
    if (text.find(',') == std::string::npos || text.find('(') != std::string::npos) {
        return nodelang::parse_expression({.text = stored, .base = base}, ast, diagnostics);
    }
    nodelang::Expr list{.kind = nodelang::Expr::Kind::List, .span = span, .name_span = span, .text = {}, .args = {}};
    for (std::size_t at = 0; at <= stored.size();) {
        const std::size_t comma = std::min(stored.find(',', at), stored.size());
        const nodelang::Expr* element = nodelang::parse_expression(
            {.text = stored.substr(at, comma - at), .base = base + static_cast<std::uint32_t>(at)}, ast, diagnostics);
        if (!element) return nullptr;
        list.args.push_back(element);
        at = comma + 1;
    }
    return &ast.exprs.emplace_back(std::move(list));
}

// The node to call: one of the library, or the one in a user's file.
struct Callee {
    const nodelang::FunctionDecl& function;
    const nodelang::Declarations& declarations;
};

std::optional<Callee> find_callee(resolve::Session& session, std::string_view node) {
    if (node.ends_with(".hlsl")) {
        const resolve::NodeFile* file = resolve::load_node_file(session, std::string(node), {});
        if (!file) return {};
        return Callee{*file->node, file->declarations};
    }
    const nodelang::Declarations& declarations = session.library.declarations;
    const nodelang::FunctionDecl* function = declarations.function(node);
    if (function && function->attribute("node")) return Callee{*function, declarations};
    const std::vector<std::string_view> names = declarations.function_names();
    session.diagnostics.report(Code::UnknownNode, {}, node).note(nodelang::node_advice(node, names, declarations));
    return {};
}

// The arguments by parameter; null for a parameter without one.
std::vector<const nodelang::Expr*> read_arguments(resolve::Session& session, const nodelang::FunctionDecl& function,
                                                  std::span<const std::pair<std::string, std::string>> arguments) {
    std::vector<const nodelang::Expr*> values(function.params.size(), nullptr);
    for (const auto& argument : arguments) {
        const std::string &name = argument.first, &text = argument.second;
        const auto param = std::find_if(function.params.begin(), function.params.end(),
                                        [&](const nodelang::ParamDecl& p) { return p.is_input() && p.name == name; });
        if (param == function.params.end()) {
            std::vector<std::string_view> known;
            for (const nodelang::ParamDecl& p : function.params) {
                if (p.is_input()) known.push_back(p.name);
            }
            session.diagnostics.report(Code::UnknownPort, {}, function.name, "input", name)
                .at(function.name)
                .note(nodelang::port_advice(name, known, &function));
            continue;
        }
        session.diagnostics.set_context(function.name, name);
        const nodelang::Expr*& value = values[static_cast<std::size_t>(param - function.params.begin())];
        if (value) session.diagnostics.report(Code::DuplicateKey, value->span, name);
        value = read_argument(text, session.sources, session.ast, session.diagnostics);
        if (const auto range = resolve::range_of(param->attributes); range && value) {
            resolve::check_range(session, *value, *range, false, name);
        }
    }
    return values;
}

}  // namespace

std::string_view version() {
    return PATINA_VERSION_STRING;
}

std::vector<Hint> hints() {
    std::vector<Hint> hints;
    for (const nodelang::OtherName& row : nodelang::other_names()) {
        std::string text(row.remark);
        if (!row.own.empty()) text = "written '" + std::string(row.own) + "'" + (text.empty() ? "" : ": " + text);
        hints.push_back({row.other.substr(0, row.other.find('/')), std::move(text)});
    }
    return hints;
}

std::string output_name(std::string_view path) {
    return portable_name(format::name_of_file(path));
}

Compiler::Compiler() : Compiler(LibraryOverlay{}) {}
Compiler::Compiler(const LibraryOverlay& overlay) : impl_(std::make_unique<Impl>()) {
    impl_->library = resolve::load_library(nodelang::embedded_files(), writers::printable(), overlay);
    if (!overlay.files.empty()) impl_->overlay_errors = check_overlay(*impl_->library);
}
Compiler::Compiler(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Compiler CompilerAccess::with_files(std::span<const nodelang::EmbeddedFile> more) {
    const auto own = nodelang::embedded_files();
    std::vector<nodelang::EmbeddedFile> files(own.begin(), own.end());
    files.insert(files.end(), more.begin(), more.end());
    auto impl = std::make_unique<Compiler::Impl>();
    impl->library = resolve::load_library(files, writers::printable());
    return Compiler(std::move(impl));
}
Compiler::~Compiler() = default;
Compiler::Compiler(Compiler&&) noexcept = default;
Compiler& Compiler::operator=(Compiler&&) noexcept = default;

const Compiler::Impl::Described& Compiler::Impl::describe() const {
    return described.get([&] {
        const Cancellation nobody;
        auto made = std::make_unique<Described>();
        auto& [nodes, semantics, workflows, lighting_models, paths] = *made;
        const EvaluationContext context{*library, library->declarations, library->sources};
        for (const nodelang::FunctionDecl* function : resolve::all_functions(*library)) {
            if (function->attribute("node")) nodes.push_back(describe_node(*function, context));
        }
        std::sort(nodes.begin(), nodes.end(), [](const NodeInfo& a, const NodeInfo& b) {
            return std::pair(a.category, a.name) < std::pair(b.category, b.name);
        });
        semantics = describe_semantics(*library);
        paths = describe_paths(*library);
        for (const auto& [name, graph] : library->workflows) {
            if (graph.get()) workflows.push_back(describe_model(*graph.get(), name, library->sources));
        }
        for (const auto& [name, graph] : library->lighting_models) {
            if (graph.get()) lighting_models.push_back(describe_model(*graph.get(), name, library->sources));
        }
        return made;
    });
}

const std::vector<NodeInfo>& Compiler::nodes() const {
    return impl_->describe().nodes;
}
const NodeInfo* Compiler::node(std::string_view name) const {
    const auto& all = nodes();
    const auto found = std::find_if(all.begin(), all.end(), [&](const NodeInfo& n) { return n.name == name; });
    return found == all.end() ? nullptr : &*found;
}
std::string Compiler::node_advice(std::string_view name) const {
    const nodelang::Declarations& declarations = impl_->library->declarations;
    return nodelang::node_advice(name, declarations.function_names(), declarations);
}
const std::vector<SemanticInfo>& Compiler::semantics() const {
    return impl_->describe().semantics;
}
const std::vector<ModelInfo>& Compiler::workflows() const {
    return impl_->describe().workflows;
}
const std::vector<ModelInfo>& Compiler::lighting_models() const {
    return impl_->describe().lighting_models;
}
const std::vector<PathInfo>& Compiler::paths() const {
    return impl_->describe().paths;
}
const std::vector<EngineInfo>& Compiler::engines() const {
    return impl_->engines.get([&] {
        const Cancellation nobody;
        return std::make_unique<std::vector<EngineInfo>>(describe_engines(*impl_->library));
    });
}
std::vector<Target> Compiler::targets(std::string_view word) const {
    std::vector<Target> made;
    for (const EngineInfo& engine : engines()) {
        for (const std::string& language : engine.languages) {
            if (word == engine.name || (engine.is_default && word == language))
                made.push_back({.engine = engine.is_default ? std::string() : engine.name, .language = language});
        }
    }
    return made;
}

bool passed(const NodeTest& test) {
    if (test.actual.size() != test.expected.size()) return false;
    for (std::size_t i = 0; i < test.actual.size(); ++i) {
        const double actual = test.actual[i], expected = test.expected[i];
        if (actual == expected || (std::isnan(actual) && std::isnan(expected))) continue;
        // Negated, so that a single NaN fails.
        if (!(std::abs(actual - expected) <= test.absolute + test.relative * std::abs(expected))) return false;
    }
    return true;
}

std::vector<NodeTest> Compiler::tests(std::string_view node) const {
    const nodelang::FunctionDecl* function = impl_->library->declarations.function(node);
    if (!function) return {};
    Diagnostics diagnostics;
    const resolve::Library& library = *impl_->library;
    std::vector<NodeTest> tests = node_tests({library, library.declarations, library.sources}, *function, diagnostics);
    // A test line that cannot run counts as a failed test.
    for (const DiagnosticRecord& record : diagnostics.records()) {
        const Position position = impl_->library->sources.resolve(record.span.begin);
        NodeTest& broken = tests.emplace_back();
        broken.node = node;
        broken.text = record.message;
        broken.file = position.file;
        broken.line = position.line;
        broken.expected = {0};
    }
    return tests;
}

NodeFileResult Compiler::check_node_file(const std::string& path, const CompileOptions& options) const {
    return guarded<NodeFileResult>(path, [&](Trail& trail) {
        NodeFileResult result;
        resolve::Session session(*impl_->library, options);
        const TrailGuard guard(trail, session.diagnostics);
        Effort effort;
        resolve::until_stopped(session, [&] {
            const resolve::NodeFile* const file = resolve::load_node_file(session, path, {});
            if (!file) return;
            const EvaluationContext context{.library = session.library,
                                            .declarations = file->declarations,
                                            .sources = session.sources,
                                            .effort = &effort};
            result.node = describe_node(*file->node, context);
            check_functions(context, file->ast, session.diagnostics);
            if (!session.diagnostics.has_errors()) result.tests = node_tests(context, *file->node, session.diagnostics);
        });
        result.diagnostics = to_public(session.diagnostics, session.sources);
        result.ok = !session.diagnostics.has_errors();
        return result;
    });
}

namespace {

SceneResult read_scene_file(resolve::Session& session, const std::string& path) {
    SceneResult result;
    resolve::until_stopped(session, [&] {
        const std::optional<std::uint32_t> base = resolve::load_source(session, path, {});
        if (!base) return;
        const std::unique_ptr<json::Json> json = json::parse_json(session.sources, *base, session.diagnostics);
        const format::SceneFiles files{
            .find = [&](const std::string& name, Span at) { return resolve::find_file(session, name, path, at); },
            .require = [&](const std::string& name, Span at) { return resolve::require_file(session, name, path, at); },
            .require_graph = [&](const std::string& name,
                                 Span at) { return resolve::require_graph(session, name, path, at); }};
        const format::Reading reading{session.sources, session.ast, session.diagnostics};
        if (json) result.scene = format::read_scene(reading, *json, path, resolve::file_stem(path), files);
    });
    result.diagnostics = to_public(session.diagnostics, session.sources);
    result.dependencies = std::move(session.dependencies);
    result.missing.assign(session.missing.begin(), session.missing.end());
    result.ok = !session.diagnostics.has_errors();
    return result;
}

}  // namespace

SceneResult Compiler::read_scene(const std::string& path, const CompileOptions& options) const {
    return guarded<SceneResult>(path, [&](Trail& trail) {
        resolve::Session session(*impl_->library, options);
        const TrailGuard guard(trail, session.diagnostics);
        return read_scene_file(session, path);
    });
}

EvalResult Compiler::evaluate(std::string_view node, std::span<const std::pair<std::string, std::string>> arguments,
                              bool single, std::span<const NamedValue> names) const {
    return guarded<EvalResult>({}, [&](Trail& trail) {
        const CompileOptions options;
        resolve::Session session(*impl_->library, options);
        Diagnostics& diagnostics = session.diagnostics;
        const TrailGuard guard(trail, diagnostics);
        EvalResult result;
        Effort effort;
        resolve::until_stopped(session, [&] {
            const std::optional<Callee> callee = find_callee(session, node);
            if (!callee) return;
            const std::string_view name = callee->function.name;
            const auto values = read_arguments(session, callee->function, arguments);
            diagnostics.set_context(name, {});
            if (diagnostics.has_errors()) return;
            Evaluation evaluation =
                evaluate_call({session.library, callee->declarations, session.sources, names, &effort},
                              callee->function, values, single ? Precision::Float : Precision::Double, diagnostics, {});
            result.outputs = std::move(evaluation.outputs);
        });
        result.ok = !diagnostics.has_errors();
        result.diagnostics = to_public(diagnostics, session.sources);
        return result;
    });
}

EvalResult Compiler::evaluate_expression(std::string_view expression, std::span<const NamedValue> names,
                                         bool single) const {
    return guarded<EvalResult>({}, [&](Trail&) {
        const CompileOptions options;
        resolve::Session session(*impl_->library, options);
        EvalResult result;
        Effort effort;
        resolve::until_stopped(session, [&] {
            const nodelang::Expr* const parsed =
                read_argument(std::string(expression), session.sources, session.ast, session.diagnostics);
            if (!parsed) return;
            const EvaluationContext context{session.library, session.library.declarations, session.sources, names,
                                            &effort};
            Evaluation evaluation = patina::evaluate_expression(
                context, *parsed, single ? Precision::Float : Precision::Double, session.diagnostics);
            result.outputs = std::move(evaluation.outputs);
        });
        result.ok = !session.diagnostics.has_errors();
        result.diagnostics = to_public(session.diagnostics, session.sources);
        return result;
    });
}

std::string Compiler::schema() const {
    return format::make_schema(
        {.nodes = nodes(), .semantics = semantics(), .workflows = workflows(), .lighting_models = lighting_models()});
}

Compiler::Formatted Compiler::format(const std::string& path, std::string text, const Limits& limits) const {
    const auto work = [&]() -> Formatted {
        SourceMap sources;
        Diagnostics diagnostics;
        const std::uint32_t base = sources.add(path, std::move(text));
        format::FormattedText formatted = format::format_graph(sources, base, diagnostics);
        return {.ok = formatted.ok, .text = std::move(formatted.text), .diagnostics = to_public(diagnostics, sources)};
    };
    return guarded<Formatted>(path, [&](Trail&) { return within<Formatted>(limits, text.size(), work); });
}

}  // namespace patina
