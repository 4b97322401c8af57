#include "compiler/writers/shaderlab/dialect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "compiler/base/spelling.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/languages/body.h"
#include "compiler/languages/hlsl/hlsl.h"
#include "compiler/languages/legalize.h"

namespace patina::writers::shaderlab {

using namespace ir;
using namespace languages;

namespace {

// --- expressions

// Numbers that UnityCG.cginc names.
struct Named {
    float number;
    std::string_view name;
};
constexpr Named kNumbers[] = {{3.14159265359f, "UNITY_PI"},         {6.28318530718f, "UNITY_TWO_PI"},
                              {12.56637061436f, "UNITY_FOUR_PI"},   {0.31830988618f, "UNITY_INV_PI"},
                              {0.15915494309f, "UNITY_INV_TWO_PI"}, {0.07957747155f, "UNITY_INV_FOUR_PI"}};

std::string_view name_of_number(float number) {
    const auto* const found = std::find_if(std::begin(kNumbers), std::end(kNumbers),
                                           [&](const Named& each) { return each.number == number; });
    return found == std::end(kNumbers) ? std::string_view() : found->name;
}

constexpr std::string_view kSampler = "sampler";

// "_MainTex" of the sampler "sampler_MainTex"
std::string_view texture_of(std::string_view sampler) {
    return sampler.starts_with(kSampler) ? sampler.substr(kSampler.size()) : sampler;
}

std::string decoded(std::string_view decoder, std::string text) {
    return decoder.empty() ? text : fmt::format("{}({})", decoder, text);
}

// The macro that reads a texture. Its name gets "_SAMPLER" if the sampler belongs to another texture. In 2017, Unity
// has no macros for explicit levels, biases and gradients, so the file declares them.
struct Reading {
    Op op;
    std::string_view prefix, suffix;
};
constexpr Reading kReadings[] = {{Op::Sample, "UNITY_", ""},
                                 {Op::SampleBias, "", "_BIAS"},
                                 {Op::SampleLevel, "", "_LOD"},
                                 {Op::SampleGrad, "", "_GRAD"}};

// Unity's macros for a kind of texture have this in their names.
std::string_view macro_of(Kind kind) {
    if (kind == Kind::TextureCube) return "TEXCUBE";
    if (kind == Kind::Texture2DArray) return "TEX2DARRAY";
    return kind == Kind::Texture3D ? "TEX3D" : "TEX2D";
}

// Of other kinds than 2D, Unity has macros for plain samples and for levels with the texture's own sampler; where these
// exist, so do methods.
std::string read_layers(const Body& body, Value v, const Reading& reading) {
    const std::string_view macro = macro_of(body[body.arg(v, 0)].type.kind);
    const bool is_own = texture_of(body.argument(v, 1)) == body.argument(v, 0);
    if (is_own && (reading.op == Op::Sample || reading.op == Op::SampleLevel))
        return fmt::format("UNITY_SAMPLE_{}{}({}, {})", macro, reading.suffix, body.argument(v, 0),
                           body.arguments(v, 2));
    return hlsl::language().expression(body, v).text;
}

std::string read_texture(const Body& body, Value v, const Reading& reading) {
    if (body[body.arg(v, 0)].type.kind != Kind::Texture2D) return read_layers(body, v, reading);
    const std::string name = body.argument(v, 0), sampler = body.argument(v, 1);
    const std::string_view own = texture_of(sampler);
    if (own == name)
        return fmt::format("{}SAMPLE_TEX2D{}({}, {})", reading.prefix, reading.suffix, name, body.arguments(v, 2));
    return fmt::format("{}SAMPLE_TEX2D_SAMPLER{}({}, {}, {})", reading.prefix, reading.suffix, name, own,
                       body.arguments(v, 2));
}

Text expression(const Body& body, Value v) {
    const Value texture = body.arg(v, 0);
    const std::string_view decoder =
        body[texture].op == Op::Global ? std::string_view(body.module().globals[body[texture].data].decoder) : "";
    const auto* const reading = std::find_if(std::begin(kReadings), std::end(kReadings),
                                             [&](const Reading& each) { return each.op == body[v].op; });
    std::string text =
        reading == std::end(kReadings) ? hlsl::language().expression(body, v).text : read_texture(body, v, *reading);
    return {decoded(decoder, std::move(text)), Precedence::Postfix};
}

constexpr std::string_view kInstances = "Instances";  // the buffer of the values that each instance has

// Unity stores a material's whole numbers in floats, and its vectors in four floats.
std::string read(const Writer& w, GlobalId id, std::string_view name) {
    const Global& global = w.module.globals[id.index];
    const BlockMember& member = w.module.blocks[global.block].members[global.member];
    const std::string_view stored = member.stored_as;
    const std::string text = decoded(
        global.decoder, member.is_of_instance ? fmt::format("UNITY_ACCESS_INSTANCED_PROP({}, {})", kInstances, name)
                                              : std::string(name));
    if (stored == "float" && global.type.is_integer()) return fmt::format("{}({})", w.type(global.type), text);
    if (stored == "float4" && global.type.is_vector() && global.type.width() < 4)
        return fmt::format("{}.{}", text, std::string_view("xyz").substr(0, global.type.width()));
    return text;
}

// --- declarations

std::string keyword_test(const Keyword& keyword, std::optional<std::size_t> value) {
    return fmt::format("defined({})",
                       value ? keyword_of(keyword.property, keyword.values[*value]) : keyword_of(keyword.property, {}));
}

void block(Writer& w, const UniformBlock& block) {
    const auto index = static_cast<std::size_t>(&block - w.module.blocks.data());
    const auto declarations = [&](bool of_instance, auto write) {
        for (std::size_t i = 0; i < block.members.size(); ++i) {
            const BlockMember& member = block.members[i];
            if (member.is_of_instance == of_instance && member.declared_in.empty())
                write(member, w.block_members[index][i]);
        }
    };
    declarations(false, [&](const BlockMember& member, const std::string& name) {
        w.line(0, member.stored_as.empty() ? w.declaration(member.type, name) + ";"
                                           : fmt::format("{} {};", member.stored_as, name));
    });
    bool is_open = false;
    declarations(true, [&](const BlockMember& member, const std::string& name) {
        if (!is_open) w.line(0, fmt::format("UNITY_INSTANCING_BUFFER_START({})", kInstances));
        is_open = true;
        const std::string type = member.stored_as.empty() ? w.type(member.type) : member.stored_as;
        w.line(1, fmt::format("UNITY_DEFINE_INSTANCED_PROP({}, {})", type, name));
    });
    if (is_open) w.line(0, fmt::format("UNITY_INSTANCING_BUFFER_END({})", kInstances));
}

bool is_texture_named(const Module& module, std::string_view name) {
    return std::any_of(module.globals.begin(), module.globals.end(),
                       [&](const Global& each) { return each.type.is_texture() && each.name == name; });
}

// One macro declares a texture and its sampler. Its size is a variable that Unity fills. Unity makes other samplers by
// their names.
void resource(Writer& w, GlobalId id) {
    const Global& global = w.module.globals[id.index];
    if (global.type.is_numeric()) w.line(0, w.declaration(global.type, w.globals[id.index]) + ";");
    if (global.type.kind == Kind::Sampler && !is_texture_named(w.module, texture_of(global.name)))
        w.line(0, fmt::format("DECLARE_SAMPLER({})", texture_of(w.globals[id.index])));
    if (global.type.is_texture()) {
        const bool is_flat = global.type.kind == Kind::Texture2D;
        const std::string_view form = is_flat && has_no_sampler(w.module, id.index) ? "_NOSAMPLER" : "";
        w.line(0, fmt::format("UNITY_DECLARE_{}{}({});", macro_of(global.type.kind), form, w.globals[id.index]));
    }
}

// Declares a constant with the keyword's value, for code that reads it as a value.
void keyword(Writer& w, GlobalId id) {
    const Global& global = w.module.globals[id.index];
    const Keyword& keyword = w.module.keywords[global.keyword];
    const std::string constant = "static const " + w.declaration(global.type, w.globals[id.index]) + " = ";
    if (keyword.values.empty()) {
        w.line(0, "#if " + keyword_test(keyword, {}));
        w.line(0, constant + "true;");
        w.line(0, "#else");
        w.line(0, constant + "false;");
    }
    // If none is defined, the first value applies, as in Unity.
    const std::size_t count = keyword.values.size();
    for (std::size_t i = 1; i <= count && count > 1; ++i) {
        w.line(0, i == count ? "#else" : (i == 1 ? "#if " : "#elif ") + keyword_test(keyword, i));
        w.line(0, constant + std::to_string(i % count) + ";");
    }
    if (count == 1) w.line(0, constant + "0;");
    if (count != 1) w.line(0, "#endif");
}

std::vector<std::string> lines_at(const StageInterface& stage, std::string_view place) {
    std::vector<std::string> lines;
    for (const StageText& text : stage.texts) {
        if (text.place == place) lines.push_back(text.line);
    }
    return lines;
}

// Names of a struct's members, distinct from those that Unity's macros declare.
class MemberNames {
public:
    explicit MemberNames(const TakenNames* taken) : names_(taken, Names::Of::Members) {
        for (const char* name :
             {"pos", "vec", "hpos", "fogCoord", "instanceID", "stereoTargetEyeIndex", "_ShadowCoord", "_LightCoord"})
            names_.declare(name);
    }
    std::string declare(std::string_view name) { return names_.declare(name); }

private:
    Names names_;
};

// The coordinates of the macros are numbered after those of the values.
std::string numbered(std::string line, std::uint32_t& next) {
    for (std::size_t at = line.find("{}"); at != line.npos; at = line.find("{}", at))
        line.replace(at, 2, std::to_string(next++));
    return line;
}

void declare_varyings(Writer& w, std::span<const std::string> members) {
    const StageInterface& stage = w.module.stage;
    const std::vector<std::string> first = lines_at(stage, "first interpolator");
    w.gap();
    const std::size_t begin = w.text.size();
    const int line = w.next_line;
    w.line(0, "struct v2f");
    w.line(0, "{");
    for (const std::string& each : first) w.line(1, each);
    auto next = static_cast<std::uint32_t>(first.size());
    for (const StageVariable& v : stage.outputs) {
        if (v.builtin == Builtin::Position) w.line(1, "float4 pos : SV_POSITION;");
    }
    for (std::size_t i = 0; i < stage.outputs.size(); ++i) {
        const StageVariable& v = stage.outputs[i];
        if (v.builtin != Builtin::None || !v.spelling.empty()) continue;
        const std::string_view prefix = v.flat || v.type.is_integer() ? "nointerpolation " : "";
        w.line(1, fmt::format("{}{} : TEXCOORD{};", prefix, w.declaration(v.type, members[i]), next++));
    }
    for (const std::string& each : lines_at(stage, "interpolators")) w.line(1, numbered(each, next));
    w.line(0, "};");
    w.pieces.push_back(
        {.kind = Piece::Kind::Struct, .name = "v2f", .begin = begin, .end = w.text.size(), .line = line});
}

EntryPoint vertex_entry(Writer& w) {
    const StageInterface& stage = w.module.stage;
    EntryPoint entry;
    entry.names = {"v", "o"};
    std::string signature = "v2f vert(appdata_full v";
    for (const StageVariable& input : stage.inputs) {
        const std::string name = w.names.declare(input.name);
        signature += fmt::format(", uint {} : {}", name, hlsl::semantic(input, false));
        entry.inputs.push_back({fmt::format("int({})", name), Precedence::Postfix});
    }
    entry.signature = signature + ")";
    MemberNames names(w.options.taken);
    std::vector<std::string> members;
    for (const StageVariable& output : stage.outputs) {
        const bool is_member = output.builtin == Builtin::None && output.spelling.empty();
        members.push_back(is_member ? names.declare(output.name) : "pos");
        entry.outputs.push_back(output.spelling.empty() ? "o." + members.back() : output.spelling);
    }
    declare_varyings(w, members);
    entry.begin = lines_at(stage, "vertex begin");
    entry.begin.insert(entry.begin.begin(), "v2f o;");
    entry.end = lines_at(stage, "vertex end");
    for (std::string& line : lines_at(stage, "vertex result")) entry.end.push_back(std::move(line));
    entry.at_return = "return o;";
    return entry;
}

// The result of the fragment stage: one colour, or a struct of them.
std::string declare_targets(Writer& w, EntryPoint& entry) {
    const StageInterface& stage = w.module.stage;
    w.gap();
    const std::size_t begin = w.text.size();
    const int line = w.next_line;
    const std::string name = w.names.declare("Targets");
    w.line(0, "struct " + name);
    w.line(0, "{");
    Names members(w.options.taken, Names::Of::Members);
    for (const StageVariable& v : stage.outputs) {
        const std::string member = members.declare(v.name);
        if (!v.guard.empty()) w.line(0, "#if " + v.guard);
        w.line(1, fmt::format("half4 {} : {};", member, hlsl::semantic(v, true)));
        if (!v.guard.empty()) w.line(0, "#endif");
        entry.outputs.push_back("output." + member);
        entry.guards.push_back(v.guard);
    }
    w.line(0, "};");
    w.pieces.push_back({.kind = Piece::Kind::Struct, .name = name, .begin = begin, .end = w.text.size(), .line = line});
    entry.before_return = name + " output;";
    entry.at_return = "return output;";
    return name;
}

EntryPoint fragment_entry(Writer& w) {
    const StageInterface& stage = w.module.stage;
    EntryPoint entry;
    entry.names = {"i"};
    std::string parameters = "v2f i";
    MemberNames names(w.options.taken);
    for (const StageVariable& input : stage.inputs) {
        if (input.builtin == Builtin::None) entry.inputs.push_back({"i." + names.declare(input.name)});
        if (input.builtin == Builtin::FragCoord) entry.inputs.push_back({"i.pos"});
        if (input.builtin == Builtin::FrontFacing) {
            // Other functions may have a parameter of that name.
            const std::string name = w.names.is_free(input.name) ? input.name : w.names.declare(input.name);
            entry.names.push_back(name);
            parameters += fmt::format(", bool {} : {}", name, hlsl::semantic(input, false));
            entry.inputs.push_back({name});
        }
    }
    entry.begin = lines_at(stage, "fragment begin");
    entry.end = lines_at(stage, "fragment end");
    std::string result = stage.outputs.empty() ? "float4" : "half4", target = " : SV_Target";
    if (stage.outputs.size() == 1) {
        entry.outputs = {"return"};
    } else if (!stage.outputs.empty()) {
        result = declare_targets(w, entry);
        target.clear();
    }
    entry.signature = fmt::format("{} frag({}){}", result, parameters, target);
    return entry;
}

EntryPoint entry_point(Writer& w) {
    return w.module.stage.kind == StageKind::Vertex ? vertex_entry(w) : fragment_entry(w);
}

Language make_language() {
    Language made = hlsl::language();
    made.name = "shaderlab";
    made.name_of_number = name_of_number;
    made.read = read;
    made.expression = expression;
    made.block = block;
    made.resource = resource;
    made.keyword = keyword;
    made.keyword_test = keyword_test;
    made.entry_point = entry_point;
    return made;
}

}  // namespace

Module legalize(Module made) {
    made.tests_keywords = !made.keywords.empty();
    if (std::optional<Module> legal = hlsl::legalize(made)) made = std::move(*legal);
    made = decode_at_once(std::move(made));
    if (made.keywords.empty()) return made;
    made = branch_on_keywords(std::move(made));
    // A keyword that is on is a macro, so no constant can have its name.
    for (Global& global : made.globals) {
        if (global.is_keyword()) global.name = joined("is", global.name);
    }
    return made;
}

Printed print(const Module& module, const PrintOptions& options) {
    static const Language kLanguage = make_language();
    return languages::print(module, kLanguage, options);
}

}  // namespace patina::writers::shaderlab
