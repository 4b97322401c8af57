#include "witness/random_graph.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <random>

#include "witness/bench.h"

namespace patina::witness {
namespace {

constexpr double kLargest = 64;  // nothing is allowed to grow beyond
constexpr int kPairs = 1;        // of twins

// Marks in generated text: what stands between kBegin, with a class, and kEnd is a value that a GPU computes with an
// error of that class. A rendering of the text either drops the marks or puts noise in their place.
constexpr char kBegin = '\1', kEnd = '\2';
// A sum of products may come out as next to zero where it is zero.
enum Error : char { kArithmetic = 'a', kSum = 's', kTranscendental = 't', kHalf = 'h' };

double size_of(char error) {
    // The tolerances of the operations; of halves, two roundings.
    return error == kHalf ? 1e-3 : error == kTranscendental ? 1e-4 : 1e-5;
}

// A generator of its own: the distributions of the standard library differ between machines.
class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
    bool chance(int percent) { return below(100) < percent; }
    // A multiple of 1 / 16.
    double sixteenths(int from, int to) { return (from * 16 + below((to - from) * 16 + 1)) / 16.0; }
    template <class Container>
    auto& pick(Container& from) {
        return from[static_cast<std::size_t>(below(static_cast<int>(std::size(from))))];
    }

private:
    std::mt19937 engine_;
};

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
                const double error =
                    size_of(open.back()) * (50 + noise->below(51)) / 100 * (noise->chance(50) ? sign : -sign);
                text += " * " + literal(1 + error);
                if (open.back() == kSum) text += " + " + literal(error / 10);
            }
            text += ')';
            open.pop_back();
        } else {
            text += marked[i];
        }
    }
    return text;
}

// A value that can be read, with how large it may be.
struct Value {
    std::string text{};
    int width = 1;  // of floats; 0: a bool
    double largest = 1;
    std::string node{};  // whose output it is
};

std::string type_name(int width) {
    return width == 0 ? "bool" : width == 1 ? "float" : "float" + std::to_string(width);
}

constexpr std::string_view kComponents = "xyzw";

// Writes expressions over a list of values.
class Expressions {
public:
    Expressions(Dice& dice, bool half) : dice_(dice), half_(half) {}

    std::vector<Value> values;
    // Values that differ from pixel to pixel. Every condition and every loop's end reads one: lavapipe (Mesa 22.3)
    // takes apart branches that depend on uniforms alone, and crashes over some that are long.
    std::vector<Value> anchors;
    std::vector<std::string> ints;  // int variables and constants that may be read

    Value expression(int width, int depth) {
        if (width == 0) return {.text = condition(depth), .width = 0};
        if (depth <= 0) return leaf(width);
        Value made = dice_.chance(45) ? operation(width, depth) : function(width, depth);
        if (made.largest > kLargest) made = limited(made);
        return made;
    }

    // A bounded one of the same width; NaN stays NaN.
    Value limited(const Value& value) {
        return {.text = mark(kArithmetic, value.text + " / (1 + abs(" + value.text + ") * 0.25)"),
                .width = value.width,
                .largest = 4};
    }

    std::string mark(Error error, const std::string& text) const {
        return std::string{kBegin, half_ ? kHalf : error} + text + kEnd;
    }

    Value leaf(int width) {
        if (dice_.chance(12)) return constant(width);
        // What came last is read most: graphs become deep.
        const int count = static_cast<int>(values.size());
        Value value;
        do {
            const int back = std::min(dice_.below(count), dice_.below(count));
            value = values[static_cast<std::size_t>(count - 1 - back)];
        } while (value.width == 0);
        return {.text = swizzled(value, width), .width = width, .largest = value.largest};
    }

    std::string anchor(int width) { return swizzled(dice_.pick(anchors), width); }

private:
    Value constant(int width) {
        if (width == 1) return {.text = "(" + literal(dice_.sixteenths(-2, 2)) + ")", .largest = 2};
        std::string text = type_name(width) + "(";
        for (int i = 0; i < width; ++i) text += (i ? ", " : "") + literal(dice_.sixteenths(-2, 2));
        return {.text = text + ")", .width = width, .largest = 2};
    }

    std::string swizzled(const Value& value, int width) {
        if (value.width == width && (width == 1 || dice_.chance(60))) return value.text;
        if (value.width == 1) return type_name(width) + "(" + value.text + ")";
        std::string text = value.text + ".";
        for (int i = 0; i < width; ++i) text += kComponents[static_cast<std::size_t>(dice_.below(value.width))];
        return text;
    }

    std::string condition(int depth) {
        if (depth > 0 && dice_.chance(25)) {
            const std::string left = condition(depth - 1);
            if (dice_.chance(25)) return "(!" + left + ")";
            return "(" + left + (dice_.chance(50) ? " && " : " || ") + condition(depth - 1) + ")";
        }
        std::vector<Value> bools;
        std::copy_if(values.begin(), values.end(), std::back_inserter(bools),
                     [](const Value& v) { return v.width == 0; });
        if (!bools.empty() && dice_.chance(25)) return dice_.pick(bools).text;
        if (dice_.chance(20)) {
            const int width = 2 + dice_.below(3);
            return std::string(dice_.chance(50) ? "any(" : "all(") + comparison(width, depth) + ")";
        }
        return comparison(1, depth);
    }

    std::string comparison(int width, int depth) {
        static constexpr const char* kSigns[] = {" < ", " <= ", " > ", " >= ", " == ", " != "};
        // Equality of what was computed is luck: rarely.
        const char* sign = kSigns[dice_.below(dice_.chance(90) ? 4 : 6)];
        return "(" + expression(width, depth - 1).text + sign + leaf(width).text + ")";
    }

    Value operation(int width, int depth) {
        const Value left = expression(width, depth - 1);
        if (width > 1 && dice_.chance(10)) return constructed(width, depth);
        const bool scalar_right = width > 1 && dice_.chance(25);
        const Value right = expression(scalar_right ? 1 : width, depth - 1);
        const auto both = [&](const char* sign) { return left.text + sign + right.text; };
        switch (dice_.below(8)) {
            case 0:
            case 1: return {mark(kArithmetic, both(" + ")), width, left.largest + right.largest};
            case 2: return {mark(kArithmetic, both(" - ")), width, left.largest + right.largest};
            case 3:
            case 4: return {mark(kArithmetic, both(" * ")), width, left.largest * right.largest};
            case 5:
                return {mark(kArithmetic, left.text + " / (abs(" + right.text + ") + 0.5)"), width, left.largest * 2};
            case 6: return {"(-" + left.text + ")", width, left.largest};
            default: {
                const std::string test =
                    width > 1 && dice_.chance(30) ? comparison(width, depth - 1) : condition(depth - 1);
                const Value other = expression(width, depth - 1);
                return {"(" + test + " ? " + left.text + " : " + other.text + ")", width,
                        std::max(left.largest, other.largest)};
            }
        }
    }

    Value constructed(int width, int depth) {
        const int first = 1 + dice_.below(width - 1);
        const Value a = expression(first, depth - 1), b = expression(width - first, depth - 1);
        return {type_name(width) + "(" + a.text + ", " + b.text + ")", width, std::max(a.largest, b.largest)};
    }

    Value integer(int width, int depth) {
        static constexpr const char* kSigns[] = {" + ", " - ", " * ", " & ", " | ", " ^ "};
        std::string whole = "int(floor(" + expression(1, depth - 1).text + "))";
        if (!ints.empty() && dice_.chance(60)) whole = dice_.pick(ints);
        const std::string text = "float(((" + whole + kSigns[dice_.below(6)] + std::to_string(1 + dice_.below(7)) +
                                 ") & 15) << " + std::to_string(dice_.below(2)) + ")";
        return {width == 1 ? text : type_name(width) + "(" + text + ")", width, 30};
    }

    Value matrix(int width, int depth) {
        std::string rows;
        double largest = 0;
        for (int i = 0; i < width; ++i) {
            const Value row = leaf(width);
            rows += (i ? ", " : "") + row.text;
            largest = std::max(largest, row.largest);
        }
        const std::string size = std::to_string(width);
        std::string m = "float" + size + "x" + size + "(" + rows + ")";
        if (dice_.chance(30)) m = "transpose(" + m + ")";
        const Value v = expression(width, depth - 1);
        const std::string product = dice_.chance(50) ? m + ", " + v.text : v.text + ", " + m;
        return {mark(kSum, "mul(" + product + ")"), width, largest * v.largest * width};
    }

    Value function(int width, int depth) {
        const Value x = expression(width, depth - 1);
        const auto of = [&](const char* name) { return std::string(name) + "(" + x.text + ")"; };
        const auto other = [&] { return expression(width, depth - 1); };
        switch (dice_.below(30)) {
            case 0: return {of("abs"), width, x.largest};
            case 1: return {of("floor"), width, x.largest + 1};
            case 2: return {of("ceil"), width, x.largest + 1};
            case 3: return {of("round"), width, x.largest + 1};
            case 4: return {of("frac"), width, 1};
            case 5: return {of("saturate"), width, 1};
            case 6: return {of("sign"), width, 1};
            case 7: return {mark(kTranscendental, of("sin")), width, 1};
            case 8: return {mark(kTranscendental, of("cos")), width, 1};
            case 9: return {mark(kTranscendental, of("atan")), width, 1.6};
            case 10: return {mark(kTranscendental, of("tanh")), width, 1};
            case 11: return {mark(kArithmetic, "sqrt(abs(" + x.text + "))"), width, std::max(1.0, x.largest)};
            case 12: return {mark(kArithmetic, "rsqrt(abs(" + x.text + ") + 0.25)"), width, 2};
            case 13: return {mark(kTranscendental, "exp2(clamp(" + x.text + ", -4, 4))"), width, 16};
            case 14: return {mark(kTranscendental, "log2(abs(" + x.text + ") + 0.5)"), width, 7};
            case 15: return {mark(kTranscendental, "pow(abs(" + x.text + ") + 0.25, 1.5)"), width, x.largest * 9 + 1};
            case 16: {
                const Value y = other();
                return {"min(" + x.text + ", " + y.text + ")", width, std::max(x.largest, y.largest)};
            }
            case 17: {
                const Value y = other();
                return {"max(" + x.text + ", " + y.text + ")", width, std::max(x.largest, y.largest)};
            }
            case 18: {
                const Value y = other();
                const std::string t = dice_.chance(50) ? "saturate(" + leaf(1).text + ")" : "0.25";
                return {mark(kArithmetic, "lerp(" + x.text + ", " + y.text + ", " + t + ")"), width,
                        std::max(x.largest, y.largest)};
            }
            case 19: return {"clamp(" + x.text + ", -1, 2)", width, 2};
            case 20: return {mark(kArithmetic, "smoothstep(-0.5, 1.5, " + x.text + ")"), width, 1};
            case 21: return {"step(" + leaf(width).text + ", " + x.text + ")", width, 1};
            case 22: {
                const int inner = 2 + dice_.below(3);
                const Value a = expression(inner, depth - 1), b = expression(inner, depth - 1);
                return splat(mark(kSum, "dot(" + a.text + ", " + b.text + ")"), width, a.largest * b.largest * inner);
            }
            case 23: {
                const Value a = expression(2 + dice_.below(3), depth - 1);
                return splat(mark(kArithmetic, "length(" + a.text + ")"), width, a.largest * 2);
            }
            case 24:
                if (width == 1) return {mark(kTranscendental, "atan2(" + x.text + ", 1.5)"), 1, 1.6};
                return {mark(kArithmetic, "normalize(abs(" + x.text + ") + 0.125)"), width, 1};
            case 25:
                if (width != 3) return integer(width, depth);
                return {mark(kSum, "cross(" + x.text + ", " + leaf(3).text + ")"), 3, x.largest * kLargest};
            case 26:
                if (width != 3) return {"trunc(" + x.text + ")", width, x.largest};
                return {mark(kSum, "reflect(" + x.text + ", normalize(abs(" + leaf(3).text + ") + 0.125))"), 3,
                        x.largest * 2};
            case 27: return integer(width, depth);
            case 28:
                if (width == 1) return {mark(kArithmetic, "fmod(" + x.text + ", 1.75)"), 1, 1.75};
                return matrix(width, depth);
            default: return {mark(kArithmetic, x.text + " % 2.5"), width, 2.5};
        }
    }

    static Value splat(const std::string& scalar, int width, double largest) {
        return {width == 1 ? scalar : type_name(width) + "(" + scalar + ")", width, largest};
    }

    Dice& dice_;
    bool half_;
};

// --- a node file: one function with branches, loops, arrays and a second output

class NodeFile {
public:
    NodeFile(Dice& dice, bool half) : dice_(dice), in_(dice, half) {}

    std::string text(const std::string& name) {
        in_.values = {{"p", 3, 4}, {"q", 1, 4}, {"flag", 0, 1}};
        in_.anchors = {in_.values[0], in_.values[1]};
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

// Ports whose values must stay away from where the node has no answer, or where it is far too sensitive.
struct Guard {
    std::string_view port, guarded;  // "Node.port"; # stands for the value
};
constexpr Guard kGuards[] = {
    {"Divide.right", "(abs(#) + 0.5)"},
    {"Reciprocal.value", "(abs(#) + 0.5)"},
    {"Modulo.divisor", "(abs(#) + 0.5)"},
    {"Log2.value", "(abs(#) + 0.5)"},
    {"Power.base", "(abs(#) + 0.25)"},
    {"Power.exponent", "clamp(#, -2, 2)"},
    {"Exponential.exponent", "clamp(#, -4, 4)"},
    {"Tangent.angle", "clamp(#, -1, 1)"},
    {"InverseLerp.to", "(abs(#) + 5)"},
    {"InverseLerp.from", "clamp(#, -4, 4)"},
    {"Remap.in_min", "clamp(#, -4, 4)"},
    {"Remap.in_max", "(abs(#) + 5)"},
    {"Smoothstep.edge0", "clamp(#, -4, 4)"},
    {"Smoothstep.edge1", "(abs(#) + 5)"},
    {"Normalize.value", "(abs(#) + 0.125)"},
    // The angle of no direction at all is whatever a machine likes.
    {"ArcTangent2.run", "(abs(#) + 0.5)"},
    {"PolarCoordinates.uv", "(abs(#) + 5)"},
    {"PolarCoordinates.center", "clamp(#, -4, 4)"},
    {"Bricks.count", "(abs(#) + 0.5)"},
    {"Bricks.bevel", "0.02"},
    {"Flipbook.columns", "4"},
    {"Flipbook.rows", "2"},
    {"FractalNoise.gain", "0.5"},
    {"FractalNoise.lacunarity", "2"},
    {"DistributionBlinnPhong.exponent", "(abs(#) + 1)"},
};

class Generator {
public:
    Generator(const Compiler& compiler, unsigned seed) : dice_(seed) {
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
            json_ += load_node(id, "@frag_coord.x", "@frag_coord.y + " + std::to_string(i * kSide));
            json_ += ",\n";
            values_.push_back({id, 4, 2});
        }
        values_.insert(values_.end(), {{"$_Amount", 1, 1}, {"$_Axis", 3, 2}, {"@time", 1, 1}});
        values_.push_back({"(@frag_coord.xy * 0.125)", 2, 1});
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
        // A hash: its result has nothing to do with how near two inputs are.
        if (node.name == "Random") return false;
        // lavapipe (Mesa 22.3) crashes over some branches that depend on the nine constants of the ambient light.
        if (node.category == "Lighting/Ambient" && node.ports.size() <= 3) return false;
        return std::all_of(node.ports.begin(), node.ports.end(), [&](const PortInfo& port) {
            // Light is known to lighting graphs only, and textures are not numbers.
            return port.type != "Texture2D" && (port.is_output || !port.type.starts_with("Sampler"));
        });
    }

    bool choose_half() { return half_nodes_ && (half_graph_ || dice_.chance(30)); }
    std::string precision(bool half) const { return half && !half_graph_ ? R"(, "precision": "half")" : ""; }
    // Noise of a value in a node: a half's where the node computes in halves.
    Expressions over_values(bool half) {
        Expressions made(dice_, half);
        made.values = values_;
        made.anchors.assign(values_.begin(), values_.begin() + kLayers);
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

    // A graph whose outputs are swizzled by nobody: what stands in a port is an expression.
    std::string port_value(const NodeInfo& node, const PortInfo& port, int wide, bool half) {
        if (!port.enumerators.empty()) return dice_.pick(port.enumerators);
        if (port.type == "int") return "= " + std::to_string(1 + dice_.below(3));
        Expressions in = over_values(half);
        if (port.type == "bool") return "= " + in.expression(0, 1).text;
        const int width = port.type == "floatN"  ? (dice_.chance(25) ? 1 : wide)
                          : port.type == "float" ? 1
                                                 : port.type.back() - '0';
        std::string text = in.expression(width, dice_.below(2)).text;
        if (port.range) {
            // Most ranges are 0 to 1. Beyond its range a node promises nothing.
            const auto [low, high] = *port.range;
            text = "clamp(" + text + ", " + literal(std::max(low, -8.0)) + ", " + literal(std::min(high, 8.0)) + ")";
        }
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
        const NodeInfo& node = *dice_.pick(library_);
        const bool half = choose_half();
        const int wide = 1 + dice_.below(4);
        std::string ports;
        bool is_first = true;
        for (const PortInfo& port : node.ports) {
            if (port.is_output) continue;
            // The first of the floatN ports is as wide as the node is to be.
            std::string value = port_value(node, port, wide, half);
            if (is_first && port.type == "floatN") {
                Expressions in = over_values(half);
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
                 precision(half) + " }";
        for (const PortInfo& port : node.ports) {
            if (!port.is_output) continue;
            const int width = port.type == "bool"     ? 0
                              : port.type == "float"  ? 1
                              : port.type == "floatN" ? wide
                                                      : port.type.back() - '0';
            const bool is_primary = port.name == "out";
            const std::string read = is_primary ? id : id + "." + port.name;
            if (width == 0) {
                values_.push_back({read, 0, 1});
            } else {
                // What it computed is off like any other value; and how large it is, nobody knows.
                Expressions in(dice_, half);
                values_.push_back(in.limited({in.mark(kTranscendental, read), width, 1e9}));
            }
        }
    }

    void file_node(const std::string& id) {
        const bool half = choose_half();
        const std::string name = "Generated_" + id, file = name + ".node.hlsl";
        files_[file] = NodeFile(dice_, half).text(name);
        Expressions in = over_values(half);
        const auto varying = [&](int width) {
            return in.limited(
                {in.mark(kArithmetic, in.expression(width, 1).text + " + " + in.anchor(width)), width, 1});
        };
        const Value p = varying(3), q = varying(1);
        json_ += R"({ "id": ")" + id + R"(", "node": "./)" + file + R"(", "in": { "p": "= )" + p.text +
                 R"(", "q": "= )" + q.text + R"(", "flag": "= )" + in.expression(0, 1).text + "\" }" + precision(half) +
                 " }";
        values_.push_back({id, 3, kLargest});
        values_.push_back({id + ".extra", 1, 4});
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
    bool half_graph_ = false;
    std::vector<const NodeInfo*> library_;
    std::vector<Value> values_;
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
    if (graph.uses_half) {
        // HLSL's half runs as float where the hardware has no other.
        graph.twins.push_back(graph.exact);
        std::string& json = graph.twins.back().json;
        for (const std::string word : {R"(, "precision": "half")", R"( "precision": "half",)"})
            for (std::size_t at = json.find(word); at != std::string::npos; at = json.find(word))
                json.erase(at, word.size());
    }
    return graph;
}

}  // namespace patina::witness
