#include "witness/random_graph.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "witness/bench.h"
#include "witness/random_expressions.h"
#include "witness/random_guards.h"

namespace patina::witness {
namespace {

constexpr int kPairs = 4;  // of twins: in one pair, the errors of a graph may cancel

double size_of(char error) {
    // The tolerances of the operations; of halves, two roundings, and four in a node.
    switch (error) {
        case kHalf: return 1e-3;
        case kHalfNode: return 2e-3;
        case kTranscendental:
        case kNode:
        case kCoarse: return 1e-4;
        default: return 1e-5;
    }
}
// What is added to a value that may be zero: what is left of a sum that cancels.
double size_at_zero(char error) {
    return error == kHalfNode ? 2e-3 : error == kCoarse ? 1e-3 : error == kSum || error == kNode ? 1e-6 : 0;
}

// `noise` null: exact. With the same dice and the other sign, all errors are turned around.
std::string render(const std::string& marked, Dice* noise, double sign) {
    std::string text, open;
    for (std::size_t i = 0; i < marked.size(); ++i) {
        if (marked[i] == kBegin) {
            open += marked[++i];
            text += noise ? "((" : "(";
        } else if (marked[i] == kEnd) {
            if (noise) {
                text += ')';
                const double share = (50 + noise->below(51)) / 100.0;
                const double part = share * (noise->chance(50) ? sign : -sign);
                text += " * " + literal(1 + size_of(open.back()) * part);
                if (const double most = size_at_zero(open.back())) text += " + " + literal(most * part);
            }
            text += ')';
            open.pop_back();
        } else {
            text += marked[i];
        }
    }
    return text;
}

// --- a node file: one function with branches, loops, arrays and a second output

class NodeFile {
public:
    NodeFile(Dice& dice, bool half) : dice_(dice), in_(dice, half) {}

    std::string text(const std::string& name) {
        in_.values = {{"p", 3, 4}, {"q", 1, 4}, {"flag", 0, 1}};
        body_ =
            "    const float table[4] = { 0.5, -1.25, 2, 0.75 };\n"
            "    float3 a = p;\n    float2 b = p.zx;\n    extra = 0;\n";
        in_.values.insert(in_.values.end(), {{"a", 3, 4}, {"b", 2, 4}, {"extra", 1, 4}});
        statements(3 + dice_.below(4), 2, "    ");
        const std::string result = in_.expression(3, 2).text;
        if (dice_.chance(30)) {
            body_ += "    if (" + in_.expression(0, 1).text + ") {\n        return " + in_.expression(3, 1).text +
                     ";\n    } else {\n        return " + result + ";\n    }\n";
        } else {
            body_ += "    return " + result + ";\n";
        }
        return "/// Made by a generator.\n[node(\"Custom/" + name + "\")]\nfloat3 " + name +
               "(float3 p = 0, float q = 0.5, bool flag = true, out float extra) {\n" + body_ + "}\n";
    }

private:
    // Variables stay within 4 whatever happens to them in a loop.
    std::string bounded(int width) {
        const Value value = in_.expression(width, 2);
        return value.largest > 4 ? in_.limited(value).text : value.text;
    }

    void assignment(const std::string& indent) {
        switch (dice_.below(6)) {
            case 0: body_ += indent + "a = " + bounded(3) + ";\n"; break;
            case 1: body_ += indent + "b = " + bounded(2) + ";\n"; break;
            case 2: body_ += indent + "extra = " + bounded(1) + ";\n"; break;
            case 3: body_ += indent + "a.zx = " + bounded(2) + ";\n"; break;
            case 4: body_ += indent + "b.y = clamp(b.y * " + bounded(1) + ", -4, 4);\n"; break;
            default: body_ += indent + "a = clamp(a + " + bounded(3) + ", -4, 4);\n"; break;
        }
    }

    void statements(int count, int depth, const std::string& indent) {
        for (int i = 0; i < count; ++i) {
            const int kind = depth > 0 ? dice_.below(100) : 100;
            if (kind < 20) {
                body_ += indent + "if (" + in_.expression(0, 1).text + ") {\n";
                statements(1 + dice_.below(2), depth - 1, indent + "    ");
                body_ += indent + "}";
                if (dice_.chance(50)) {
                    body_ += " else {\n";
                    statements(1 + dice_.below(2), depth - 1, indent + "    ");
                    body_ += indent + "}";
                }
                body_ += "\n";
            } else if (kind < 40) {
                loop(depth, indent);
            } else {
                assignment(indent);
            }
        }
    }

    void loop(int depth, const std::string& indent) {
        const std::string index(1, "ij"[depth % 2]);
        // Half of the loops end for each pixel at its own count.
        const std::string limit =
            dice_.chance(50) ? std::to_string(2 + dice_.below(3)) : "min(int(abs(" + in_.leaf(1).text + ") * 1.5), 5)";
        body_ += indent + "for (int " + index + " = 0; " + index + " < " + limit + "; " + index + "++) {\n";
        const std::size_t values = in_.values.size();
        in_.values.push_back({"float(" + index + ")", 1, 4});
        in_.values.push_back({"table[" + index + " & 3]", 1, 2});
        in_.ints.push_back(index);
        statements(1 + dice_.below(2), depth - 1, indent + "    ");
        in_.ints.pop_back();
        in_.values.resize(values);
        body_ += indent + "}\n";
    }

    Dice& dice_;
    Expressions in_;
    std::string body_;
};

// --- the graph

class Generator {
public:
    Generator(const Compiler& compiler, unsigned seed) : dice_(seed), has_parts_(seed % 4 == 3) {
        half_graph_ = dice_.chance(8);
        half_nodes_ = half_graph_ || dice_.chance(12);
        for (const NodeInfo& node : compiler.nodes())
            if (is_usable(node)) library_.push_back(&node);
    }

    void make() {
        json_ = "{\n\"patina\": 1, \"workflow\": \"unlit\"," +
                std::string(half_graph_ ? " \"precision\": \"half\"," : "") + "\n\"properties\": [\n" +
                data_property() + ",\n" + R"({ "name": "_Amount", "type": "float", "default": 0.375 },
{ "name": "_Axis", "type": "float3", "default": [0.25, -1.5, 0.75] }
],
"nodes": [
)";
        for (int i = 0; i < kLayers; ++i) {
            const std::string id = "t" + std::to_string(i);
            json_ += load_node(id, "@fragCoord.x", "@fragCoord.y + " + std::to_string(i * kSide));
            json_ += ",\n";
            values_.push_back({id, 4, 2});
        }
        values_.insert(values_.end(), {{"$_Amount", 1, 1}, {"$_Axis", 3, 2}, {"@time", 1, 1}});
        values_.push_back({"(@fragCoord.xy * 0.125)", 2, 1});
        exact_values_.assign(values_.begin(), values_.end());
        if (has_parts_) parts();
        const int count = 5 + dice_.below(26);
        for (int i = 0; i < count; ++i) {
            const int kind = dice_.below(100);
            const std::string id = "n" + std::to_string(i);
            const std::size_t before = values_.size();
            if (kind < 45) {
                library_node(id);
            } else if (kind < 88) {
                expression_node(id);
            } else if (kind < 94) {
                file_node(id);
            } else {
                derivative_node(id);
            }
            for (std::size_t k = before; k < values_.size(); ++k) values_[k].node = id;
            json_ += i + 1 < count ? ",\n" : "\n";
        }
        finish();
    }

    std::string json_;
    std::map<std::string, std::string> files_;
    bool half_nodes_ = false;

private:
    static bool is_usable(const NodeInfo& node) {
        // Hashes of the last digits of a sine: of what is off by a rounding, they are another number.
        if (node.name == "RandomRange" || node.name == "NoiseSineWave") return false;
        // What was drawn before: nothing, and not in the target that is drawn into.
        if (node.name.starts_with("Scene") || node.name == "DepthFade") return false;
        // Thousands of steps a pixel, on domains of their own.
        if (node.name == "SplitSumIntegral") return false;
        // The texels of the data are a texture of two dimensions.
        return std::all_of(node.ports.begin(), node.ports.end(), [&](const PortInfo& port) {
            return !port.type.starts_with("Texture") || port.type == "Texture2D";
        });
    }

    // Its result has differences between pixels, or edges one pixel wide: of computed inputs their rounding would be
    // all that is left.
    static bool needs_exact_inputs(const NodeInfo& node) {
        return node.category == "Math/Derivative" || node.category == "Procedural/Shape" ||
               node.name == "NormalFromHeight" || node.name == "SdfMask" || node.name == "CheckerboardUnity" ||
               node.name == "CalculateLevel";
    }

    // Off by much more than a rounding on lavapipe: arc sine 3.9e-4, arc cosine 1.5e-4; its atan2(), by whose angles
    // MeasuredBRDF finds texels, is off by 3.4e-6, and the node by 1.6e-5.
    static bool is_coarse(const NodeInfo& node) {
        return node.name == "ArcSine" || node.name == "ArcCosine" || node.name == "MeasuredBRDF";
    }

    bool choose_half() { return half_nodes_ && (half_graph_ || dice_.chance(30)); }
    std::string precision(bool half) const { return half && !half_graph_ ? R"(, "precision": "half")" : ""; }
    // Noise of a value in a node: a half's where the node computes in halves.
    Expressions over_values(bool half) {
        Expressions made(dice_, half);
        made.values = values_;
        // A sub-graph has no texel of its own.
        if (std::any_of(values_.begin(), values_.end(), [](const Value& v) { return v.text == "t0"; }))
            made.never = "t0.x > 99";
        return made;
    }

    Expressions inputs_of(const NodeInfo& node, bool half) {
        Expressions made = over_values(half);
        if (needs_exact_inputs(node)) made.values = exact_values_;
        return made;
    }

    void expression_node(const std::string& id) {
        const bool half = choose_half();
        Expressions in = over_values(half);
        const int width = dice_.chance(8) ? 0 : 1 + dice_.below(4);
        const Value value = in.expression(width, 1 + dice_.below(3));
        json_ += R"({ "id": ")" + id + R"(", "expr": ")" + value.text + "\"" + precision(half) + " }";
        values_.push_back({id, width, value.largest});
    }

    // Differences of exact numbers: the rounding of computed ones would be all that is left.
    void derivative_node(const std::string& id) {
        static constexpr const char* kNames[] = {"ddx", "ddy", "fwidth"};
        const std::string layer = "t" + std::to_string(dice_.below(kLayers));
        json_ += R"({ "id": ")" + id + R"(", "expr": ")" + kNames[dice_.below(3)] + "(" + layer + ".xyz * " + layer +
                 ".zwx)\", \"precision\": \"float\" }";
        values_.push_back({id, 3, 16});
    }

    // A gradient or a curve. Its keys are far apart, so that two inputs that are near stay near.
    std::string keys(bool is_gradient) {
        std::string list;
        const int count = 1 + dice_.below(5);
        const auto number = [&](int from, int to) { return literal(dice_.sixteenths(from, to)); };
        for (int i = 0; i < count; ++i) {
            list += (i > 0 ? ", [" : "[") + literal(i * 0.25) + ", ";
            list += is_gradient ? "[" + number(0, 1) + ", " + number(0, 1) + ", " + number(0, 2) + "]]"
                                : number(-2, 2) + ", " + number(-1, 1) + ", " + number(-1, 1) + "]";
        }
        if (!is_gradient) return "{ \"keys\": [" + list + "] }";
        return "{ \"colors\": [" + list + "], \"alphas\": [[0.25, 0.5], [0.75, " + number(0, 1) + "]], \"blend\": \"" +
               (dice_.chance(50) ? "linear" : "perceptual") + "\" }";
    }

    static bool is_matrix(const PortInfo& port) {
        return port.type.starts_with("float") && port.type.find('x') != std::string::npos;
    }

    std::string port_value(const NodeInfo& node, const PortInfo& port, int wide, bool half) {
        // A hash of sines, with which a float is off by 2e-3; RandomRange and NoiseSineWave have no other.
        if (port.type == "NoiseHash") return "Deterministic";
        if (!port.enumerators.empty()) return dice_.pick(port.enumerators).name;
        if (port.type == "Texture2D") return map_;
        // Not a mirroring one: between two texels, on the far side of a mirror, devices take the one or the other.
        if (port.type == "SamplerState") return map_ == "$_Data" ? "nearestRepeat" : "nearestClamp";
        if (port.type == "int") return "= " + std::to_string(1 + dice_.below(3));
        Expressions in = inputs_of(node, half);
        if (port.type == "bool") return "= " + in.expression(0, 1).text;
        if (is_matrix(port)) {
            std::string rows;
            for (char row = '0'; row < port.type.back(); ++row)
                rows += (rows.empty() ? "" : ", ") + in.leaf(port.type.back() - '0').text;
            return "= " + port.type + "(" + rows + ")";
        }
        const int width = port.type == "floatN"  ? (dice_.chance(25) ? 1 : wide)
                          : port.type == "float" ? 1
                                                 : port.type.back() - '0';
        std::string text = in.expression(width, needs_exact_inputs(node) ? 0 : dice_.below(2)).text;
        if (port.range) {
            // Most ranges are 0 to 1. Beyond its range a node promises nothing, and at a roughness or a cosine of zero
            // distributions and visibilities have their poles.
            auto [low, high] = *port.range;
            const bool has_pole = node.category == "Lighting/Distribution" || node.category == "Lighting/Visibility";
            if (has_pole && low == 0) low = 0.125;
            text = "clamp(" + text + ", " + literal(std::max(low, -8.0)) + ", " + literal(std::min(high, 8.0)) + ")";
        }
        // Noise chooses among its cells, as Expressions chooses.
        if (node.category == "Procedural/Noise" && !in.never.empty()) text = "(" + in.never + " ? 0 : " + text + ")";
        const std::string name = node.name + "." + port.name;
        for (const Guard& guard : kGuards) {
            if (guard.port != name) continue;
            std::string guarded(guard.guarded);
            if (const std::size_t at = guarded.find('#'); at != std::string::npos) guarded.replace(at, 1, text);
            text = guarded;
        }
        return "= " + text;
    }

    void library_node(const std::string& id) {
        const NodeInfo* drawn = dice_.pick(library_);
        // A part is used up to sixteen times, and Mesa opens the loops of each: with Worley there (seed 1063) it did
        // not come to an end within a minute.
        while (map_ != "$_Data" && drawn->category == "Procedural/Noise") drawn = dice_.pick(library_);
        const NodeInfo& node = *drawn;
        // Two nodes subtract products, and halves may keep no digit of such a difference: more than their inputs'
        // noise.
        const bool cancels = node.name == "TangentFrame" || node.name == "SHFromZonal";
        const bool in_floats = needs_exact_inputs(node) || cancels, half = choose_half() && !in_floats;
        const int wide = 1 + dice_.below(4);
        std::string ports;
        bool is_first = true;
        for (const PortInfo& port : node.ports) {
            if (port.is_output) continue;
            // The first of the floatN ports is as wide as the node is to be.
            if (port.type == "Gradient" || port.type == "Curve") {
                ports += (ports.empty() ? "" : ", ") + ("\"" + port.name + "\": " + keys(port.type == "Gradient"));
                continue;
            }
            std::string value = port_value(node, port, wide, half);
            if (is_first && port.type == "floatN") {
                Expressions in = inputs_of(node, half);
                Value first = in.leaf(wide);
                const std::string name = node.name + "." + port.name;
                const bool guarded =
                    std::any_of(std::begin(kGuards), std::end(kGuards), [&](const Guard& g) { return g.port == name; });
                value = guarded ? "= " + type_name(wide) + "(" + value.substr(2) + ")" : "= " + first.text;
                is_first = false;
            }
            ports += (ports.empty() ? "" : ", ") + ("\"" + port.name + "\": \"" + value + "\"");
        }
        json_ += R"({ "id": ")" + id + R"(", "node": ")" + node.name + R"(", "in": { )" + ports + " }" +
                 (in_floats ? R"(, "precision": "float")" : precision(half)) + " }";
        for (const PortInfo& port : node.ports) {
            if (!port.is_output) continue;
            const int width = port.type == "bool"     ? 0
                              : port.type == "float"  ? 1
                              : port.type == "floatN" ? wide
                                                      : port.type.back() - '0';
            const bool is_primary = port.name == "out";
            std::string read = is_primary ? id : id + "." + port.name;
            if (is_matrix(port)) read = "mul(" + read + ", " + over_values(half).leaf(width).text + ")";
            if (width == 0) {
                values_.push_back({read, 0, 1});
            } else {
                // What it computed is off like any other value; and how large it is, nobody knows.
                Expressions in(dice_, half);
                const Error error = is_coarse(node) ? kCoarse : kNode;
                values_.push_back(in.limited({in.mark(error, read), width, 1e9}));
            }
        }
    }

    // Its branches and loops ask its inputs. Mesa walks a condition of uniforms alone along every way through what they
    // share, which may take it hours (seed 223: the count of a loop). A texel, which never says yes, ends the walk at
    // once.
    void file_node(const std::string& id) {
        const bool half = choose_half();
        const std::string name = "Generated_" + id, file = name + ".node.hlsl";
        files_[file] = NodeFile(dice_, half).text(name);
        Expressions in = over_values(half);
        const Value p = in.limited(in.expression(3, 1)), q = in.limited(in.expression(1, 1));
        const std::string never = "= t0.x > 99 ";
        json_ += R"({ "id": ")" + id + R"(", "node": "./)" + file + R"(", "in": { "p": ")" + never + "? 0 : " + p.text +
                 R"(", "q": ")" + never + "? 0 : " + q.text + R"(", "flag": ")" + never + "|| " +
                 in.expression(0, 1).text + "\" }" + precision(half) + " }";
        values_.push_back({id, 3, kLargest});
        values_.push_back({id + ".extra", 1, 4});
    }

    // Sub-graphs, each of which uses the one before it twice, and nodes that use them.
    void parts() {
        const int levels = 1 + dice_.below(3);
        for (int level = 0; level < levels; ++level) part(level);
        const int uses = 2 + dice_.below(3);
        for (int i = 0; i < uses; ++i) {
            const int level = dice_.chance(70) ? levels - 1 : dice_.below(levels);
            use_part("u" + std::to_string(i), level, "$_Data");
            json_ += ",\n";
        }
    }

    static std::string part_file(int level) { return "part" + std::to_string(level) + ".subgraph.json"; }

    // Its nodes are written as those of a graph, over its own inputs, and always in floats.
    void part(int level) {
        const bool half_graph = std::exchange(half_graph_, false), half_nodes = std::exchange(half_nodes_, false);
        std::vector<Value> outside = std::exchange(values_, {{"$p", 3, 4}, {"$q", 1, 4}, {"$flag", 0, 1}});
        std::vector<Value> exact_outside = std::exchange(exact_values_, {{"(@fragCoord.xy * 0.125)", 2, 1}});
        std::string graph = std::exchange(json_, {}), map = std::exchange(map_, "$map");
        json_ = R"({ "patina": 1, "kind": "subgraph", "inputs": [
{ "name": "p", "type": "float3" }, { "name": "q", "type": "float", "default": 0.5 },
{ "name": "flag", "type": "bool", "default": true }, { "name": "map", "type": "texture2d" } ],
"nodes": [
)";
        // A texel that is the same in all uses keeps a sub-graph from being a function.
        json_ +=
            dice_.chance(30)
                ? R"({ "id": "t", "node": "LoadTexture2D", "in": { "texture": "$map", "texel": "= @fragCoord.xy" } })"
                : R"json({ "id": "t", "expr": "float4($p, $q)" })json";
        values_.push_back({"t", 4, 4});
        for (int i = 0; level > 0 && i < 2; ++i) {
            json_ += ",\n";
            use_part("a" + std::to_string(i), level - 1, "$map");
        }
        const int count = 1 + dice_.below(4);
        for (int i = 0; i < count; ++i) {
            json_ += ",\n";
            const std::string id = "e" + std::to_string(i);
            if (dice_.chance(30))
                library_node(id);
            else
                expression_node(id);
        }
        Expressions in = over_values(false);
        const Value color = in.limited(in.expression(3, 2)), amount = in.limited(in.expression(1, 2));
        json_ +=
            "\n],\n\"outputs\": { \"color\": \"= " + color.text + "\", \"amount\": \"= " + amount.text + "\" }\n}\n";
        files_[part_file(level)] = std::exchange(json_, std::move(graph));
        values_ = std::move(outside);
        exact_values_ = std::move(exact_outside);
        map_ = std::move(map);
        half_graph_ = half_graph;
        half_nodes_ = half_nodes;
    }

    // The uses in the graph itself have a texel in their inputs for the same reason as a file's node: each level
    // doubles the ways (seed 875).
    void use_part(const std::string& id, int level, const std::string& map) {
        Expressions in = over_values(false);
        const std::string first = map == "$_Data" ? "\"= t0.x > 99 ? 0 : " : "\"= ";
        std::string inputs = "\"p\": " + first + in.limited(in.expression(3, 1)).text + "\", \"map\": \"" + map + "\"";
        if (dice_.chance(60)) inputs += ", \"q\": " + first + in.limited(in.expression(1, 1)).text + "\"";
        const int flag = dice_.below(4);
        if (flag < 2) inputs += std::string(", \"flag\": ") + (flag == 0 ? "false" : "true");
        if (flag == 2) inputs += ", \"flag\": \"= " + in.expression(0, 1).text + "\"";
        json_ += R"({ "id": ")" + id + R"(", "node": "./)" + part_file(level) + R"(", "in": { )" + inputs + " } }";
        values_.push_back({id + ".color", 3, 4, id});
        values_.push_back({id + ".amount", 1, 4, id});
    }

    bool is_read(const std::string& id) const {
        std::size_t count = 0;
        for (std::size_t at = json_.find(id); at != std::string::npos; at = json_.find(id, at + 1)) {
            const char before = json_[at - 1], after = json_[at + id.size()];
            if (!std::isalnum(before) && before != '_' && !std::isdigit(after)) ++count;
        }
        return count > 1;
    }

    // Whatever nobody has read goes into one of the four channels.
    void finish() {
        Expressions in = over_values(half_graph_);
        std::array<std::string, 4> channels;
        for (std::string& channel : channels) channel = in.expression(1, 1).text;
        int next = 0;
        for (const Value& value : values_) {
            if (value.node.empty() || is_read(value.node)) continue;
            const std::string read = value.width == 0   ? "(" + value.text + " ? 1 : 0)"
                                     : value.width == 1 ? value.text
                                                        : value.text + ".y";
            std::string& channel = channels[static_cast<std::size_t>(next++ % 4)];
            channel = in.mark(kArithmetic, channel + " + " + read);
        }
        json_ += "],\n\"surface\": { \"color\": \"= float3(" + channels[0] + ", " + channels[1] + ", " + channels[2] +
                 ")\", \"alpha\": \"= " + channels[3] + "\" }\n}\n";
    }

    Dice dice_;
    const bool has_parts_;
    bool half_graph_ = false;
    std::vector<const NodeInfo*> library_;
    std::vector<Value> values_;
    std::string map_ = "$_Data";
    std::vector<Value> exact_values_;  // those that no operation made
};

}  // namespace

RandomGraph random_graph(const Compiler& compiler, unsigned seed) {
    Generator generator(compiler, seed);
    generator.make();
    RandomGraph graph;
    graph.uses_half = generator.half_nodes_;
    const auto rendered = [&](Dice* noise, double sign) {
        GraphText text{.json = render(generator.json_, noise, sign), .files = {}};
        for (const auto& [name, file] : generator.files_) text.files[name] = render(file, noise, sign);
        return text;
    };
    graph.exact = rendered(nullptr, 1);
    for (unsigned i = 0; i < kPairs; ++i) {
        // What lies on a jump, such as a whole number before floor(), falls to either side in one of the two.
        for (const double sign : {1.0, -1.0}) {
            Dice noise(seed * 16 + i);
            graph.twins.push_back(rendered(&noise, sign));
        }
    }
    if (!graph.uses_half) return graph;
    // HLSL's half runs as float where the hardware has no other: in floats all of them are witnesses, too.
    std::vector<GraphText> in_floats = graph.twins;
    in_floats.push_back(graph.exact);
    for (GraphText& text : in_floats) {
        for (const std::string word : {R"(, "precision": "half")", R"( "precision": "half",)"}) {
            for (std::size_t at = text.json.find(word); at != std::string::npos; at = text.json.find(word))
                text.json.erase(at, word.size());
        }
        graph.twins.push_back(std::move(text));
    }
    return graph;
}

}  // namespace patina::witness
