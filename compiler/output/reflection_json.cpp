// Writes a Reflection as JSON (NAME.reflect.json), pretty-printed, with keys in a fixed order.
#include <fmt/format.h>
#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>

#include "compiler/base/text.h"
#include "patina/reflection.h"

namespace patina {
namespace {

using Writer = rapidjson::PrettyWriter<rapidjson::StringBuffer>;

class Json {
public:
    explicit Json(Writer& writer) : writer_(writer) { writer_.StartObject(); }
    ~Json() { writer_.EndObject(); }
    Json(const Json&) = delete;
    Json& operator=(const Json&) = delete;

    void text(const char* key, std::string_view value) {
        writer_.Key(key);
        writer_.String(value.data(), static_cast<rapidjson::SizeType>(value.size()));
    }
    void text_if(const char* key, const std::string& value) {
        if (!value.empty()) text(key, value);
    }
    void word(const char* key, HasWords auto value) { text(key, to_string(value)); }
    void number(const char* key, double value) {
        writer_.Key(key);
        raw(shortest(value));
    }
    void flag(const char* key, bool value) {
        writer_.Key(key);
        writer_.Bool(value);
    }
    void raw(const std::string& json) { writer_.RawValue(json.data(), json.size(), rapidjson::kObjectType); }
    void raw(const char* key, const std::string& json) {
        writer_.Key(key);
        raw(json);
    }
    template <class Items, class Write>
    void list(const char* key, const Items& items, Write write) {
        writer_.Key(key);
        writer_.StartArray();
        for (const auto& item : items) write(item);
        writer_.EndArray();
    }
    void words(const char* key, const std::vector<std::string>& items) {
        list(key, items,
             [&](const std::string& s) { writer_.String(s.data(), static_cast<rapidjson::SizeType>(s.size())); });
    }

private:
    Writer& writer_;
};

std::size_t value_count(const Property& property) {
    switch (property.type) {
        case PropertyType::Color:
        case PropertyType::Float4: return 4;
        case PropertyType::Float3: return 3;
        case PropertyType::Float2: return 2;
        case PropertyType::Float:
        case PropertyType::Int:
        case PropertyType::Bool:
        case PropertyType::Enum:
        case PropertyType::Texture2D:
        case PropertyType::TextureCube:
        case PropertyType::Texture2DArray:
        case PropertyType::Texture3D: return 1;
    }
    return 1;
}

void write_default(Json& json, const Property& property, const Reflection& reflection) {
    if (is_texture(property.type)) {
        for (const Texture& texture : reflection.textures) {
            if (texture.name == property.name) json.text("default", texture.default_value);
        }
    } else if (property.type == PropertyType::Bool) {
        json.flag("default", property.value[0] != 0);
    } else if (property.type == PropertyType::Enum) {
        const auto index = static_cast<std::size_t>(property.value[0]);
        if (index < property.values.size()) json.text("default", property.values[index]);
        json.number("defaultIndex", property.value[0]);
    } else if (const std::size_t count = value_count(property); count == 1) {
        json.number("default", property.value[0]);
    } else {
        json.list(
            "default",
            std::vector<double>(property.value.begin(), property.value.begin() + static_cast<std::ptrdiff_t>(count)),
            [&](double v) { json.raw(shortest(v)); });
    }
}

void write_property(Writer& writer, const Property& property, const Reflection& reflection) {
    Json json(writer);
    json.text("name", property.name);
    json.text("identifier", property.identifier);
    json.word("type", property.type);
    if (property.binding != Binding::Uniform) json.word("as", property.binding);
    if (property.constant_id) json.number("constantId", *property.constant_id);
    write_default(json, property, reflection);
    if (property.range) json.list("range", *property.range, [&](double v) { json.raw(shortest(v)); });
    if (property.hard) json.flag("hard", true);
    if (!property.values.empty()) json.words("values", property.values);
    json.text_if("label", property.label);
    json.text_if("group", property.group);
    json.text_if("help", property.help);
    if (property.block.empty()) return;
    json.text("block", property.block);
    json.number("offset", property.offset);
    json.number("size", property.size);
    if (property.instance_stride > 0) json.number("instanceStride", property.instance_stride);
}

void write_block(Writer& writer, const Block& block) {
    Json json(writer);
    json.text("name", block.name);
    json.flag("material", block.is_material);
    json.number("set", block.set);
    json.number("binding", block.binding);
    json.text("register", block.hlsl_register);
    json.number("size", block.size);
    if (block.matrices != MatrixOrder::Columns) json.text("matrices", to_string(block.matrices));
    json.list("members", block.members, [&](const BlockMember& member) {
        Json m(writer);
        m.text("name", member.name);
        m.text("type", member.type);
        m.number("offset", member.offset);
        m.number("size", member.size);
        if (member.array_count > 0) {
            m.number("count", member.array_count);
            m.number("stride", member.array_stride);
        }
        if (member.is_of_instance) m.flag("instance", true);
    });
}

void write_texture(Writer& writer, const Texture& texture) {
    Json json(writer);
    json.text("name", texture.name);
    json.text("identifier", texture.identifier);
    json.word("dimension", texture.dimension);
    json.word("usage", texture.usage);
    if (texture.handedness != Handedness::OpenGL) json.word("handedness", texture.handedness);
    json.text_if("swizzle", texture.swizzle);
    json.flag("material", texture.is_material);
    json.text_if("default", texture.default_value);
    if (texture.grid != Texture{}.grid) json.list("grid", texture.grid, [&](int v) { json.raw(std::to_string(v)); });
    json.text_if("reads", texture.reads);
    json.number("set", texture.set);
    json.number("binding", texture.binding);
    json.text("register", texture.hlsl_register);
    json.text("sampler", texture.sampler_name);
    json.number("samplerBinding", texture.sampler_binding);
    json.text("samplerRegister", texture.sampler_register);
    if (!texture.tiling.empty()) {
        json.text("tiling", texture.tiling);
        json.list("tilingDefault", texture.tiling_default, [&](double v) { json.raw(shortest(v)); });
    }
    json.word("wrap", texture.sampler.wrap);
    json.word("filter", texture.sampler.filter);
    json.number("anisotropy", texture.sampler.anisotropy);
}

void write_stencil(Json& json, const Stencil& stencil) {
    json.word("stencilTest", stencil.test);
    json.word("stencilPass", stencil.pass);
    if (stencil.is_of_lighting()) return json.word("stencilReference", stencil.reference);
    json.word("stencilFail", stencil.fail);
    json.word("stencilDepthFail", stencil.depth_fail);
    json.number("stencilReference", stencil.value);
    json.number("stencilReadMask", stencil.read_mask);
    json.number("stencilWriteMask", stencil.write_mask);
}

void write_bounds(Json& json, const Bounds& bounds) {
    if (!bounds.box) return json.number("bounds", bounds.margin);
    std::string text = "[";
    for (const std::array<double, 3>& corner : *bounds.box) {
        text += fmt::format("{}[{}, {}, {}]", text.size() > 1 ? ", " : "", shortest(corner[0]), shortest(corner[1]),
                            shortest(corner[2]));
    }
    json.raw("bounds", text + "]");
}

void write_pass(Writer& writer, const Pass& pass) {
    Json json(writer);
    json.text("name", pass.name);
    if (pass.is_extra) json.flag("extra", true);
    json.word("draws", pass.draws);
    json.word("each", pass.each);
    json.word("lights", pass.lights);
    json.word("camera", pass.camera);
    json.text_if("fallback", pass.fallback);
    json.word("cull", pass.cull);
    json.text("depthTarget", pass.depth_target);
    json.flag("depthWrite", pass.depth_write);
    json.word("depthTest", pass.depth_test);
    if (pass.depth_bias != 0 || pass.depth_slope_bias != 0) {
        json.raw("depthBias", shortest(pass.depth_bias));
        json.raw("depthSlopeBias", shortest(pass.depth_slope_bias));
    }
    if (pass.stencil.is_used()) write_stencil(json, pass.stencil);
    json.number("queue", pass.queue);
    if (pass.bounds) write_bounds(json, *pass.bounds);
    json.list("targets", pass.targets, [&](const RenderTarget& target) {
        Json t(writer);
        t.text("name", target.name);
        t.number("location", target.location);
        t.word("format", target.format);
        t.word("blendSource", target.blend.source);
        t.word("blendDestination", target.blend.destination);
        t.word("blendSourceAlpha", target.blend.source_alpha);
        t.word("blendDestinationAlpha", target.blend.destination_alpha);
    });
    json.list("vertexInputs", pass.vertex_inputs, [&](const VertexInput& input) {
        Json v(writer);
        v.text("name", input.name);
        v.text("type", input.type);
        v.number("location", input.location);
        v.text("semantic", input.hlsl_semantic);
    });
    if (!pass.shaders.empty())
        json.list("shaders", pass.shaders, [&](const ShaderFile& shader) {
            Json s(writer);
            s.word("stage", shader.stage);
            s.text("language", shader.language);
            s.text("file", shader.file);
        });
    json.words("blocks", pass.blocks);
    json.words("textures", pass.textures);
    json.words("vertexReads", pass.vertex_reads);
    json.words("fragmentReads", pass.fragment_reads);
}

void write_function(Writer& writer, const ShaderFunction& function) {
    Json json(writer);
    json.text("name", function.name);
    json.word("stage", function.stage);
    json.flag("engine", function.is_engines);
    json.text("result", function.result);
    json.list("parameters", function.parameters, [&](const ShaderFunction::Parameter& parameter) {
        Json p(writer);
        p.text("name", parameter.name);
        p.text("type", parameter.type);
    });
}

}  // namespace

std::string Reflection::to_json() const {
    rapidjson::StringBuffer buffer;
    Writer writer(buffer);
    writer.SetIndent(' ', 2);
    writer.SetFormatOptions(rapidjson::kFormatSingleLineArray);
    {
        Json json(writer);
        json.number("patina", 1);
        json.text("name", name);
        json.text("workflow", workflow);
        json.text("lighting", lighting);
        json.word("surface", surface);
        json.text("path", path);
        if (bounds) write_bounds(json, *bounds);
        if (clip_depth != ClipDepth::NearToFar) json.text("clipDepth", to_string(clip_depth));
        if (most_instances > 0) json.number("mostInstances", most_instances);
        json.list("switches", switches, [&](const Switch& each) {
            Json one(writer);
            one.text("name", each.name);
            one.flag("value", each.value);
        });
        json.text("layoutHash", layout_hash);
        json.list("properties", properties, [&](const Property& p) { write_property(writer, p, *this); });
        json.list("blocks", blocks, [&](const Block& b) { write_block(writer, b); });
        json.list("textures", textures, [&](const Texture& t) { write_texture(writer, t); });
        json.list("passes", passes, [&](const Pass& p) { write_pass(writer, p); });
        if (!functions.empty())
            json.list("functions", functions, [&](const ShaderFunction& f) { write_function(writer, f); });
        json.list("hlslShifts", hlsl_shifts, [&](const Shifts& s) {
            Json shift(writer);
            shift.number("set", s.set);
            shift.number("buffers", s.buffers);
            shift.number("textures", s.textures);
            shift.number("samplers", s.samplers);
        });
        if (!meta.empty()) json.raw("meta", meta);
    }
    return std::string(buffer.GetString(), buffer.GetSize()) + "\n";
}

}  // namespace patina
