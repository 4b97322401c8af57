#include "patina/validate.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>

#include "compiler/seam/seam.h"
#include "compiler/validate/compile.h"
#include "compiler/validate/inlined.h"

namespace patina {
namespace {

// glslang's tables are built once in a process; after that, any thread may use them.
void initialise_glslang() {
    static const bool done = glslang::InitializeProcess();
    static_cast<void>(done);
}

// The registers of t, s and b each count from 0, but a set has one row of bindings. The reflection gives the distances.
void shift_bindings(glslang::TShader& shader, const std::vector<Reflection::Shifts>& shifts) {
    for (const Reflection::Shifts& s : shifts) {
        shader.setShiftBindingForSet(glslang::EResTexture, s.textures, s.set);
        shader.setShiftBindingForSet(glslang::EResSampler, s.samplers, s.set);
        shader.setShiftBindingForSet(glslang::EResUbo, s.buffers, s.set);
    }
}

// How glslang reads a language.
struct FrontEnd {
    std::string_view language, title;
    glslang::EShSource source;
    int messages;                    // of EShMessages, for this language
    std::string_view before, after;  // the text that turns functions into a shader
    bool has_registers;              // bindings are registers, which must be shifted
};
constexpr FrontEnd kFrontEnds[] = {
    {.language = "glsl",
     .title = "GLSL",
     .source = glslang::EShSourceGlsl,
     .messages = EShMsgDefault,
     .before = "#version 450\n"
               "#extension GL_EXT_shader_explicit_arithmetic_types_float16 : enable\n"
               "#extension GL_EXT_samplerless_texture_functions : enable\n",
     .after = "\nvoid main() {}\n",
     .has_registers = false},
    {.language = "hlsl",
     .title = "HLSL",
     .source = glslang::EShSourceHlsl,
     .messages = EShMsgReadHlsl | EShMsgHlslLegalization,
     .before = {},
     .after = "\nvoid main() {}\n",
     .has_registers = true},
};

// Null if glslang does not read the language.
const FrontEnd* front_end(const Shader& shader) {
    const auto* const found = std::find_if(std::begin(kFrontEnds), std::end(kFrontEnds), [&](const FrontEnd& each) {
        return each.language == shader.target.language;
    });
    return found == std::end(kFrontEnds) ? nullptr : found;
}

Diagnostic diagnostic(const Shader& shader, std::string_view message) {
    Diagnostic d;
    d.code = "downstream-error";
    const FrontEnd* language = front_end(shader);
    d.message = fmt::format("the generated {} does not compile: {}",
                            language ? language->title : std::string_view(shader.target.language), message);
    return d;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kSpace = " \t\r\n\0";
    const std::size_t begin = std::min(text.find_first_not_of(kSpace), text.size());
    text.remove_prefix(begin);
    return text.substr(0, text.find_last_not_of(kSpace) + 1);
}

std::string_view line_of(std::string_view text, int line) {
    for (int i = 1; i < line && !text.empty(); ++i) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    return text.substr(0, text.find('\n'));
}

}  // namespace

void locate(Diagnostic& d, const Shader& shader, int line) {
    const auto after = std::upper_bound(shader.line_map.begin(), shader.line_map.end(), line,
                                        [](int l, const LineOrigin& origin) { return l < origin.line; });
    if (after != shader.line_map.begin()) {
        const LineOrigin& origin = *std::prev(after);
        d.file = origin.file;
        d.line = origin.source_line;
        d.column = origin.source_column;
        d.end_line = origin.source_line;
        d.end_column = origin.source_end_column;
        d.source_line = origin.source_text;
        d.node = origin.node;
    }
    Diagnostic note;
    note.severity = Severity::Note;
    note.code = d.code;
    note.message = fmt::format("line {} of {}: {}", line, shader.file_name, trimmed(line_of(shader.text, line)));
    d.notes.push_back(std::move(note));
}

namespace {

// Takes the line number off a message ("ERROR: 0:12: 'x' : undeclared identifier", "ERROR: name:12: ...", "(12): error
// at column 3, ..."), if it has one, and leaves the rest.
int take_line(std::string_view& message) {
    std::string_view digits = message;
    if (message.starts_with('(')) {
        digits.remove_prefix(1);
    } else {
        const std::size_t colon = message.find(':');
        if (colon == std::string_view::npos) return 0;
        digits.remove_prefix(colon + 1);
    }
    int line = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), line);
    if (error != std::errc()) return 0;
    digits.remove_prefix(static_cast<std::size_t>(end - digits.data()));
    message = trimmed(digits.substr(std::min(digits.find_first_not_of("):"), digits.size())));
    return line;
}

// glslang ends its log with a summary, which is not a message.
bool is_summary(std::string_view message) {
    return message.find("compilation terminated") != std::string_view::npos ||
           message.find("compilation errors") != std::string_view::npos || message.starts_with("Linking ");
}

void add_messages(Validated& result, const Shader& shader, std::string_view log) {
    constexpr std::string_view kError = "ERROR: ";
    const std::size_t before = result.diagnostics.size();
    for (std::string_view rest = log; !rest.empty();) {
        const std::size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
        std::string_view message = trimmed(rest.substr(0, end));
        rest.remove_prefix(end);
        const bool is_error = message.starts_with(kError);
        if (is_error) message.remove_prefix(kError.size());
        if ((!is_error && !message.starts_with('(')) || is_summary(message)) continue;
        const int line = take_line(message);
        Diagnostic d = diagnostic(shader, message);
        if (line > 0) locate(d, shader, line);
        result.diagnostics.push_back(std::move(d));
    }
    if (result.diagnostics.size() == before) result.diagnostics.push_back(diagnostic(shader, trimmed(log)));
}

bool compile(const Shader& shader, const FrontEnd& language, HlslSamplers samplers, bool with_lines,
             Validated& result) {
    const EShLanguage stage = shader.stage == Stage::Vertex ? EShLangVertex : EShLangFragment;
    auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules | language.messages);
    const bool is_combined = language.has_registers && samplers == HlslSamplers::Combined;
    if (is_combined) messages = static_cast<EShMessages>(messages | EShMsgHlslDX9Compatible);

    glslang::TShader unit(stage);
    // Functions are put into the smallest shader.
    const std::string_view before = shader.has_main ? "" : language.before;
    const std::string_view after = shader.has_main ? "" : language.after;
    std::vector<const char*> texts;
    std::vector<int> lengths;
    for (const std::string_view text : {before, std::string_view(shader.text), after}) {
        if (text.empty()) continue;  // glslang requires #version in the first text
        texts.push_back(text.data());
        lengths.push_back(static_cast<int>(text.size()));
    }
    unit.setStringsWithLengths(texts.data(), lengths.data(), static_cast<int>(texts.size()));
    unit.setEntryPoint("main");
    unit.setSourceEntryPoint("main");
    unit.setEnvInput(language.source, stage, glslang::EShClientVulkan, 100);
    unit.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    unit.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
    if (language.has_registers) shift_bindings(unit, shader.hlsl_shifts);
    if (is_combined) unit.setAutoMapBindings(true);

    glslang::TProgram program;
    bool ok = unit.parse(GetDefaultResources(), 450, false, messages);
    std::string log = unit.getInfoLog();
    if (ok) {
        program.addShader(&unit);
        ok = program.link(messages) && program.mapIO();
        log += program.getInfoLog();
    }
    result.log += log;
    // For glslang this is a warning; it then makes an empty stage.
    if (!ok || log.find("Entry point not found") != std::string::npos) {
        add_messages(result, shader, log);
        return false;
    }
    glslang::SpvOptions options;
    options.disableOptimizer = true;
    options.generateDebugInfo = with_lines;
    spv::SpvBuildLogger logger;
    glslang::GlslangToSpv(*program.getIntermediate(stage), result.spirv, &logger, &options);
    result.log += logger.getAllMessages();
    return true;
}

// For more blocks in one function spirv-val, whose time grows with their square, takes minutes.
constexpr std::size_t kMostBlocks = 8'192;

bool check_spirv(const Shader& shader, Validated& result) {
    if (const Branching found = most_branching(result.spirv); found.blocks > kMostBlocks) {
        Diagnostic& made = result.diagnostics.emplace_back();
        made.code = "over-budget";
        made.message = fmt::format("blocks of branches of a function of '{}': {}, more than the budget of {}",
                                   shader.file_name, found.blocks, kMostBlocks);
        for (const int line : most_branching(spirv_with_lines(shader)).lines) {
            if (line == 0 || !made.file.empty()) continue;
            made.notes.clear();
            locate(made, shader, line);
        }
        return false;
    }
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    std::string words;
    tools.SetMessageConsumer(
        [&](spv_message_level_t, const char*, const spv_position_t& position, const char* message) {
            words += fmt::format("spirv-val: {} (at {})\n", message, position.index);
        });
    const bool ok = tools.Validate(result.spirv);
    result.log += words;
    if (!ok) result.diagnostics.push_back(diagnostic(shader, trimmed(words)));
    return ok;
}

}  // namespace

Validated validate(const Shader& shader, HlslSamplers samplers) {
    return guarded<Validated>(shader.file_name, [&](Trail&) {
        initialise_glslang();
        Validated result;
        const FrontEnd* language = front_end(shader);
        if (language)
            result.ok = compile(shader, *language, samplers, false, result) && check_spirv(shader, result);
        else
            result.diagnostics.push_back(
                diagnostic(shader, "it was not checked, because glslang does not read this language"));
        return result;
    });
}

std::vector<std::uint32_t> spirv_with_lines(const Shader& shader) {
    initialise_glslang();
    Validated result;
    const FrontEnd* language = front_end(shader);
    return language && compile(shader, *language, HlslSamplers::Separate, true, result) ? result.spirv
                                                                                        : std::vector<std::uint32_t>();
}

std::vector<std::uint32_t> optimised(const std::vector<std::uint32_t>& spirv) {
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_3);
    optimizer.RegisterPerformancePasses();
    std::vector<std::uint32_t> result;
    if (!optimizer.Run(spirv.data(), spirv.size(), &result)) result.clear();
    return result;
}

std::string disassemble(const std::vector<std::uint32_t>& spirv) {
    const spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    std::string text;
    const auto options = SPV_BINARY_TO_TEXT_OPTION_INDENT | SPV_BINARY_TO_TEXT_OPTION_FRIENDLY_NAMES;
    return tools.Disassemble(spirv, &text, options) ? text : std::string();
}

}  // namespace patina
