#include "compiler/assemble/shader_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "compiler/base/text.h"
#include "compiler/graph/words.h"
#include "compiler/targets/shaderlab/shaderlab.h"

namespace patina::assemble {
namespace {

using Declaration = PassText::Declaration;
using Kind = targets::Piece::Kind;

// --- what the surface kind means to Unity

struct SurfaceRow {
    graph::SurfaceKind kind;
    std::string_view render_type, fallback;
};
// A fallback brings the passes that the shader has not got itself: shadows of what is solid, and none of the others.
constexpr SurfaceRow kSurfaces[] = {
    {graph::SurfaceKind::Opaque, "Opaque", "\"VertexLit\""},
    {graph::SurfaceKind::Cutout, "TransparentCutout", "\"Legacy Shaders/Transparent/Cutout/VertexLit\""},
    {graph::SurfaceKind::Fade, "Transparent", "Off"},
    {graph::SurfaceKind::Transparent, "Transparent", "Off"},
    {graph::SurfaceKind::Additive, "Transparent", "Off"},
    {graph::SurfaceKind::Multiply, "Transparent", "Off"},
};

struct QueueRow {
    std::string_view name;
    int queue;
};
constexpr QueueRow kQueues[] = {
    {"Background", 1000}, {"Geometry", 2000}, {"AlphaTest", 2450}, {"Transparent", 3000}, {"Overlay", 4000}};

std::string queue_word(int queue) {
    const QueueRow* nearest = &kQueues[0];
    for (const QueueRow& row : kQueues) {
        if (std::abs(row.queue - queue) < std::abs(nearest->queue - queue)) nearest = &row;
    }
    return queue == nearest->queue ? std::string(nearest->name)
                                   : fmt::format("{}{:+}", nearest->name, queue - nearest->queue);
}

// "one_minus_src_alpha" -> "OneMinusSrcAlpha", "lessEqual" -> "LessEqual"
std::string in_capitals(std::string_view word) {
    std::string made;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (word[i] == '_') continue;
        const bool begins = i == 0 || word[i - 1] == '_';
        made += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(word[i]))) : word[i];
    }
    return made;
}

std::string compare_word(std::string_view word) {
    const std::string made = in_capitals(word);
    if (made == "LessEqual") return "LEqual";
    return made == "GreaterEqual" ? "GEqual" : made;
}

// Unity's IncrSat stops at 255, IncrWrap goes on at 0.
std::string operation_word(std::string_view word) {
    constexpr std::pair<std::string_view, std::string_view> kWords[] = {{"increment", "IncrSat"},
                                                                        {"decrement", "DecrSat"},
                                                                        {"incrementWrap", "IncrWrap"},
                                                                        {"decrementWrap", "DecrWrap"}};
    for (const auto& [ours, unitys] : kWords) {
        if (word == ours) return std::string(unitys);
    }
    return in_capitals(word);
}

// --- the text, line by line

class File {
public:
    void line(unsigned indent, std::string_view content, ir::OriginId origin = {}) {
        if (lines_.empty() ? static_cast<bool>(origin) : lines_.back().origin != origin)
            lines_.push_back({.line = next_, .origin = origin});
        if (!content.empty()) text_.append(4 * indent, ' ').append(content);
        text_ += '\n';
        ++next_;
    }

    void declaration(unsigned indent, const Declaration& each) {
        auto origin = each.lines.begin();
        ir::OriginId now{};
        int at = 0;
        for (std::string_view rest = each.text; !rest.empty(); ++at) {
            const std::size_t end = rest.find('\n');
            while (origin != each.lines.end() && origin->line <= at) now = (origin++)->origin;
            line(indent, rest.substr(0, end), now);
            rest.remove_prefix(std::min(end, rest.size() - 1) + 1);
        }
    }

    targets::Printed take() { return {.text = std::move(text_), .lines = std::move(lines_)}; }

private:
    std::string text_;
    std::vector<targets::PrintedLine> lines_;
    int next_ = 1;
};

std::vector<std::string_view> split(std::string_view text, std::string_view at) {
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(at), text.size());
        if (end > 0) parts.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + at.size(), text.size()));
    }
    return parts;
}

// --- the text that the shader may need a part of

// What a piece of it defines: the words before the first '(' of lines that stand at the margin.
std::vector<std::string_view> names_of(std::string_view piece) {
    std::vector<std::string_view> names;
    for (const std::string_view line : split(piece, "\n")) {
        const std::size_t open = line.find('(');
        const bool is_macro = line.starts_with("#define ");
        const bool is_call = line.ends_with(';');  // of a macro that declares something
        if (open == line.npos || is_call || line.starts_with("//") || line.starts_with(" ") ||
            (line.starts_with("#") && !is_macro))
            continue;
        const std::string_view before = line.substr(0, open);
        names.push_back(before.substr(before.rfind(' ') + 1));
    }
    return names;
}

// The pieces that the text comes to mention, in their order.
std::vector<std::string_view> needed(std::string_view include, const std::string& text) {
    const std::vector<std::string_view> pieces = split(include, "\n\n");
    std::vector<bool> is_needed(pieces.size());
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (is_needed[i]) continue;
            for (const std::string_view name : names_of(pieces[i])) {
                bool is_read = mentions(text, name);
                for (std::size_t k = 0; k < pieces.size(); ++k)
                    is_read = is_read || (is_needed[k] && mentions(pieces[k], name));
                if (!is_read || is_needed[i]) continue;
                is_needed[i] = grows = true;
            }
        }
    }
    std::vector<std::string_view> made;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (is_needed[i]) made.push_back(pieces[i]);
    }
    return made;
}

// --- what the passes share

// What a pass's own entry functions take and give is its own, too.
bool is_own(const PassText& pass, const Declaration& each) {
    if (each.kind == Kind::Entry) return true;
    const std::string& fragment = pass.declarations.back().text;
    return each.kind == Kind::Struct && mentions(fragment.substr(0, fragment.find('\n')), each.name);
}

// By name, the text that the most passes have; of a pass's own things nothing.
std::map<std::string_view, const Declaration*> most_common(const std::vector<PassText>& passes) {
    std::map<std::string_view, std::map<std::string_view, int>> counts;
    std::map<std::string_view, const Declaration*> made;
    for (const PassText& pass : passes) {
        for (const Declaration& each : pass.declarations) {
            if (is_own(pass, each)) continue;
            const int count = ++counts[each.name][each.text];
            const Declaration*& best = made[each.name];
            if (!best || count > counts[each.name][best->text]) best = &each;
        }
    }
    return made;
}

// The passes, in which a name means the same wherever it is not the pass's own.
std::vector<PassText> pass_texts(std::span<const LinkedPass> linked) {
    std::vector<PassText> passes;
    std::vector<std::vector<std::string>> taken(linked.size());
    for (std::size_t i = 0; i < linked.size(); ++i) passes.push_back(pass_text(linked[i], {}));
    for (bool differ = true; differ;) {
        differ = false;
        const auto common = most_common(passes);
        for (std::size_t i = 0; i < linked.size(); ++i) {
            const std::size_t before = taken[i].size();
            for (const Declaration& each : passes[i].declarations) {
                if (!is_own(passes[i], each) && common.at(each.name)->text != each.text) taken[i].push_back(each.name);
            }
            differ = differ || taken[i].size() > before;
        }
        for (std::size_t i = 0; differ && i < linked.size(); ++i) passes[i] = pass_text(linked[i], taken[i]);
    }
    return passes;
}

// What is not a pass's own, each once, in an order in which everything stands behind what it reads.
std::vector<const Declaration*> shared(const std::vector<PassText>& passes) {
    std::vector<const Declaration*> made;
    for (const PassText& pass : passes) {
        for (const Declaration& each : pass.declarations) {
            const auto is_same = [&](const Declaration* other) { return other->name == each.name; };
            if (!is_own(pass, each) && std::none_of(made.begin(), made.end(), is_same)) made.push_back(&each);
        }
    }
    std::stable_sort(made.begin(), made.end(),
                     [](const Declaration* a, const Declaration* b) { return a->kind < b->kind; });
    return made;
}

std::vector<std::string_view> texts_at(const PassText& pass, std::string_view place) {
    std::vector<std::string_view> lines;
    for (const ir::StageText& text : pass.texts) {
        if (text.place == place) lines.push_back(text.line);
    }
    return lines;
}

int number(std::string_view digits) {
    int value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

// What only newer hardware has.
std::string_view shader_model(const PassText& pass) {
    std::string text;
    for (const Declaration& each : pass.declarations) text += each.text;
    for (const int count : {16, 15, 14, 13, 12, 11}) {
        if (mentions(text, fmt::format("TEXCOORD{}", count))) return "4.0";
    }
    constexpr std::string_view kModern[] = {".SampleLevel(",   ".SampleGrad(", ".SampleBias(", ".Load(",
                                            ".GetDimensions(", "uint",         "asuint",       "SV_IsFrontFace"};
    const bool is_modern = std::any_of(std::begin(kModern), std::end(kModern),
                                       [&](std::string_view word) { return text.find(word) != text.npos; });
    return is_modern || mentions(text, "TEXCOORD10") ? "3.5" : "3.0";
}

class Writing {
public:
    explicit Writing(const ShaderFile& file) : in_(file) {
        passes_ = pass_texts(file.passes);
        shared_ = shared(passes_);
    }

    targets::Printed run() {
        for (const std::string_view line : split(in_.header, "\n")) out_.line(0, fmt::format("// {}", line));
        out_.line(0, fmt::format("Shader \"Patina/{}\"", name()));
        out_.line(0, "{");
        out_.line(1, "Properties");
        out_.line(1, "{");
        for (const std::string& line : shader_properties(in_.material, in_.lowered, in_.reflection)) out_.line(2, line);
        out_.line(1, "}");
        out_.line(0, "");
        common();
        out_.line(1, "SubShader");
        out_.line(1, "{");
        tags();
        for (std::size_t i = 0; i < passes_.size(); ++i) pass(i);
        out_.line(1, "}");
        out_.line(1, fmt::format("FallBack {}", surface().fallback));
        out_.line(0, "}");
        return out_.take();
    }

private:
    // Slashes would make menus of it.
    std::string name() const {
        std::string made = in_.reflection.name;
        for (char& c : made) {
            if (c == '"' || c == '\\' || static_cast<unsigned char>(c) < 0x20) c = ' ';
        }
        return made;
    }

    const SurfaceRow& surface() const {
        const graph::SurfaceKind kind = in_.material.graph->graph->render.surface;
        return *std::find_if(std::begin(kSurfaces), std::end(kSurfaces),
                             [&](const SurfaceRow& row) { return row.kind == kind; });
    }

    // --- what all passes begin with

    void common() {
        std::vector<std::string_view> includes;
        std::string text;
        for (const PassText& pass : passes_) {
            for (const std::string_view line : texts_at(pass, "include")) {
                if (std::find(includes.begin(), includes.end(), line) == includes.end()) includes.push_back(line);
            }
            for (const Declaration& each : pass.declarations) text += each.text;
        }
        std::sort(includes.begin(), includes.end(), [](std::string_view a, std::string_view b) {
            return std::pair(a.size(), a) < std::pair(b.size(), b);
        });
        out_.line(1, "CGINCLUDE");
        for (const std::string_view file : includes) out_.line(1, fmt::format("#include \"{}\"", file));
        gap_after(!includes.empty());
        Kind before = Kind::Uniform;
        bool is_first = true;
        for (const Declaration* each : shared_) {
            if (each->kind != Kind::Uniform && before == Kind::Uniform) {
                if (!is_first) out_.line(0, "");
                needed_pieces(text);
            }
            out_.declaration(1, *each);
            if (each->kind != Kind::Uniform) out_.line(0, "");
            before = each->kind;
            is_first = false;
        }
        if (before == Kind::Uniform) {
            gap_after(!is_first);
            needed_pieces(text);
        }
        out_.line(1, "ENDCG");
        out_.line(0, "");
    }

    void needed_pieces(const std::string& text) {
        for (const std::string_view piece : needed(in_.include, text)) {
            for (const std::string_view line : split(piece, "\n")) out_.line(1, line);
            out_.line(0, "");
        }
    }

    void gap_after(bool wanted) {
        if (wanted) out_.line(0, "");
    }

    // --- the shader and its passes

    void tags() {
        int queue = in_.reflection.passes.empty() ? 2000 : in_.reflection.passes.front().queue;
        for (const PassText& pass : passes_) {
            for (const std::string_view least : texts_at(pass, "queue")) queue = std::max(queue, number(least));
        }
        std::string tags =
            fmt::format("\"RenderType\" = \"{}\" \"Queue\" = \"{}\"", surface().render_type, queue_word(queue));
        if (surface().render_type == "Transparent") tags += " \"IgnoreProjector\" = \"True\"";
        // What is moved in the space of the object must not be batched into another one.
        if (in_.reflection.moves_vertices) tags += " \"DisableBatching\" = \"True\"";
        out_.line(2, fmt::format("Tags {{ {} }}", tags));
        out_.line(2, "LOD 300");
        std::vector<std::string_view> lines;
        for (const PassText& pass : passes_) {
            for (const std::string_view line : texts_at(pass, "grab")) {
                if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
            }
        }
        for (const std::string_view line : lines) out_.line(2, fmt::format("GrabPass {{ \"{}\" }}", line));
    }

    void pass(std::size_t index) {
        const graph::PassDecl& declared = *in_.passes[index].pass->declaration;
        const PassText& text = passes_[index];
        out_.line(0, "");
        out_.line(2, "Pass");
        out_.line(2, "{");
        std::string tags;
        for (const auto& [name, value] : declared.tags) {
            if (name == "Name") {
                const std::string& own = in_.passes[index].pass->name;  // one that the material adds has its own
                out_.line(3, fmt::format("Name \"{}\"", own == declared.name ? value : std::string_view(own)));
            } else {
                tags += fmt::format("\"{}\" = \"{}\" ", name, value);
            }
        }
        if (!tags.empty()) out_.line(3, fmt::format("Tags {{ {}}}", tags));
        state(in_.reflection.passes[index]);
        out_.line(0, "");
        out_.line(3, "CGPROGRAM");
        out_.line(3, fmt::format("#pragma target {}", shader_model(text)));
        for (const std::string_view line : texts_at(text, "pragma")) out_.line(3, fmt::format("#pragma {}", line));
        keywords(in_.reflection.passes[index]);
        out_.line(3, "#pragma vertex vert");
        out_.line(3, "#pragma fragment frag");
        for (const Declaration& each : text.declarations) {
            if (!is_own(text, each)) continue;
            out_.line(0, "");
            out_.declaration(3, each);
        }
        out_.line(3, "ENDCG");
        out_.line(2, "}");
    }

    // A program for each value; a build leaves out those that no material has.
    void keywords(const Pass& pass) {
        for (const std::string& name : pass.keywords) {
            const auto property = std::find_if(in_.reflection.properties.begin(), in_.reflection.properties.end(),
                                               [&](const Property& p) { return p.name == name; });
            std::string words;
            for (const std::string& value : property->values)
                words += " " + targets::shaderlab::keyword_of(name, value);
            if (words.empty()) words = " " + targets::shaderlab::keyword_of(name, {});
            out_.line(3, "#pragma shader_feature_local" + words);
        }
    }

    // What ShaderLab does not take for granted.
    void state(const Pass& pass) {
        if (pass.cull != "back") out_.line(3, fmt::format("Cull {}", in_capitals(pass.cull)));
        if (!pass.depth_write) out_.line(3, "ZWrite Off");
        if (pass.depth_test != "lessEqual") out_.line(3, fmt::format("ZTest {}", compare_word(pass.depth_test)));
        if (pass.depth_bias != 0 || pass.depth_slope_bias != 0)
            out_.line(3, fmt::format("Offset {}, {}", shortest(pass.depth_slope_bias), shortest(pass.depth_bias)));
        if (pass.stencil.is_used()) stencil(pass.stencil);
        const Blend blend = pass.targets.empty() ? Blend{} : pass.targets.front().blend;
        if (blend == Blend{}) return;
        std::string factors = fmt::format("{} {}", in_capitals(blend.source), in_capitals(blend.destination));
        if (blend.source_alpha != blend.source || blend.destination_alpha != blend.destination)
            factors += fmt::format(", {} {}", in_capitals(blend.source_alpha), in_capitals(blend.destination_alpha));
        out_.line(3, "Blend " + factors);
    }

    void stencil(const Stencil& stencil) {
        std::string made = fmt::format("Ref {} Comp {}", stencil.value, compare_word(stencil.test));
        if (stencil.read_mask != 255) made += fmt::format(" ReadMask {}", stencil.read_mask);
        if (stencil.write_mask != 255) made += fmt::format(" WriteMask {}", stencil.write_mask);
        for (const auto& [word, operation] : {std::pair("Pass", stencil.pass), std::pair("Fail", stencil.fail),
                                              std::pair("ZFail", stencil.depth_fail)}) {
            if (operation != "keep") made += fmt::format(" {} {}", word, operation_word(operation));
        }
        out_.line(3, fmt::format("Stencil {{ {} }}", made));
    }

    const ShaderFile& in_;
    std::vector<PassText> passes_;
    std::vector<const Declaration*> shared_;
    File out_;
};

}  // namespace

targets::Printed shader_file(const ShaderFile& file) {
    return Writing(file).run();
}

}  // namespace patina::assemble
