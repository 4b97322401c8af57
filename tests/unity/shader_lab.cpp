#include "unity/shader_lab.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

namespace patina::unity {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line.substr(std::min(line.find_first_not_of(' '), line.size())));
    return lines;
}

std::string read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    EXPECT_FALSE(text.str().empty()) << path;
    return text.str();
}

// Each file once, in the place of the line that names it.
std::string with_includes(const std::string& text, std::set<std::string>& seen) {
    std::string made;
    for (const std::string& line : lines_of(text)) {
        constexpr std::string_view kInclude = "#include \"";
        if (!line.starts_with(kInclude)) {
            made += line + "\n";
            continue;
        }
        const std::string name = line.substr(kInclude.size(), line.rfind('"') - kInclude.size());
        if (seen.insert(name).second) made += with_includes(read("tests/unity/include/" + name), seen);
    }
    return made;
}

// The runtime's blocks, member by member at their offsets.
std::string declared(const Block& block) {
    std::string text = fmt::format("cbuffer {} : register({})\n{{\n", block.name, block.hlsl_register);
    for (const BlockMember& member : block.members) {
        const std::string size = member.array_count > 0 ? fmt::format("[{}]", member.array_count) : "";
        text += fmt::format("    {} {}{} : packoffset(c{}.{});\n", to_string(member.type), member.name, size,
                            member.offset / 16, "xyzw"[member.offset / 4 % 4]);
    }
    return text + "};\n";
}

// What the file says of a texture's size, (1/width, 1/height, width, height), which the runtime does not fill.
bool is_texel_size(const std::string& line, const Reflection& reflection) {
    return std::any_of(reflection.textures.begin(), reflection.textures.end(), [&](const Texture& texture) {
        return texture.is_material && line == fmt::format("float4 {}_TexelSize;", texture.identifier);
    });
}

bool is_uniform(const std::string& line, const Reflection& reflection) {
    if (is_texel_size(line, reflection)) return true;
    for (const Block& block : reflection.blocks) {
        for (const BlockMember& member : block.members) {
            if (block.is_material && line.ends_with(" " + member.name + ";") &&
                std::count(line.begin(), line.end(), ' ') == 1)
                return true;
        }
    }
    return false;
}

std::string preamble(const Reflection& reflection, const std::vector<std::string>& keywords, Values values) {
    std::string text;
    for (const std::string& keyword : keywords) text += "#define " + keyword + " 1\n";
    if (values == Values::OfRuntime) text += "#define STAND_IN_REGISTERS\n";
    for (const Block& block : reflection.blocks) {
        if (block.is_material && values == Values::OfFile) continue;
        text += declared(block);
        for (const BlockMember& member : block.members) {
            if (member.name == "objectToWorld" && member.array_count > 0) text += "#define STAND_IN_INSTANCES\n";
        }
    }
    for (const Texture& texture : reflection.textures) {
        if (texture.is_material) {
            text += fmt::format("#define REGISTER_{0} register({1})\n#define REGISTER_sampler{0} register({2})\n",
                                texture.identifier, texture.hlsl_register, texture.sampler_register);
            text += fmt::format("#define TEXEL_{} {}\n", texture.identifier,
                                texture.usage == TextureUsage::Color ? "handedOver" : "as_it_is");
            if (values == Values::OfRuntime)
                text += fmt::format("#define {0}_TexelSize size_of({0})\n", texture.identifier);
        } else if (texture.dimension == TextureDimension::Cube) {
            text += fmt::format("TextureCube {} : register({});\nSamplerState {} : register({});\n", texture.identifier,
                                texture.hlsl_register, texture.sampler_name, texture.sampler_register);
        }
    }
    return text;
}

}  // namespace

const LabPass* ShaderLab::pass(const std::string& light_mode) const {
    const auto found =
        std::find_if(passes.begin(), passes.end(), [&](const LabPass& pass) { return pass.light_mode == light_mode; });
    return found == passes.end() ? nullptr : &*found;
}

const LabPass* ShaderLab::forward() const {
    const LabPass* lit = pass("ForwardBase");
    return lit ? lit : pass("");
}

ShaderLab taken_apart(const std::string& text) {
    ShaderLab made;
    std::string common, state;
    enum class Section { Lab, Common, Program } section = Section::Lab;
    LabPass pass;
    for (const std::string& line : lines_of(text)) {
        if (line == "CGINCLUDE") {
            section = Section::Common;
        } else if (line == "CGPROGRAM") {
            section = Section::Program;
            pass.program = common;
        } else if (line == "ENDCG") {
            if (section == Section::Program) made.passes.push_back(std::exchange(pass, {}));
            section = Section::Lab;
        } else if (section == Section::Common) {
            common += line + "\n";
        } else if (section == Section::Program && line.starts_with("#pragma ")) {
            pass.pragmas.push_back(line.substr(8));
        } else if (section == Section::Program) {
            pass.program += line + "\n";
        } else if (line == "Pass") {
            pass = {};
        } else if (const std::size_t at = line.find("\"LightMode\" = \""); at != line.npos) {
            pass.light_mode = line.substr(at + 15, line.find('"', at + 15) - at - 15);
        } else {
            pass.state += line + "\n";
        }
    }
    return made;
}

Shader stage(const LabPass& pass, const Reflection& reflection, Stage stage, const std::vector<std::string>& keywords,
             Values values) {
    std::set<std::string> seen;
    std::string program;
    for (const std::string& line : lines_of(pass.program)) {
        if (values == Values::OfFile || !is_uniform(line, reflection)) program += line + "\n";
    }
    // Unity includes these two by itself. Colours of the material are handed over as the project keeps them.
    std::string text = preamble(reflection, keywords, values) +
                       with_includes("#include \"HLSLSupport.cginc\"\n#include \"UnityShaderVariables.cginc\"", seen);
    for (const Property& property : reflection.properties) {
        const bool is_decoded = pass.program.find("LinearColor(" + property.identifier + ")") != std::string::npos;
        if (property.type == PropertyType::Color && is_decoded && values == Values::OfRuntime)
            text += fmt::format("#define {0} handedOver({0})\n", property.identifier);
    }
    text += fmt::format("#define {} main\n", stage == Stage::Vertex ? "vert" : "frag");
    text += with_includes(program, seen);
    return {.pass = pass.light_mode,
            .stage = stage,
            .target = Target::Hlsl,
            .file_name = pass.light_mode + ".hlsl",
            .text = std::move(text),
            .line_map = {},
            .hlsl_shifts = reflection.hlsl_shifts};
}

std::vector<VertexInput> appdata_full() {
    std::vector<VertexInput> inputs;
    for (const char* name : {"positionOS", "tangentOS", "normalOS", "uv0", "uv1", "uv2", "uv3", "vertexColor"}) {
        inputs.push_back({.name = name,
                          .type = ValueType::Float4,
                          .location = static_cast<std::uint32_t>(inputs.size()),
                          .hlsl_semantic = {}});
    }
    return inputs;
}

}  // namespace patina::unity
