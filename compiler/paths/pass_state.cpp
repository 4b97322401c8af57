// Reads the attributes that say how a pass draws. Checks their words, and stores their values in the reflection's
// types.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "compiler/base/text.h"
#include "compiler/format/words.h"
#include "compiler/paths/reading.h"

namespace patina::paths {
namespace {

using nodelang::Attribute;
using nodelang::Expr;
using Words = std::span<const std::string_view>;

constexpr std::size_t kMostTargets = 8;  // the limit of Vulkan and Direct3D 12

constexpr std::array<std::string_view, 2> kDepthWrites = {"write", "keep"};
constexpr std::array kPassStencilOps = {StencilOp::Keep, StencilOp::Replace};
constexpr std::array kColorFormats = {TargetFormat::Rgba8, TargetFormat::Rgb10A2, TargetFormat::Rgba16F,
                                      TargetFormat::Rgba32F, TargetFormat::R32F};
constexpr std::array<std::string_view, 4> kTargetTypes = {"float", "float2", "float3", "float4"};

// Takes the arguments of one attribute, in order, and reports errors at the argument.
class Arguments {
public:
    Arguments(const Attribute& attribute, Diagnostics& diagnostics)
        : attribute_(attribute), diagnostics_(diagnostics) {}

    bool count(std::size_t least, std::size_t most, std::string_view example) {
        if (attribute_.args.size() >= least && attribute_.args.size() <= most) return true;
        diagnostics_.report(Code::BadAttribute, attribute_.span, attribute_.name,
                            fmt::format("is written like this: {}", example));
        return false;
    }

    // A name in quotes.
    std::string_view text() {
        const Expr& given = *attribute_.args[next_++];
        if (given.kind != Expr::Kind::File || given.text.empty())
            diagnostics_.report(Code::BadAttribute, given.span, attribute_.name, "takes a name in quotes here");
        return given.text;
    }

    std::string_view word(Words words, std::string_view what) {
        const Expr& given = *attribute_.args[next_++];
        if (given.kind != Expr::Kind::File) {
            diagnostics_.report(Code::BadAttribute, given.span, attribute_.name, "takes words in quotes here");
        } else if (std::find(words.begin(), words.end(), given.text) != words.end()) {
            return given.text;
        } else {
            diagnostics_.report(Code::UnknownWord, given.span, given.text, what)
                .note(Diagnostics::suggestion(given.text, words));
        }
        return words.front();
    }

    // The value of a word; after an error, the first value of the enum.
    template <HasWords E>
    E word(std::string_view what) {
        constexpr auto kTexts = format::texts<E>();
        return *from_word<E>(word(kTexts, what));
    }
    // The same, for an enum of which only some values are allowed.
    template <HasWords E, std::size_t N>
    E word(const std::array<E, N>& values, std::string_view what) {
        std::array<std::string_view, N> known;
        std::transform(values.begin(), values.end(), known.begin(), [](E value) { return to_string(value); });
        return *from_word<E>(word(known, what));
    }

    double number() {
        const Expr& given = *attribute_.args[next_++];
        const bool is_negative = given.kind == Expr::Kind::Unary && given.text == "-";
        const Expr& digits = is_negative ? *given.args[0] : given;
        if (digits.kind != Expr::Kind::Number)
            diagnostics_.report(Code::BadAttribute, given.span, attribute_.name, "takes numbers here");
        else if (std::abs(digits.number) > std::numeric_limits<float>::max())
            diagnostics_.report(Code::BadNumber, given.span, shortest(digits.number), "float");
        return is_negative ? -digits.number : digits.number;
    }

private:
    const Attribute& attribute_;
    Diagnostics& diagnostics_;
    std::size_t next_ = 0;
};

void read_blend(Arguments& in, std::size_t count, PassDecl& pass) {
    BlendRow row{};
    if (count % 2 == 1) row.surface = in.word<SurfaceKind>("a surface kind");
    row.blend.source = row.blend.source_alpha = in.word<BlendFactor>("a blend factor");
    row.blend.destination = row.blend.destination_alpha = in.word<BlendFactor>("a blend factor");
    if (count > 3) {
        row.blend.source_alpha = in.word<BlendFactor>("a blend factor");
        row.blend.destination_alpha = in.word<BlendFactor>("a blend factor");
    }
    pass.blends.push_back(row);
}

void read_depth(Arguments& in, PassDecl& pass) {
    pass.has_depth = true;
    pass.state.depth_test = in.word<Compare>("a depth test");
    pass.state.depth_write = in.word(kDepthWrites, "a depth write mode") == "write";
}

void read_stencil(Arguments& in, std::size_t count, PassDecl& pass) {
    pass.has_stencil = true;
    pass.state.stencil.test = in.word<Compare>("a stencil test");
    pass.state.stencil.pass = in.word(kPassStencilOps, "a stencil operation");
    if (count > 2) pass.state.stencil.reference = in.word<StencilReference>("a stencil reference");
}

// The places of an engine's file where a pass can insert lines.
// "sampler" and "light mode" add no line: they name a sampler, and a mode of the pass, that the others need.
constexpr std::array<std::string_view, 15> kPlaces = {
    "grab",           "queue",        "pragma",          "include",
    "own include",    "sampler",      "light mode",      "first interpolator",
    "interpolators",  "vertex begin", "vertex end",      "vertex result",
    "fragment begin", "fragment end", "vertex condition"};

void read_tag(Arguments& in, PassDecl& pass) {
    const std::string_view name = in.text();
    pass.tags.emplace_back(name, in.text());
}

struct StateRow {
    std::string_view name;
    std::size_t least, most;
    std::string_view example;
    void (*read)(Arguments&, std::size_t count, PassDecl&);
};
constexpr StateRow kState[] = {
    {"draws", 1, 1, "[draws(\"objects\")]",
     [](Arguments& in, std::size_t, PassDecl& p) {
         p.state.draws = in.word<PassDraws>("something that a pass can draw");
     }},
    {"each", 1, 1, "[each(\"light\")]",
     [](Arguments& in, std::size_t, PassDecl& p) { p.state.each = in.word<PassEach>("a way to repeat a pass"); }},
    {"lights", 1, 1, "[lights(\"all\")]",
     [](Arguments& in, std::size_t, PassDecl& p) { p.state.lights = in.word<PassLights>("a set of lights"); }},
    {"camera", 1, 1, "[camera(\"perspective\")]",
     [](Arguments& in, std::size_t, PassDecl& p) { p.state.camera = in.word<PassCamera>("a camera"); }},
    {"fallback", 1, 1, "[fallback(\"forward\")]",
     [](Arguments& in, std::size_t, PassDecl& p) { p.state.fallback = in.text(); }},
    {"cull", 1, 1, "[cull(\"front\")]",
     [](Arguments& in, std::size_t, PassDecl& p) {
         p.has_cull = true;
         p.state.cull = in.word<Cull>("a cull mode");
     }},
    {"blend", 2, 5, "[blend(\"fade\", \"srcAlpha\", \"one\")] or, for every surface, [blend(\"one\", \"one\")]",
     read_blend},
    {"depth", 2, 2, "[depth(\"lessEqual\", \"keep\")]",
     [](Arguments& in, std::size_t, PassDecl& p) { read_depth(in, p); }},
    {"depthTarget", 1, 1, "[depthTarget(\"depth\")]",
     [](Arguments& in, std::size_t, PassDecl& p) { p.state.depth_target = in.text(); }},
    {"depthBias", 2, 2, "[depthBias(1, 1.5)]",
     [](Arguments& in, std::size_t, PassDecl& p) {
         p.has_depth_bias = true;
         p.state.depth_bias = in.number();
         p.state.depth_slope_bias = in.number();
     }},
    {"stencil", 2, 3, "[stencil(\"always\", \"replace\", \"lighting\")]",
     [](Arguments& in, std::size_t count, PassDecl& p) { read_stencil(in, count, p); }},
    {"tag", 2, 2, "[tag(\"LightMode\", \"Always\")]", [](Arguments& in, std::size_t, PassDecl& p) { read_tag(in, p); }},
    {"optional", 0, 0, "[optional]", [](Arguments&, std::size_t, PassDecl& p) { p.is_optional = true; }},
    {"alone", 0, 0, "[alone]", [](Arguments&, std::size_t, PassDecl& p) { p.is_alone = true; }},
    {"otherwise", 1, 1, "[otherwise(\"it casts no shadow\")]",
     [](Arguments& in, std::size_t, PassDecl& p) { p.otherwise = in.text(); }},
    {"extra", 0, 32, "[extra]",
     [](Arguments& in, std::size_t count, PassDecl& p) {
         p.draws_extra = true;
         for (std::size_t i = 0; i < count; ++i) p.extra_along.push_back(in.text());
     }},
};

// Reports a type that a shader cannot write to a render target.
void check_type(const nodelang::TypeName& type, std::string_view what, Diagnostics& diagnostics) {
    const bool fits = std::find(kTargetTypes.begin(), kTargetTypes.end(), type.name) != kTargetTypes.end();
    if (!fits || type.array_size)
        diagnostics.report(Code::TypeMismatch, type.span, what, type.array_size ? "an array" : type.name,
                           "float, float2, float3 or float4");
}

void read_target(const Attribute& attribute, PassDecl& pass, Diagnostics& diagnostics) {
    Arguments in(attribute, diagnostics);
    if (!in.count(2, 2, "[target(\"color\", \"rgba16f\")]")) return;
    RenderTarget& target = pass.state.targets.back();
    const std::string name(in.text());
    target.format = in.word(kColorFormats, "a target format");
    const auto is_same = [&](const RenderTarget& other) { return other.name == name; };
    if (!name.empty() && std::any_of(pass.state.targets.begin(), pass.state.targets.end(), is_same))
        diagnostics.report(Code::BadAttribute, attribute.span, "target",
                           fmt::format("names '{}', which the pass already writes", name));
    target.name = name;
}

void read_members(const nodelang::FunctionDecl& fragment, const nodelang::StructDecl& structure, PassDecl& pass,
                  Diagnostics& diagnostics) {
    const auto has_target = [](const nodelang::MemberDecl& member) { return member.attribute("target") != nullptr; };
    if (std::none_of(structure.members.begin(), structure.members.end(), has_target)) {
        diagnostics
            .report(Code::BadAttribute, fragment.result.span, "target",
                    fmt::format("is missing on the members of '{}', which the pass returns", structure.name))
            .note("write [target(\"color\", \"rgba16f\")] before each member");
        return;
    }
    bool is_after_optional = false;
    for (const nodelang::MemberDecl& member : structure.members) {
        if (is_after_optional && !member.attribute("optional"))
            diagnostics.report(Code::BadAttribute, member.span, "optional",
                               fmt::format("is missing on '{}', which follows an optional target", member.name));
        is_after_optional |= member.attribute("optional") != nullptr;
        if (is_after_optional) ++pass.optional_targets;
        RenderTarget& target = pass.state.targets.emplace_back();
        target.location = static_cast<std::uint32_t>(pass.state.targets.size() - 1);
        const Attribute* guard = member.attribute("onlyIf");
        pass.guards.push_back(guard ? nodelang::attribute_text(*guard) : std::string_view());
        if (const Attribute* attribute = member.attribute("target")) {
            read_target(*attribute, pass, diagnostics);
            check_type(member.type, fmt::format("the target '{}'", member.name), diagnostics);
        } else {
            diagnostics.report(Code::BadAttribute, member.span, "target",
                               fmt::format("is missing on '{}': [target(\"color\", \"rgba16f\")]", member.name));
        }
    }
}

// A pass returns one colour, a struct of them, or nothing.
void read_targets(const nodelang::FunctionDecl& fragment, const nodelang::Declarations& declarations, PassDecl& pass,
                  Diagnostics& diagnostics) {
    if (fragment.result.name == "void") return;
    const nodelang::StructDecl* structure = declarations.structure(fragment.result.name);
    if (structure && !fragment.result.array_size) {
        read_members(fragment, *structure, pass, diagnostics);
    } else {
        check_type(fragment.result, "the result of a [fragment] function", diagnostics);
        pass.state.targets = {{.name = {}, .location = 0}};
        if (const Attribute* attribute = fragment.attribute("target")) read_target(*attribute, pass, diagnostics);
        if (pass.state.targets.front().name.empty()) pass.state.targets.front().name = "color";
    }
    if (pass.state.targets.size() > kMostTargets)
        diagnostics.report(Code::TooMany, fragment.name_span, pass.state.targets.size(), "targets", kMostTargets);
}

// Reports an attribute that stands twice. [blend] may stand once for each kind of surface.
void check_twice(const nodelang::FunctionDecl& fragment, Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < fragment.attributes.size(); ++i) {
        const Attribute& now = fragment.attributes[i];
        if (now.name == "pass" || now.name == "gives" || now.name == "tag" || now.name == "text" || now.name == "lacks")
            continue;
        const auto is_same = [&](const Attribute& before) {
            if (before.name != now.name) return false;
            return now.name != "blend" || before.args.size() == 2 || now.args.size() == 2 ||
                   nodelang::attribute_text(before) == nodelang::attribute_text(now);
        };
        const auto end = fragment.attributes.begin() + static_cast<std::ptrdiff_t>(i);
        const auto first = std::find_if(fragment.attributes.begin(), end, is_same);
        if (first != end)
            diagnostics.report(Code::BadAttribute, now.span, now.name, "is given twice")
                .note(first->span, "the first one is here");
    }
}

}  // namespace

std::vector<ir::StageText> texts_of(std::span<const Attribute> attributes, Diagnostics& diagnostics) {
    std::vector<ir::StageText> texts;
    for (const Attribute& attribute : attributes) {
        if (attribute.name != "text") continue;
        Arguments in(attribute, diagnostics);
        if (!in.count(2, 32, "[text(\"pragma\", \"target 3.5\")]")) continue;
        const std::string place(in.word(kPlaces, "a position of a pass's text"));
        for (std::size_t i = 1; i < attribute.args.size(); ++i)
            texts.push_back({.place = place, .line = std::string(in.text())});
    }
    return texts;
}

void read_pass_state(const nodelang::FunctionDecl& fragment, const nodelang::Declarations& declarations, PassDecl& pass,
                     Diagnostics& diagnostics) {
    for (const Attribute& attribute : fragment.attributes) {
        if (attribute.name == "along") pass.along = attribute_words(attribute);
        if (attribute.name == "needs") pass.needs = attribute_words(attribute);
        if (attribute.name == "holds") pass.holds = attribute_words(attribute);
        if (attribute.name == "excludes") pass.excludes = attribute_words(attribute);
        if (attribute.name == "lacks") pass.lacks.push_back(attribute_words(attribute));
        if (attribute.name == "lighting") pass.lighting = attribute_words(attribute);
        const auto row = std::find_if(std::begin(kState), std::end(kState),
                                      [&](const StateRow& r) { return r.name == attribute.name; });
        if (row == std::end(kState)) continue;
        Arguments in(attribute, diagnostics);
        if (in.count(row->least, row->most, row->example)) row->read(in, attribute.args.size(), pass);
    }
    check_twice(fragment, diagnostics);
    read_targets(fragment, declarations, pass, diagnostics);
}

}  // namespace patina::paths
