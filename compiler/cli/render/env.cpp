// patina env: the light of a picture of the surroundings, as numbers and as files that an engine can load.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/outputs.h"
#include "compiler/json/json_writer.h"
#include "patina/interpret.h"
#include "runtime/lighting/environment_file.h"
#include "runtime/lighting/prefilter.h"
#include "runtime/lighting/split_sum.h"
#include "runtime/picture/image.h"

namespace patina::cli {
namespace {

struct Arguments {
    runtime::EnvironmentChoice choice;
    std::string folder;
    bool json = false;
};

using Light = std::shared_ptr<const runtime::Environment>;

constexpr std::string_view kStudio = "studio";
constexpr std::string_view kSplitSum = "split_sum.exr";
constexpr std::array<std::string_view, 6> kFaces = {"px", "nx", "py", "ny", "pz", "nz"};

// What the coefficients are multiplied by, at the unit direction x, y, z.
constexpr std::array<std::string_view, 9> kBasis = {
    "0.282094791773878",           "0.48860251190292 y",   "0.48860251190292 z",           "0.48860251190292 x",
    "1.09254843059208 x y",        "1.09254843059208 y z", "0.31539156525252 (3 z^2 - 1)", "1.09254843059208 x z",
    "0.54627421529604 (x^2 - y^2)"};

std::string numbers(std::initializer_list<float> values) {
    std::string text;
    for (const float value : values) text += fmt::format("{}{:.8g}", text.empty() ? "" : ", ", value);
    return "[" + text + "]";
}
std::string numbers(glm::vec3 v) {
    return numbers({v.x, v.y, v.z});
}
std::string numbers(glm::vec4 v) {
    return numbers({v.x, v.y, v.z, v.w});
}

std::string stem_of(const Arguments& arguments) {
    return std::filesystem::path(arguments.choice.path).stem().string();
}

std::string face_name(const Arguments& arguments, int level, std::size_t face) {
    return fmt::format("{}.level{}.{}.exr", stem_of(arguments), level, kFaces[face]);
}

// The seven vectors of Unity's shaders, for its world, whose z points the other way.
std::string packed_json(const runtime::SphericalHarmonics& light) {
    const runtime::PackedIrradiance packed = runtime::packed_irradiance(runtime::with_z_reversed(light));
    std::string text;
    for (std::size_t i = 0; i < 3; ++i)
        text += fmt::format("    \"unity_SHA{}\": {},\n", "rgb"[i], numbers(packed.linear[i]));
    for (std::size_t i = 0; i < 3; ++i)
        text += fmt::format("    \"unity_SHB{}\": {},\n", "rgb"[i], numbers(packed.quadratic[i]));
    return text + fmt::format("    \"unity_SHC\": {}\n", numbers(glm::vec4(packed.last, 1)));
}

// The files of -o, with what each is for.
std::string files_json(const Arguments& arguments, const TextureData& map) {
    std::string text = ",\n  \"levels\": [\n";
    for (int level = 0; level < runtime::kEnvironmentLevels; ++level) {
        text += fmt::format("    {{ \"roughness\": {:.8g}, \"size\": {}, \"faces\": [",
                            runtime::roughness_of_level(level), map.levels[std::size_t(level)].width);
        for (std::size_t face = 0; face < kFaces.size(); ++face)
            text += (face > 0 ? ", " : "") + json_text(face_name(arguments, level, face));
        text += level + 1 < runtime::kEnvironmentLevels ? "] },\n" : "] }\n";
    }
    return text + fmt::format("  ],\n  \"splitSum\": \"{}\"", kSplitSum);
}

// `map`: null without -o.
std::string json_of(const Arguments& arguments, const Light& light, const TextureData* map) {
    std::string text =
        fmt::format("{{\n  \"file\": {},\n  \"rotation\": {},\n  \"intensity\": {},\n",
                    json_text(arguments.choice.path), arguments.choice.rotation, arguments.choice.intensity);
    text += "  \"world\": \"right-handed, y up; the middle of the picture is along -z\",\n  \"coefficients\": [\n";
    const auto& coefficients = light->ambient().coefficients;
    for (std::size_t i = 0; i < coefficients.size(); ++i)
        text += fmt::format("    {}{}\n", numbers(coefficients[i]), i + 1 < coefficients.size() ? "," : "");
    text += "  ],\n  \"basis\": [\n";
    for (std::size_t i = 0; i < kBasis.size(); ++i)
        text += fmt::format("    \"{}\"{}\n", kBasis[i], i + 1 < kBasis.size() ? "," : "");
    text += "  ],\n  \"unity\": {\n" + packed_json(light->ambient()) + "  }";
    if (map) text += files_json(arguments, *map);
    return text + "\n}\n";
}

std::string table_of(const Arguments& arguments, const Light& light) {
    const auto& coefficients = light->ambient().coefficients;
    std::string text = fmt::format("{}: nine coefficients of radiance\n", arguments.choice.path);
    for (std::size_t i = 0; i < coefficients.size(); ++i)
        text += fmt::format("{:>12.6f} {:>12.6f} {:>12.6f}   {}\n", coefficients[i].r, coefficients[i].g,
                            coefficients[i].b, kBasis[i]);
    return text;
}

runtime::Image face_of(const TextureLevel& level, std::size_t face) {
    runtime::Image image{.width = level.width, .height = level.height};
    const auto begin = level.texels.begin() + std::ptrdiff_t(face * std::size_t(level.width * level.height) * 4);
    image.pixels.assign(begin, begin + std::ptrdiff_t(level.width) * level.height * 4);
    return image;
}

Exit write_files(const Console& console, const Arguments& arguments, const Light& light) {
    const std::filesystem::path folder(arguments.folder);
    OutputFiles files;
    std::string error;
    const auto add = [&](std::string_view name, const runtime::Image& image) {
        const std::string path = (folder / name).string();
        runtime::Outcome<std::string> bytes = runtime::encode_exr(image);
        if (!bytes && error.empty()) error = "cannot write '" + path + "': " + bytes.error;
        files.add(path, std::move(bytes.value));
    };
    const auto map = light->map();
    for (int level = 0; level < runtime::kEnvironmentLevels; ++level) {
        for (std::size_t face = 0; face < kFaces.size(); ++face)
            add(face_name(arguments, level, face), face_of(map->levels[std::size_t(level)], face));
    }
    add(kSplitSum, face_of(runtime::split_sum_table()->levels.front(), 0));
    if (!error.empty()) {
        complain(console, Complaint::CannotWrite, {error});
        return Exit::Wrong;
    }
    files.add((folder / (stem_of(arguments) + ".light.json")).string(), json_of(arguments, light, map.get()));
    const std::string inputs[] = {arguments.choice.path};
    if (!Outputs(console).write(arguments.choice.path, files, inputs)) return Exit::Wrong;
    if (!arguments.json) say(console, files);
    return Exit::Ok;
}

Exit show(const Console& console, const Arguments& arguments) {
    Light light = runtime::studio_environment();
    if (arguments.choice.path != kStudio) {
        auto loaded = runtime::load_environment(arguments.choice, [&](double share, std::string_view file) {
            show_share(console, share, fmt::format("prefiltering {}", file));
        });
        if (!loaded) {
            complain(console, Complaint::BadEnvironment, {loaded.error});
            return Exit::Wrong;
        }
        light = loaded.value;
    }
    if (!arguments.folder.empty()) {
        const Exit written = write_files(console, arguments, light);
        end_progress(console);
        if (written != Exit::Ok || !arguments.json) return written;
    }
    print(arguments.json ? json_of(arguments, light, nullptr) : table_of(arguments, light));
    return Exit::Ok;
}

std::string is_finite(const std::string& word) {
    double value = 0;
    return CLI::detail::lexical_cast(word, value) && !std::isfinite(value) ? "'" + word + "' is not a finite number"
                                                                           : "";
}

}  // namespace

void add_env(Program& program) {
    CLI::App& command = add_command(program, "env",
                                    {"patina env sunset.hdr", "patina env sunset.hdr --json",
                                     "patina env sunset.hdr --rotation 90 -o light", "patina env studio -o light"});
    add_pixels_option(program, command);
    auto arguments = std::make_shared<Arguments>();
    command
        .add_option("FILE", arguments->choice.path,
                    "A picture: equirectangular (2:1), a cross of a cube's faces (4:3, 3:4) or a strip of them (6:1, "
                    "1:6); or studio, the default surroundings")
        ->required()
        ->type_name(" ");
    command.add_flag("--json", arguments->json,
                     "Print the coefficients and the seven vectors of Unity's shaders as JSON");
    command
        .add_option("-o,--output", arguments->folder,
                    "Folder to write to: the coefficients (NAME.light.json), the blurred cube's faces and the table of "
                    "the split sum (EXR)")
        ->type_name("DIR")
        ->check(is_folder_name);
    CLI::Option* rotation = command
                                .add_option("--rotation", arguments->choice.rotation,
                                            "Turn it by so many degrees about y, counter-clockwise seen from above")
                                ->type_name("DEGREES")
                                ->check(is_finite)
                                ->check(within(-1e5, 1e5));
    CLI::Option* intensity = command.add_option("--intensity", arguments->choice.intensity, "Multiply its light")
                                 ->type_name("FACTOR")
                                 ->check(is_finite)
                                 ->check(within(0, 1e6));
    set_check(command, [=] {
        if (arguments->choice.path == kStudio && rotation->count() + intensity->count() > 0)
            throw CLI::ValidationError("--rotation", "the studio has no settings: only a picture has");
    });
    set_work(program, command, [arguments](const Console& console) {
        if (is_mixed(console, arguments->json, "--json")) return Exit::Usage;
        return show(console, *arguments);
    });
}

}  // namespace patina::cli
