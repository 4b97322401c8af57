// Joins the properties of all graphs into those of the material: decides which properties are the same, and sorts them.
// The names and the order of nodes do not matter. So a rearranged graph keeps its block, its slots and its ids.
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "compiler/base/text.h"
#include "compiler/format/words.h"
#include "compiler/resolve/material.h"

namespace patina::resolve {

using nodelang::Expr;

namespace {

// The file of a texture's default, or the word for it. Nothing if the file does not exist, which has been reported.
std::optional<std::string> find_texture(Session& session, const format::Property& property, const std::string& from) {
    if (!is_texture_file(property)) return property.texture;
    std::string path =
        require_file(session, property.texture, from, property.default_span ? property.default_span : property.span);
    return path.empty() ? std::nullopt : std::optional(std::move(path));
}

// A difference between two declarations of one property, in words, and the two places.
struct Difference {
    std::string first, second;
    Span first_at, second_at;
};

std::string range_text(const format::Property& property, bool by_hardness) {
    if (!property.range) return "no range";
    if (by_hardness) return property.hard ? "a hard range" : "a soft range";
    return fmt::format("the range {} to {}", shortest((*property.range)[0]), shortest((*property.range)[1]));
}

std::string sampler_text(const format::Property& property, const format::Property& from) {
    const Sampler &sampler = property.sampler, &other = from.sampler;
    if (property.shared_sampler != from.shared_sampler)
        return property.shared_sampler.empty() ? "a sampler of its own"
                                               : fmt::format("the shared sampler {}", property.shared_sampler);
    if (sampler.wrap != other.wrap) return fmt::format("the wrap mode {}", to_string(sampler.wrap));
    if (sampler.filter != other.filter) return fmt::format("the filter {}", to_string(sampler.filter));
    return fmt::format("an anisotropy of {}", sampler.anisotropy);
}

std::string values_text_of(const format::Property& property) {
    const std::vector<std::string_view> values(property.values.begin(), property.values.end());
    return fmt::format("the values {}", enumerate(values));
}

std::string default_text(const Session& session, const format::Property& property) {
    if (!property.default_span) return "no default";
    return fmt::format("the default {}", json::shown(session.sources.text(property.default_span)));
}

Difference difference(const format::Property& first, const format::Property& second, auto text,
                      Span format::Property::*at = nullptr) {
    const auto place = [&](const format::Property& p) { return at && p.*at ? p.*at : p.name_span; };
    return {text(first), text(second), place(first), place(second)};
}

// A difference in the kind of property, which all declarations must share.
std::optional<Difference> differing_kind(const format::Property& a, const format::Property& b) {
    if (a.type != b.type)
        return difference(a, b, [](auto& p) { return fmt::format("the type {}", to_string(p.type)); });
    if (a.binding != b.binding) {
        const auto text = [](auto& p) { return fmt::format("\"as\": \"{}\"", to_string(p.binding)); };
        return difference(a, b, text, &format::Property::binding_span);
    }
    if (a.values != b.values) return difference(a, b, values_text_of);
    if (a.usage == b.usage) return {};
    return difference(a, b, [](auto& p) { return fmt::format("the usage {}", to_string(p.usage)); });
}

// A difference in what the material's own declaration may decide for all others. A default that neither states follows
// from the range.
std::optional<Difference> differing_choice(const Session& session, const format::Property& a, const format::Property& b,
                                           bool same_default) {
    if (!same_default && (a.default_span || b.default_span))
        return difference(
            a, b, [&](auto& p) { return default_text(session, p); }, &format::Property::default_span);
    if (a.range != b.range || a.hard != b.hard)
        return difference(a, b, [&](auto& p) { return range_text(p, a.range == b.range); });
    if (a.tiling != b.tiling)
        return difference(a, b, [](auto& p) { return std::string(p.tiling ? "tiling" : "no tiling"); });
    if (a.handedness != b.handedness)
        return difference(
            a, b, [](auto& p) { return fmt::format("the handedness {}", to_string(p.handedness)); },
            &format::Property::handedness_span);
    if (a.swizzle != b.swizzle)
        return difference(
            a, b, [](auto& p) { return p.swizzle.empty() ? "no swizzle" : fmt::format("the swizzle {}", p.swizzle); },
            &format::Property::swizzle_span);
    if ((a.sampler == b.sampler && a.shared_sampler == b.shared_sampler) || a.type == PropertyType::Sampler) return {};
    return difference(
        a, b, [&](auto& p) { return sampler_text(p, &p == &a ? b : a); }, &format::Property::sampler_span);
}

MaterialProperty entry_of(Session& session, const format::Property& property, const JoinOptions& options) {
    MaterialProperty entry{.property = &property,
                           .texture_path = find_texture(session, property, options.from).value_or(""),
                           .is_own = options.is_own || options.said_at,
                           .is_at_port = options.is_at_port,
                           .chosen = property.value[0]};
    entry.is_file = is_texture_file(property) && !entry.texture_path.empty();
    if (entry.is_file) session.dependencies.push_back(entry.texture_path);
    return entry;
}

// A default that the material gives to its lighting graph also applies to the sub-graphs that declared the property
// before.
void take_over(Session& session, MaterialProperty& entry, const format::Property& property,
               const JoinOptions& options) {
    format::Property& said = session.file_properties.emplace_back(property);
    said.label = entry.property->label;
    said.group = entry.property->group;
    said.help = entry.property->help;
    MaterialProperty made = entry_of(session, said, options);
    if (entry.is_chosen) made.chosen = entry.chosen;
    made.is_chosen = entry.is_chosen;
    entry = std::move(made);
}

// Adds a property whose name the material has already.
void share(Session& session, const Material& material, MaterialProperty& entry, const format::Property& property,
           const JoinOptions& options) {
    const format::Property& first = *entry.property;
    if (&first == &property) return;
    const auto report = [&](const Difference& of) -> DiagnosticRecord& {
        return session.diagnostics
            .report(Code::ImpossibleValue, of.second_at, property.name,
                    fmt::format("declared alike everywhere: it has {} here, but {} elsewhere", of.second, of.first))
            .note(of.first_at, "the other declaration is here");
    };
    if (const std::optional<Difference> kind = differing_kind(first, property)) {
        report(*kind);
        return;
    }
    if (options.said_at && !entry.is_own && !entry.is_at_port && !material.pass)
        return take_over(session, entry, property, options);
    const bool is_said = options.said_at || options.is_at_port;
    if (entry.is_own && !is_said) return;  // the material's own declaration decides
    bool same_default = first.value == property.value && first.numbers == property.numbers &&
                        (property.type != PropertyType::Sampler || first.sampler == property.sampler);
    if (is_texture(property.type)) {
        const std::optional<std::string> texture = find_texture(session, property, options.from);
        if (!texture) return;
        same_default = *texture == entry.texture_path;
    }
    const std::optional<Difference> choice = differing_choice(session, first, property, same_default);
    if (!choice || (options.said_at && same_default)) return;
    DiagnosticRecord& record = report(*choice);
    if (material.pass && options.said_at)
        record.note("a pass shares the material's properties");
    else if (options.is_at_port || entry.is_at_port)
        record.note(fmt::format("a file at a port becomes a property named after it: '{}'", property.name));
    else if (!is_said)
        record.note(fmt::format("if the material declares '{}', its declaration applies everywhere", property.name));
}

struct Brought {
    const format::Property* property;
    const std::string* from;
    bool is_at_port = false;
};
using AllBrought = std::vector<Brought>;

// Orders by names, because they are the interface. Equal names are ordered by the texts that artists see.
bool comes_before(const AllBrought& a, const AllBrought& b) {
    const auto less = [](const AllBrought& some, const AllBrought& others, auto key) {
        return std::lexicographical_compare(
            some.begin(), some.end(), others.begin(), others.end(),
            [&](const Brought& x, const Brought& y) { return key(*x.property) < key(*y.property); });
    };
    const auto name = [](const format::Property& p) { return std::tie(p.name); };
    if (less(a, b, name)) return true;
    if (less(b, a, name)) return false;
    return less(a, b, [](const format::Property& p) { return std::tie(p.label, p.group, p.help); });
}

class Collector {
public:
    Collector(Session& session, const Material& material) : session_(session), material_(material) {}

    // Each property once: first the graph's own, in its order; then the files at its ports, by name; then those of its
    // sub-graphs.
    const AllBrought& brought_by(const CheckedGraph& checked) {
        const auto [found, is_new] = known_.try_emplace(&checked);
        if (!is_new) return found->second;
        AllBrought all;
        const format::Graph& graph = *checked.graph;
        // The lighting graph's properties are joined separately, because the material may have bound them.
        for (const format::Property& property : graph.properties) {
            if (&checked != material_.lighting) all.push_back({&property, &graph.path});
        }
        add_unnamed(checked, all);
        std::set<const CheckedGraph*> seen;
        std::vector<const AllBrought*> parts;
        for (const ResolvedNode& node : checked.nodes) {
            if (node.subgraph && seen.insert(node.subgraph).second) parts.push_back(&brought_by(*node.subgraph));
        }
        std::stable_sort(parts.begin(), parts.end(),
                         [](const AllBrought* x, const AllBrought* y) { return comes_before(*x, *y); });
        std::set<const format::Property*> here;
        for (const Brought& own : all) here.insert(own.property);
        for (const AllBrought* part : parts) {
            for (const Brought& each : *part) {
                if (here.insert(each.property).second) all.push_back(each);
            }
        }
        return known_[&checked] = std::move(all);
    }

private:
    // Files and samplers at ports.
    void add_unnamed(const CheckedGraph& checked, AllBrought& all) {
        const format::Graph& graph = *checked.graph;
        const std::size_t own = all.size();
        const auto add = [&](const format::PortValue& port) {
            if (port.value) add_unnamed(*port.value, checked, all);
        };
        for (const format::Node& node : graph.nodes) {
            if (node.expr) add_unnamed(*node.expr, checked, all);
            std::for_each(node.inputs.begin(), node.inputs.end(), add);
        }
        for (const auto* ports : {&graph.vertex, &graph.surface, &graph.outputs})
            std::for_each(ports->begin(), ports->end(), add);
        for (const format::Input& input : graph.inputs) {
            if (input.value) add_unnamed(*input.value, checked, all);
        }
        std::stable_sort(all.begin() + static_cast<std::ptrdiff_t>(own), all.end(),
                         [](const Brought& a, const Brought& b) { return a.property->name < b.property->name; });
    }

    // A file at a port is a texture property without a name of its own, and so is a sampler that is named there.
    void add_unnamed(const Expr& expr, const CheckedGraph& checked, AllBrought& all) {
        const bool is_name = expr.kind == Expr::Kind::Name && !checked.by_id.contains(expr.text);
        const NamedSampler* const sampler = is_name ? find_sampler(expr.text) : nullptr;
        if (expr.kind == Expr::Kind::File || sampler) {
            format::Property& property = session_.file_properties.emplace_back();
            property.name = sampler ? std::string(expr.text) : file_texture_name(expr.text);
            property.name_span = property.span = property.default_span = expr.span;
            property.type = sampler ? PropertyType::Sampler : PropertyType::Texture2D;
            if (sampler) property.sampler = sampler->sampler;
            (sampler ? property.shared_sampler : property.texture) = std::string(expr.text);
            all.push_back({&property, &checked.graph->path, true});
        }
        for (const Expr* argument : expr.args) add_unnamed(*argument, checked, all);
    }

    Session& session_;
    const Material& material_;
    std::map<const CheckedGraph*, AllBrought> known_;
};

}  // namespace

bool is_texture_file(const format::Property& property) {
    return is_texture(property.type) && property.texture.find_first_of("./") != std::string::npos;
}

void join_property(Session& session, Material& material, const format::Property& property, const JoinOptions& options) {
    const auto [existing, is_new] = material.property_index.emplace(property.name, material.properties.size());
    if (!is_new) return share(session, material, material.properties[existing->second], property, options);
    material.properties.push_back(entry_of(session, property, options));
}

void join_graph(Session& session, Material& material, const CheckedGraph& graph) {
    const std::size_t own = graph.graph->properties.size();
    const AllBrought all = Collector(session, material).brought_by(graph);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool is_own = &graph == material.graph && i < own;
        join_property(session, material, *all[i].property,
                      {.from = *all[i].from, .is_own = is_own, .is_at_port = all[i].is_at_port});
    }
}

std::string file_texture_name(std::string_view path) {
    std::string name = "_";
    for (char c : file_stem(path)) name += is_identifier(std::string("_") + c) ? c : '_';
    return name;
}

}  // namespace patina::resolve
