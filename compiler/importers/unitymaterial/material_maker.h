// Makes a graph of Patina from a material of Unity. Whatever is read of the material is noted with what became of it;
// finish() reports the rest as not read.
//
//   render_state.cpp  how the surface is drawn: blending, faces, depth, the queue
//   lit.cpp           Standard and Lit of the universal pipeline
//   high_definition.cpp  Lit of the high definition pipeline
//   simple.cpp        Simple Lit, Baked Lit and the Unlit shaders
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "compiler/importers/imported_graph.h"
#include "compiler/importers/importer.h"
#include "compiler/importers/patterns.h"
#include "compiler/importers/unity/pictures.h"
#include "compiler/importers/unitymaterial/material_file.h"
#include "compiler/importers/unitymaterial/shaders.h"

namespace patina::importers::unitymaterial {

using namespace terms;

// As a picker shows it: "#ff8000", or linear numbers if it has not eight bits a channel, or `is_hdr`.
GraphValue shown_color(const std::array<double, 4>& color, bool is_hdr);
// As Unity decodes a colour that is not HDR, in a project of linear colour space.
double decoded(double channel);

struct RenderState {
    std::string kind = "opaque";
    bool is_clipped = false;          // alpha is compared with _Cutoff
    bool is_weighted = false;         // additive, and alpha weights what is added
    bool is_alpha_modulated = false;  // multiplied, and alpha fades the colour to white

    bool is_blended() const { return kind != "opaque" && kind != "cutout"; }
    bool reads_alpha() const { return kind != "opaque" || is_clipped; }
    // What alpha does to a colour, if the surface is additive or multiplies.
    Term weighted(const Term& color, const Term& alpha) const;
};

class MaterialMaker {
public:
    MaterialMaker(const MaterialFile& source, const Shader& shader, Pictures& pictures, const std::string& name);

    ImportedGraph graph;

    // --- what the material says
    const MaterialFile& source() const { return source_; }
    const Shader& shader() const { return shader_; }
    // Whether the keyword is on, and what it does. Of a shader that is guessed, a texture stands for its keyword.
    bool keyword(const std::string& name, const std::string& what_it_does, const std::string& texture = {});
    bool has_picture(const std::string& texture) const;  // it is assigned, whether or not its file is there
    const Picture& picture(const std::string& texture) {
        const AssetId& id = source_.textures.at(texture).picture;
        return pictures_.find(id.guid, id.file);
    }
    double number(const std::string& property, double otherwise) const;
    std::array<double, 4> color(const std::string& property, std::array<double, 4> otherwise) const;

    // --- what becomes of it: noted once, the first time
    void note(const std::string& property, Remark::Kind kind, const std::string& text);
    void taken(const std::string& property, const std::string& text) { note(property, Remark::Kind::Taken, text); }
    // Those that the material has: they have no effect, because of this.
    void idle(std::initializer_list<const char*> properties, const std::string& why);
    void note_keyword(const std::string& name, Remark::Kind kind, const std::string& text);
    // The same of one that was noted already.
    void change_keyword(const std::string& name, const std::string& text);
    void note_setting(const std::string& key, Remark::Kind kind, const std::string& text);

    // --- parts of the graph. Each gives what an expression reads.
    Term number_property(const std::string& name, double otherwise, double low, double high);
    // As a picker shows it.
    Term color_property(const std::string& name, std::array<double, 4> otherwise);
    // Of light: linear. `difference`: from what Unity makes of it.
    Term light_property(const std::string& name, std::array<double, 4> color, const std::string& difference);
    // Texture coordinates with the tiling of the texture; `base` itself if that changes nothing.
    Term tiled(const std::string& texture, const Term& base, const std::string& id);
    // A node that reads the texture. `usage`: that of a picture without import settings.
    Term sample(const std::string& texture, const std::string& id, std::string_view usage, std::string_view fallback,
                const Term& uv, const Term& scale = number_term(1));
    void node(ImportedNode made) { graph.nodes.push_back(std::move(made)); }
    void set(const std::string& input, const Term& term) { graph.surface.push_back({input, term.value()}); }

    // "$_Color.rgb", "main.rgb" or their product; a white colour with a texture is left out.
    Term tinted(const Term& sample, const std::string& color, std::array<double, 4> otherwise);
    // The same of alpha.
    Term alpha(const Term& sample, const std::string& color, std::array<double, 4> otherwise);
    // Emission, if its keyword is on. `is_hdr`: the colour is linear.
    void emission(const Term& uv, bool is_hdr);
    // The alpha of the surface, and where it is cut off.
    void coverage(const RenderState& state, const Term& alpha, const std::string& limit = "_Cutoff");

    // Reports all that the material has.
    std::vector<Remark> finish();

private:
    struct Outcome {
        Remark::Kind kind = Remark::Kind::Taken;
        std::string text{};
    };
    Term add_color(const std::string& name, std::array<double, 4> color, bool is_linear, const std::string& remark);
    void report_settings(std::vector<Remark>& remarks);

    const MaterialFile& source_;
    const Shader& shader_;
    Pictures& pictures_;
    bool all_repeat_ = true;         // the assigned pictures
    std::set<std::string> tiled_{};  // textures whose tiling is read
    std::map<std::string, Outcome> properties_{}, keywords_{}, settings_{};
};

// Blending, faces, depth and the queue become the graph's "render".
RenderState make_render_state(MaterialMaker& maker);
void make_lit(MaterialMaker& maker, const RenderState& state);
void make_high_definition(MaterialMaker& maker, const RenderState& state);
void make_simple_lit(MaterialMaker& maker, const RenderState& state);
void make_baked_lit(MaterialMaker& maker, const RenderState& state);
void make_unlit(MaterialMaker& maker, const RenderState& state);

}  // namespace patina::importers::unitymaterial
