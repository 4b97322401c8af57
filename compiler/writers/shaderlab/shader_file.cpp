#include "compiler/writers/shaderlab/shader_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/format/words.h"
#include "compiler/writers/shaderlab/dialect.h"

namespace patina::writers::shaderlab {
namespace {

using Declaration = PassText::Declaration;
using Kind = languages::Piece::Kind;

struct SurfaceRow {
    SurfaceKind kind;
    std::string_view render_type;
};
constexpr SurfaceRow kSurfaces[] = {
    {SurfaceKind::Opaque, "Opaque"},        {SurfaceKind::Cutout, "TransparentCutout"},
    {SurfaceKind::Fade, "Transparent"},     {SurfaceKind::Transparent, "Transparent"},
    {SurfaceKind::Additive, "Transparent"}, {SurfaceKind::Multiply, "Transparent"},
};

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

    languages::Printed take() { return {.text = std::move(text_), .lines = std::move(lines_)}; }

private:
    std::string text_;
    std::vector<languages::PrintedLine> lines_;
    int next_ = 1;
};

std::vector<std::string_view> texts_at(const PassText& pass, std::string_view place) {
    std::vector<std::string_view> lines;
    for (const ir::StageText& text : pass.texts) {
        if (text.place == place) lines.push_back(text.line);
    }
    return lines;
}

// Unity draws a pass without a mode, too, but batches it with others, and sets no values of lights for it.
constexpr std::string_view kLitMode = "ForwardBase";

// The shader model that a pass needs, together with the declarations that all passes begin with.
std::string_view shader_model(const LinkedPass& linked, std::span<const PassText> passes, const PassText& pass,
                              std::span<const Declaration* const> shared) {
    // 3.0 has 10 interpolators, 3.5 those of OpenGL ES 3.0 and Direct3D 10; 5.0 is the highest that is needed here.
    const Varyings vectors = varyings_of(linked);
    if (vectors.numbered + vectors.others > 15) return "5.0";
    if (vectors.numbered > 10) return "3.5";
    const auto is_modern = [&](const std::string& name) {
        const bool is_shared =
            std::any_of(shared.begin(), shared.end(), [&](const auto* d) { return d->name == name; });
        const auto& own = pass.declarations;
        return is_shared || std::any_of(own.begin(), own.end(), [&](const auto& d) { return d.name == name; });
    };
    bool needs_more = pass.is_modern;
    for (const PassText& each : passes)
        needs_more |= std::any_of(each.modern_functions.begin(), each.modern_functions.end(), is_modern);
    return needs_more ? "3.5" : "3.0";
}

class Writing {
public:
    explicit Writing(const ShaderFile& file) : in_(file) {
        passes_ = pass_texts(file.passes, file.engine);
        shared_ = shared_declarations(passes_);
    }

    languages::Printed run() {
        for (const std::string_view line : split(in_.header, "\n")) out_.line(0, fmt::format("// {}", line));
        out_.line(0, fmt::format("Shader \"{}\"", in_.listed_as));
        out_.line(0, "{");
        out_.line(1, "Properties");
        out_.line(1, "{");
        for (const std::string& line : shader_properties(in_.material, in_.lowered)) out_.line(2, line);
        for (const std::string& line : state_properties(in_.reflection, in_.passes)) out_.line(2, line);
        out_.line(1, "}");
        out_.line(0, "");
        common();
        out_.line(1, "SubShader");
        out_.line(1, "{");
        tags();
        for (std::size_t i = 0; i < passes_.size(); ++i) pass(i);
        out_.line(1, "}");
        out_.line(1, fmt::format("FallBack {}", fallback()));
        out_.line(0, "}");
        return out_.take();
    }

private:
    // True if a pass reads values that Unity sets only for passes with the mode.
    bool is_lit() const {
        return std::any_of(passes_.begin(), passes_.end(),
                           [](const PassText& pass) { return !texts_at(pass, "light mode").empty(); });
    }

    std::string_view fallback() const { return fallback_word(in_.material, in_.lowered, in_.passes); }

    const SurfaceRow& surface() const {
        const SurfaceKind kind = in_.material.graph->graph->render.surface;
        return *std::find_if(std::begin(kSurfaces), std::end(kSurfaces),
                             [&](const SurfaceRow& row) { return row.kind == kind; });
    }

    // --- the text that all passes begin with

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
        // Macros that declare something stand before it.
        std::string uniforms;
        for (const Declaration* each : shared_) {
            if (each->kind == Kind::Uniform) uniforms += each->text;
        }
        const std::vector<std::string_view> first = needed_pieces_of(in_.engine.include, uniforms);
        write_pieces(first);
        const auto needed_pieces = [&] {
            std::vector<std::string_view> pieces = needed_pieces_of(in_.engine.include, text);
            std::erase_if(pieces, [&](std::string_view piece) {
                return std::find(first.begin(), first.end(), piece) != first.end();
            });
            write_pieces(pieces);
        };
        const std::string_view condition = vertex_condition(passes_);
        Kind before = Kind::Uniform;
        bool is_first = true, is_open = false;
        for (const Declaration* each : shared_) {
            if (each->kind != Kind::Uniform && before == Kind::Uniform) {
                if (!is_first) out_.line(0, "");
                needed_pieces();
            }
            if (each->is_of_vertex && !condition.empty() && !is_open) {
                out_.line(1, fmt::format("#if {}", condition));
                is_open = true;
            }
            out_.declaration(1, *each);
            if (is_open && each == shared_.back()) out_.line(1, "#endif");
            if (each->kind != Kind::Uniform) out_.line(0, "");
            before = each->kind;
            is_first = false;
        }
        if (before == Kind::Uniform) {
            gap_after(!is_first);
            needed_pieces();
        }
        out_.line(1, "ENDCG");
        out_.line(0, "");
    }

    void write_pieces(std::span<const std::string_view> pieces) {
        for (const std::string_view piece : pieces) {
            for (const std::string_view line : split(piece, "\n")) out_.line(1, line);
            out_.line(0, "");
        }
    }

    void gap_after(bool wanted) {
        if (wanted) out_.line(0, "");
    }

    // --- the shader and its passes

    void tags() {
        std::string tags = fmt::format("\"RenderType\" = \"{}\" \"Queue\" = \"{}\"", surface().render_type,
                                       queue_word(shader_queue(in_.material, in_.passes)));
        if (surface().render_type == "Transparent") tags += " \"IgnoreProjector\" = \"True\"";
        // Batching would break passes that use the object's own space.
        const bool moves = std::any_of(in_.passes.begin(), in_.passes.end(), [](const LinkedPass& pass) {
            return !pass.material->graph->graph->vertex.empty();
        });
        if (moves || std::any_of(in_.passes.begin(), in_.passes.end(), knows_object))
            tags += " \"DisableBatching\" = \"True\"";
        out_.line(2, fmt::format("Tags {{ {} }}", tags));
        // As Unity's Standard and Unlit shaders. What has no shader to fall back to would vanish under a low
        // Shader.maximumLOD.
        out_.line(2, is_lit() && fallback() != "Off" ? "LOD 300" : "LOD 100");
        std::vector<std::string_view> lines;
        for (const PassText& pass : passes_) {
            for (const std::string_view line : texts_at(pass, "grab")) {
                if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
            }
        }
        for (const std::string_view line : lines) out_.line(2, fmt::format("GrabPass {{ \"{}\" }}", line));
    }

    void pass(std::size_t index) {
        const paths::PassDecl& declared = *in_.passes[index].pass->declaration;
        const PassText& text = passes_[index];
        out_.line(0, "");
        out_.line(2, "Pass");
        out_.line(2, "{");
        out_.line(3, fmt::format("Name \"{}\"", name_of(in_.passes[index])));
        std::string tags;
        for (const auto& [name, value] : declared.tags) {
            if (name == "LightMode" && value == kLitMode && !is_lit()) continue;
            if (name != "Name") tags += fmt::format("\"{}\" = \"{}\" ", name, value);
        }
        if (!tags.empty()) out_.line(3, fmt::format("Tags {{ {}}}", tags));
        for (const std::string& line : shader_state(in_.reflection.passes[index], in_.passes[index]))
            out_.line(3, line);
        out_.line(0, "");
        out_.line(3, "CGPROGRAM");
        out_.line(3, fmt::format("#pragma target {}", shader_model(in_.passes[index], passes_, text, shared_)));
        for (const std::string_view line : texts_at(text, "pragma")) out_.line(3, fmt::format("#pragma {}", line));
        keywords(in_.reflection.passes[index]);
        out_.line(3, "#pragma vertex vert");
        out_.line(3, "#pragma fragment frag");
        for (const std::string_view line : texts_at(text, "own include"))
            out_.line(3, fmt::format("#include \"{}\"", line));
        for (const Declaration& each : text.declarations) {
            if (!each.is_own) continue;
            out_.line(0, "");
            out_.declaration(3, each);
        }
        out_.line(3, "ENDCG");
        out_.line(2, "}");
    }

    // One program for each value; a build leaves out those that no material uses.
    void keywords(const Pass& pass) {
        for (const std::string& name : pass.keywords) {
            const auto property = std::find_if(in_.reflection.properties.begin(), in_.reflection.properties.end(),
                                               [&](const Property& p) { return p.name == name; });
            std::string words;
            for (const std::string& value : property->values)
                words += " " + writers::shaderlab::keyword_of(name, value);
            if (words.empty()) words = " " + writers::shaderlab::keyword_of(name, {});
            out_.line(3, "#pragma shader_feature_local" + words);
        }
    }

    const ShaderFile& in_;
    std::vector<PassText> passes_;
    std::vector<const Declaration*> shared_;
    File out_;
};

}  // namespace

languages::Printed shader_file(const ShaderFile& file) {
    return Writing(file).run();
}

}  // namespace patina::writers::shaderlab
