// Finds the value of an input. It is written in the document, comes from an interface or from another node, or is the
// default of the definition.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "compiler/base/text.h"
#include "compiler/importers/mtlx/colors.h"
#include "compiler/importers/mtlx/graph_maker.h"
#include "compiler/importers/mtlx/library.h"
#include "compiler/importers/patterns.h"

namespace patina::importers::mtlx {
namespace {

constexpr std::size_t kDeepest = 250;

// Lengths in metres, and angles in degrees, as the standard library defines them.
std::optional<double> unit_scale(std::string_view unit) {
    static constexpr std::pair<std::string_view, double> kUnits[] = {
        {"nanometer", 1e-9}, {"micron", 1e-6},   {"millimeter", 1e-3}, {"centimeter", 1e-2},
        {"inch", 0.0254},    {"foot", 0.3048},   {"yard", 0.9144},     {"meter", 1},
        {"kilometer", 1e3},  {"mile", 1609.344}, {"degree", 1},        {"radian", 57.29577951308232}};
    for (const auto& [name, scale] : kUnits)
        if (name == unit) return scale;
    return std::nullopt;
}

std::string_view interface_of(const Element& input) {
    return input.attribute("interfacename");
}

// MaterialX connects like to like. What a document connects otherwise is converted, and said.
void report_mismatch(GraphMaker& maker, const Element& input, std::string_view given_type, std::string_view giver) {
    const Type wanted = type_of_word(input.type()), given = type_of_word(given_type);
    if (input.has("channels") || wanted == given) return;
    const bool is_number = terms::is_vector(wanted) && terms::is_vector(given);
    if (!is_number && wanted != Type::Bool && given != Type::Bool) return;
    if (wanted == Type::None || given == Type::None) return;
    const std::size_t width = terms::width(wanted), others = terms::width(given);
    std::string what = others == 1      ? "it stands for each component"
                       : others < width ? "what is missing is 0"
                       : width == 1     ? "its first component counts"
                                        : fmt::format("its first {} components count", width);
    if (is_number && others > 1 && others < width && width == 4) what += ", and the fourth component is 1";
    if (wanted == Type::Bool) what = "it is true where that is not 0";
    if (given == Type::Bool) what = "it is 1 where that is true, else 0";
    maker.remark(Remark::Kind::Changed, fmt::format("input '{}'", input.name()),
                 fmt::format("it takes a {} and reads '{}', which is a {}: {}", input.type(), giver, given_type, what),
                 input);
}

// How a literal is read that has more or fewer numbers than its type.
std::string_view reading(std::size_t given, std::size_t wanted, bool is_matrix) {
    if (given > wanted) return "the first ones count";
    if (is_matrix) return "the identity matrix stands for it";
    if (given == 1) return "it stands for each component";
    return wanted == 4 && given > 0 ? "what is missing is 0, and the fourth component is 1" : "what is missing is 0";
}

}  // namespace

// Version 1.36 says "parameter" for inputs that cannot vary, and "bindinput" at materials.
bool is_input(const Element& element) {
    return element.category == "input" || element.category == "parameter" || element.category == "bindinput" ||
           element.category == "bindparam";
}

const Element* input_of(const Element& node, std::string_view name) {
    const auto found =
        std::ranges::find_if(node.children, [&](const Element& each) { return is_input(each) && each.name() == name; });
    return found == node.children.end() ? nullptr : &*found;
}

void count_uses(const Element& element, std::map<std::string, std::size_t, std::less<>>& uses) {
    for (const Element& each : element.children) {
        if (each.category == "nodegraph") continue;
        if (each.has("nodename")) ++uses[std::string(each.attribute("nodename"))];
        if (each.has("nodegraph")) ++uses[fmt::format("{}/{}", each.attribute("nodegraph"), each.attribute("output"))];
        if (each.has("interfacename")) ++uses["$" + std::string(each.attribute("interfacename"))];
        count_uses(each, uses);
    }
}

Type type_of_word(std::string_view type) {
    if (type == "boolean") return Type::Bool;
    if (type == "float" || type == "integer") return Type::Float;
    if (type == "vector2") return Type::Float2;
    if (type == "vector3" || type == "color3") return Type::Float3;
    if (type == "vector4" || type == "color4") return Type::Float4;
    if (type == "matrix33") return Type::Matrix3;
    if (type == "matrix44") return Type::Matrix4;
    return Type::None;
}

bool is_color(std::string_view type) {
    return type == "color3" || type == "color4";
}

Scope& GraphMaker::scope_of(const Element& graph, Scope& around, const Element* definition, const Element* instance,
                            Scope* caller) {
    for (const auto& each : scopes_)
        if (each->element == &graph && each->instance == instance && each->caller == caller) return *each;
    scopes_.push_back(std::make_unique<Scope>(Scope{.element = &graph,
                                                    .around = &around,
                                                    .definition = definition,
                                                    .instance = instance,
                                                    .caller = caller,
                                                    .number = scopes_.size()}));
    Scope& made = *scopes_.back();
    if (!made.definition && graph.has("nodedef"))
        made.definition = import_.document.root.child("nodedef", graph.attribute("nodedef"));  // of the document
    count_uses(graph, made.uses);
    return made;
}

std::size_t GraphMaker::uses(const Scope& scope, const Element& node) const {
    const auto found = scope.uses.find(node.name());
    return found == scope.uses.end() ? 0 : found->second;
}

const Element* GraphMaker::find(Scope& scope, std::string_view name) const {
    for (const Scope* each = &scope; each; each = each->around)
        if (const Element* found = each->element->child("", name)) return found;
    return nullptr;
}

Source GraphMaker::source_of(Scope& scope, const Element& node, std::string_view name) {
    const Element* input = input_of(node, name);
    Scope* at = &scope;
    // Each step leaves a node graph, so there is an end.
    for (std::size_t steps = 0; input && steps < 1000; ++steps) {
        const std::string_view wanted = interface_of(*input);
        if (wanted.empty()) return {.input = input, .scope = at};
        const Element* const own = input_of(*at->element, wanted);
        const Element* const defined = at->definition ? input_of(*at->definition, wanted) : nullptr;
        if (at->instance) {
            if (const Element* given = input_of(*at->instance, wanted)) {
                input = given;
                at = at->caller;
                continue;
            }
            return {.input = defined ? defined : own, .scope = at};
        }
        const Element* const interface = own ? own : defined;
        if (!interface) return {};
        import_.reached.insert(interface);
        if (interface == own && at->around &&
            (own->has("nodename") || own->has("nodegraph") || own->has("interfacename"))) {
            input = own;
            at = at->around;
            continue;
        }
        return {.input = interface, .scope = at, .is_interface = true};
    }
    return {};
}

bool GraphMaker::is_set(Scope& scope, const Element& node, std::string_view name) {
    const Source source = source_of(scope, node, name);
    return source.input && (source.input->has("value") || source.input->has("nodename") ||
                            source.input->has("nodegraph") || source.input->has("output"));
}

std::string GraphMaker::type_of(Scope& scope, const Element& node, std::string_view name) {
    if (!is_set(scope, node, name)) return {};
    const Element* const own = input_of(node, name);
    return std::string(own->type().empty() ? source_of(scope, node, name).input->type() : own->type());
}

std::string GraphMaker::word_of(Scope& scope, const Element& node, std::string_view name) {
    const Source source = source_of(scope, node, name);
    if (!source.input || source.input->has("nodename") || source.input->has("nodegraph")) return {};
    return std::string(source.input->attribute("value"));
}

// "1, 0.5, 0" in any type; colours become linear.
Term GraphMaker::literal(const Element& input, std::string_view type, std::string_view text) {
    const Type wanted = type_of_word(type);
    const bool is_stated = input.has("value") && type == input.type() && text == input.attribute("value");
    if (wanted == Type::Bool) {
        const bool is_true = text == "true" || text == "1";
        if (is_stated && !is_true && text != "false" && text != "0")
            remark(Remark::Kind::LeftOut, fmt::format("input '{}'", input.name()),
                   fmt::format("'{}' is neither true nor false: false stands for it", text.substr(0, 40)), input);
        return terms::flag_term(is_true);
    }
    std::vector<double> numbers;
    constexpr std::string_view kBetween = ", \t\r\n";
    for (std::size_t begin = 0; (begin = text.find_first_not_of(kBetween, begin)) < text.size();) {
        const std::size_t end = std::min(text.find_first_of(kBetween, begin), text.size());
        const std::string_view word = text.substr(begin, end - begin);
        const auto value = read_number(word);
        const bool is_number = value && std::isfinite(static_cast<float>(*value));
        if (!is_number)
            remark(Remark::Kind::LeftOut, fmt::format("input '{}'", input.name()),
                   fmt::format("'{}' is no number: 0 stands for it", word.substr(0, 40)), input);
        numbers.push_back(is_number ? *value : 0);
        begin = end;
        if (numbers.size() > 16) break;
    }
    if (type == "integer")
        for (double& each : numbers) {
            const double whole = std::clamp(std::trunc(each), -2147483648.0, 2147483647.0);
            if (whole != each)
                remark(Remark::Kind::Changed, fmt::format("input '{}'", input.name()),
                       fmt::format("'{}' is no whole number of 32 bits: {} stands for it", shortest(each),
                                   static_cast<std::int64_t>(whole)),
                       input);
            each = whole;
        }
    const bool is_matrix = wanted == Type::Matrix3 || wanted == Type::Matrix4;
    const std::size_t rows = terms::width(wanted), count = is_matrix ? rows * rows : rows;
    if (is_stated && numbers.size() != count && count > 0) {
        const bool is_whole = numbers.size() > count || (numbers.size() == 1 && !is_matrix);
        remark(is_whole ? Remark::Kind::Changed : Remark::Kind::LeftOut, fmt::format("input '{}'", input.name()),
               fmt::format("'{}' is {} number{}, and a {} has {}: {}", text.substr(0, 40), numbers.size(),
                           numbers.size() == 1 ? "" : "s", type, count, reading(numbers.size(), count, is_matrix)),
               input);
    }
    if (is_matrix && numbers.size() < count) {
        numbers.clear();
        for (std::size_t i = 0; i < count; ++i) numbers.push_back(i % (rows + 1) == 0 ? 1 : 0);
    }
    if (numbers.empty()) numbers.push_back(0);
    if (numbers.size() == 1) numbers.resize(count, numbers[0]);
    while (numbers.size() < count) numbers.push_back(numbers.size() == 3 ? 1 : 0);
    numbers.resize(count);
    if (is_color(type) && !input.colorspace.empty()) {
        const Colorspace space = colorspace_of(input.colorspace);
        if (!space.is_known)
            remark(Remark::Kind::Changed, fmt::format("input '{}'", input.name()),
                   fmt::format("the colour space '{}' is not known: its numbers are taken as linear", input.colorspace),
                   input);
        to_linear(space, numbers);
    }
    if (const std::string_view unit = input.attribute("unit"); !unit.empty()) {
        const auto scale = unit_scale(unit);
        if (!scale)
            remark(Remark::Kind::Changed, fmt::format("input '{}'", input.name()),
                   fmt::format("the unit '{}' is not known: its number is taken as it is", unit), input);
        for (double& each : numbers) each *= scale.value_or(1);
    }
    Term made{.type = wanted, .numbers = std::move(numbers)};
    return made;
}

Term GraphMaker::geometry(std::string_view property, Type type) {
    Term made;
    if (property == "UV0" || property == "UV1") {
        const Term semantic = terms::link(property == "UV0" ? "@uv0" : "@uv1", Type::Float2);
        made = terms::flipped(semantic);
        made.name = property == "UV0" ? "uv" : "uv1";
        made.from_top = semantic.tree;
        return made;
    }
    static constexpr std::pair<std::string_view, std::string_view> kValues[] = {
        {"Pobject", "@positionOS"}, {"Pworld", "@positionWS"},     {"Nobject", "@normalOS"},
        {"Nworld", "@normalWS"},    {"Tobject", "@tangentOS.xyz"}, {"Tworld", "@tangentWS"},
        {"Bworld", "@bitangentWS"}, {"Vworld", "-@viewDirWS"}};
    for (const auto& [name, value] : kValues)
        if (name == property) return terms::expression(value, Type::Float3);
    return terms::converted(terms::number_term(0), type);
}

// The input of a node graph that an output hands on as it is; else the input itself.
const Element& GraphMaker::stated(Scope& scope, const Element& input) const {
    const Element* const graph = input.has("nodegraph") ? find(scope, input.attribute("nodegraph")) : nullptr;
    const Element* const output = graph ? graph->child("output", input.attribute("output")) : nullptr;
    const Element* const found = output ? input_of(*graph, interface_of(*output)) : nullptr;
    return found ? *found : input;
}

Term GraphMaker::input(Scope& scope, const Element& node, const Port& port, bool may_stay_number) {
    const std::string own_type = type_of(scope, node, port.name);
    const std::string type_word = !own_type.empty()   ? own_type
                                  : port.type.empty() ? std::string(node.type())
                                                      : port.type;
    Type type = type_of_word(type_word);
    if (type == Type::None) type = Type::Float3;  // "multioutput"
    const Source source = source_of(scope, node, port.name);
    Term made;
    if (!source.input || !is_set(scope, node, port.name)) {
        const Element* const geometric = source.input && source.input->has("defaultgeomprop") ? source.input : nullptr;
        if (geometric)
            made = geometry(geometric->attribute("defaultgeomprop"), type);
        else if (port.otherwise.starts_with("@"))
            made = geometry(std::string_view(port.otherwise).substr(1), type);
        else
            made = literal(Element{}, type_word, port.otherwise);
    } else if (source.is_interface) {
        if (const Element* own = input_of(node, port.name); own && own != source.input)
            report_mismatch(*this, *own, source.input->type(), source.input->name());
        made = property_of(*source.input);
    } else {
        made = value_at(*source.scope, *source.input, type);
    }
    // A number with a unit is in metres or degrees so far.
    const auto scale = unit_scale(port.unit);
    if (scale && source.input && unit_scale(stated(*source.scope, *source.input).attribute("unit"))) {
        for (double& each : made.numbers) each /= *scale;
        if (!made.is_constant()) {
            const Term factor = terms::number_term(std::round(1 / *scale * 1e9) / 1e9);
            made = terms::computed("a * b", {made, factor}, made.type);
        }
    }
    if (source.input && input_of(node, port.name) && input_of(node, port.name)->has("channels"))
        made = terms::swizzled(made, input_of(node, port.name)->attribute("channels"));
    // What an interface hands to several readers gets a name.
    const Element* const own = input_of(node, port.name);
    if (own && own->has("interfacename") && !made.is_short()) {
        const auto found = scope.uses.find("$" + std::string(own->attribute("interfacename")));
        if (found != scope.uses.end() && found->second > 1) made = named(made);
    }
    if (made.is_constant() && terms::is_vector(made.type) && made.numbers.size() > 1 && may_stay_number &&
        made.is_all(made.numbers[0]) && made.type == type) {
        Term number = terms::number_term(made.numbers[0]);
        number.nodes = made.nodes;
        return number;
    }
    Term converted = terms::converted(made, type, may_stay_number);
    if (converted.type == Type::None) {
        approximate(node, fmt::format("its input '{}' takes {} and is connected to {}: it has 0", port.name,
                                      terms::word(type), terms::word(made.type)));
        return terms::converted(terms::number_term(0), type);
    }
    return converted;
}

// What the document writes at an input, or connects to it.
Term GraphMaker::value_at(Scope& scope, const Element& input, Type type) {
    if (!input.has("nodename") && !input.has("nodegraph") && !input.has("output")) {
        Term made =
            literal(input, input.type().empty() ? std::string_view("float") : input.type(), input.attribute("value"));
        return made.type == Type::None ? terms::converted(terms::number_term(0), type) : made;
    }
    return connected(scope, input);
}

Term GraphMaker::connected(Scope& scope, const Element& input) {
    const std::string_view output = input.attribute("output");
    const Type type = type_of_word(input.type());
    // An output can read itself, by way of other outputs.
    if (depth_ > kDeepest) return magenta(input, type == Type::None ? Type::Float : type, "it is nested too deep");
    struct Level {
        explicit Level(std::size_t& depth) : depth_(++depth) {}
        ~Level() { --depth_; }
        std::size_t& depth_;
    };
    const Level level(depth_);
    const std::string_view name = input.has("nodename") ? input.attribute("nodename") : input.attribute("nodegraph");
    const Element* const found = find(scope, name.empty() ? output : name);
    if (!found) {
        remark(Remark::Kind::LeftOut, fmt::format("input '{}'", input.name()),
               fmt::format("it reads '{}', which is not there", name.empty() ? output : name), input);
        return magenta(input, type == Type::None ? Type::Float : type,
                       fmt::format("'{}' is not there", name.empty() ? output : name));
    }
    if (found->category != "nodegraph" && (output.empty() || output == "out" || found->category == "output"))
        report_mismatch(*this, input, found->type(), found->name());
    if (found->category == "output") return connected(scope, *found);
    // The scope in which it stands.
    Scope* at = &scope;
    while (at->around && !at->element->child("", found->name())) at = at->around;
    if (found->category == "nodegraph") return output_of(*found, *at, output, input);
    return evaluate(*at, *found, output.empty() ? std::string_view("out") : output);
}

Term GraphMaker::output_of(const Element& graph, Scope& around, std::string_view output, const Element& reader) {
    Scope& scope = scope_of(graph, around);
    const Element* found = output.empty() ? nullptr : graph.child("output", output);
    if (!found)
        for (const Element& each : graph.children)
            if (!found && output.empty() && each.category == "output") found = &each;
    if (!found) {
        remark(Remark::Kind::LeftOut, fmt::format("input '{}'", reader.name()),
               fmt::format("the node graph '{}' has no output '{}'", graph.name(), output), reader);
        const Type type = type_of_word(reader.type());
        return magenta(reader, type == Type::None ? Type::Float : type, "the output is not there");
    }
    report_mismatch(*this, reader, found->type(), found->name());
    Term made;
    if (found->has("nodename") || found->has("nodegraph")) {
        made = connected(scope, *found);
        if (found->has("channels")) made = terms::swizzled(made, found->attribute("channels"));
    } else if (found->has("interfacename")) {
        Element value{.attributes = {{"type", std::string(found->type())},
                                     {"interfacename", std::string(found->attribute("interfacename"))}}};
        made =
            this->input(scope, node_with(std::move(value), *found), {.name = "in", .type = std::string(found->type())});
    } else {
        made = literal(*found, found->type(), found->attribute("value"));
    }
    const auto uses = around.uses.find(fmt::format("{}/{}", graph.name(), output));
    if (uses != around.uses.end() && uses->second > 1 && !made.is_short()) made = named(made);
    return made;
}

const Element* GraphMaker::implementation(const Element& node, const Element*& definition) const {
    definition = nullptr;
    for (const Element* root : {&import_.document.root, &standard_library()})
        if (const Element* const found = implementation_in(*root, node, definition); found || definition) return found;
    return nullptr;
}

const Element* GraphMaker::implementation_in(const Element& root, const Element& node, const Element*& definition) {
    for (const Element& each : root.children) {
        if (each.category != "nodedef") continue;
        const bool is_named = node.has("nodedef") && each.name() == node.attribute("nodedef");
        bool fits = each.attribute("node") == node.category && !node.has("nodedef");
        if (fits && each.has("type")) fits = each.type() == node.type();
        if (fits && !each.has("type")) {
            std::size_t outputs = 0;
            bool has_type = false;
            for (const Element& child : each.children) {
                if (child.category != "output") continue;
                ++outputs;
                has_type |= child.type() == node.type();
            }
            fits = outputs != 1 || has_type;
        }
        if (!is_named && !fits) continue;
        definition = &each;
        for (const Element& graph : root.children) {
            if (graph.category == "nodegraph" && graph.attribute("nodedef") == each.name()) return &graph;
            if (graph.category == "implementation" && graph.attribute("nodedef") == each.name() &&
                graph.has("nodegraph"))
                return root.child("nodegraph", graph.attribute("nodegraph"));
        }
    }
    return nullptr;
}

}  // namespace patina::importers::mtlx
