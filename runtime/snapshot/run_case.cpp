#include "runtime/snapshot/run_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "runtime/files/files.h"
#include "runtime/picture/flip.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

// --- what a reference picture notes of itself

constexpr const char* kDevice = "Patina Device";
constexpr const char* kDriver = "Patina Driver";
constexpr const char* kCost = "Patina SPIR-V Bytes";

PictureNotes notes_of(const PictureRecord& record) {
    PictureNotes notes = {{kDevice, record.device}, {kDriver, record.driver}};
    if (record.spirv_bytes > 0) notes[kCost] = std::to_string(record.spirv_bytes);
    return notes;
}

PictureRecord record_of(PictureNotes notes) {
    PictureRecord record{.device = notes[kDevice], .driver = notes[kDriver]};
    const std::string& bytes = notes[kCost];
    std::from_chars(bytes.data(), bytes.data() + bytes.size(), record.spirv_bytes);
    return record;
}

std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string all_texts(const std::vector<DrawnShader>& shaders) {
    std::string text;
    for (const DrawnShader& shader : shaders)
        text += fmt::format("{}// --- {}\n{}", text.empty() ? "" : "\n", shader.file_name, shader.text);
    return text;
}

// The work on one case.
class Judgement {
public:
    Judgement(const PlannedCase& planned, const SnapshotOptions& options, SnapshotCase& result)
        : planned_(planned), options_(options), result_(result) {
        const std::string language = planned.request.options.via == "hlsl" ? "hlsl" : "glsl";
        if (planned.text && options.via.empty()) text_reference_ = planned.shaders(language);
        received_text_ = received("received." + language);
    }

    // `received` is what an 8-bit file would hold, so that it can meet the reference exactly.
    void run(const Image& received, const std::string& text) {
        std::error_code ignored;
        for (const fs::path& earlier :
             {this->received("received.png"), this->received("difference.png"), received_text_})
            fs::remove(earlier, ignored);
        const bool has_picture = compare_pictures(received);
        const bool has_text = compare_texts(text);
        if (options_.update) return update(received, text, has_picture && has_text);
        if (!has_picture || !has_text) {
            result_.state = SnapshotState::Missing;
            result_.message = missing(has_picture ? text_reference_ : result_.reference);
        }
        if (result_.state == SnapshotState::Passed) return;
        keep(received, text);
    }

private:
    fs::path received(const std::string& ending) const {
        return fs::path(options_.received_dir) / (result_.name + "." + ending);
    }
    void fail(const std::string& why) {
        result_.state = SnapshotState::Failed;
        result_.message += (result_.message.empty() ? "" : "; ") + why;
    }

    // False: there is no reference to compare with.
    bool compare_pictures(const Image& received) {
        result_.state = SnapshotState::Passed;
        std::error_code ignored;
        if (!fs::exists(result_.reference, ignored)) return false;
        Outcome<Image> reference = load_image(result_.reference);
        if (!reference) {
            fail(reference.error);
            return true;
        }
        reference_ = quantized(reference.value);  // what OpenImageIO makes of a byte may be off in the last bit
        result_.then = record_of(load_notes(result_.reference));
        if (options_.keeps_pictures) result_.reference_png = read_file(result_.reference);
        result_.other_driver = !result_.then.device.empty() &&
                               (result_.then.device != result_.now.device || result_.then.driver != result_.now.driver);
        Tolerance tolerance = planned_.tolerance;
        for (const auto& [name, value] : options_.tolerance) tolerance.*find_tolerance_key(name)->member = value;
        if (result_.other_driver) tolerance = widened(tolerance);
        tolerance_ = tolerance;
        const Comparison comparison = compare(reference_, received, tolerance.pixel);
        if (!comparison.same_size) {
            fail(fmt::format("the reference is {} x {} pixels and the picture {} x {}", reference_.width,
                             reference_.height, received.width, received.height));
            return true;
        }
        result_.gates = figures(comparison, flip(reference_, received), tolerance);
        if (!all_pass(result_.gates)) fail(describe(comparison));
        return true;
    }

    std::string describe(const Comparison& comparison) const {
        std::string text = "the picture differs: ";
        bool is_first = true;
        for (const Gate& gate : result_.gates) {
            if (gate.passes()) continue;
            if (!is_first) text += ", ";
            is_first = false;
            text += to_text(gate);
            if (gate.name == "tile") text += fmt::format(" at {}, {}", comparison.tile_x, comparison.tile_y);
        }
        return text + fmt::format("; the largest difference is {:.2g}, at {}, {}", comparison.largest,
                                  comparison.worst_x, comparison.worst_y);
    }

    bool compare_texts(const std::string& text) {
        if (text_reference_.empty()) return true;
        std::error_code ignored;
        if (!fs::exists(text_reference_, ignored)) return false;
        result_.text_diff = differences(read_file(text_reference_), text);
        if (const std::size_t count = changed_lines(result_.text_diff); count > 0)
            fail(fmt::format("{} lines of the shaders differ from '{}'", count, text_reference_));
        return true;
    }

    // Reference pictures were once named NAME.png, which is now a picture that 'patina render' writes.
    std::string missing(const std::string& reference) const {
        std::error_code ignored;
        const std::string old = planned_.stem + ".png";
        const std::string advice = reference == result_.reference && fs::exists(old, ignored)
                                       ? fmt::format("; if '{}' is it, rename it", old)
                                       : "";
        return fmt::format(
            "there is no reference '{}' yet: look at what was received, and accept it with "
            "'patina snapshot {} --update {}'{}",
            reference, planned_.folder, result_.name, advice);
    }

    // References that are as they should be stay, but for one that does not say yet what drew it.
    void update(const Image& received, const std::string& text, bool is_complete) {
        const bool is_unrecorded = result_.then.device.empty() && reference_.pixels == received.pixels;
        if (result_.state == SnapshotState::Passed && is_complete && !is_unrecorded) return;
        std::vector<OutputFile> files;
        const Outcome<std::string> png = encode_png_as_is(received, notes_of(result_.now));
        if (!png) return fail(png.error);
        files.push_back({.path = result_.reference, .bytes = png.value});
        if (!text_reference_.empty()) files.push_back({.path = text_reference_, .bytes = text});
        result_.message = write_files(files);
        result_.state = result_.message.empty() ? SnapshotState::Updated : SnapshotState::Failed;
    }

    // Writes what was received, and keeps its path; appends to the message what went wrong.
    void keep(const Image& picture, const std::string& text) {
        const bool has_reference = !reference_.pixels.empty();
        write(received("received.png"), picture, result_.received, result_.received_png);
        if (has_reference)
            write(received("difference.png"), difference_image(reference_, picture, tolerance_.pixel),
                  result_.difference, result_.difference_png);
        if (text_reference_.empty()) return;
        if (const std::string problem = write_file(received_text_.string(), text); !problem.empty())
            result_.message += "; " + problem;
    }

    void write(const fs::path& path, const Image& picture, std::string& written, std::string& bytes) {
        const Outcome<std::string> png = encode_png_as_is(picture, notes_of(result_.now));
        const std::string problem = png ? write_file(path.string(), png.value) : png.error;
        if (options_.keeps_pictures) bytes = png.value;
        if (problem.empty())
            written = path.string();
        else
            result_.message += "; " + problem;
    }

    const PlannedCase& planned_;
    const SnapshotOptions& options_;
    SnapshotCase& result_;
    std::string text_reference_{};  // empty: no text is compared
    fs::path received_text_{};
    Image reference_{};
    Tolerance tolerance_{};
};

// Diagnostics without a place are about the path.
void place(std::vector<Diagnostic>& diagnostics, const ScenePlace& path_place) {
    for (Diagnostic& each : diagnostics) {
        if (!each.file.empty()) continue;
        Diagnostic placed = diagnostic_at(path_place, each.code, each.message);
        placed.severity = each.severity;
        placed.notes = std::move(each.notes);
        each = std::move(placed);
    }
}

void draw_and_judge(const Compiler& compiler, const PlannedCase& planned, const SnapshotOptions& options,
                    RenderMachine& machine, SnapshotCase& result) {
    RenderRequest request = planned.request;
    if (!options.via.empty()) request.options.via = options.via;
    request.options.device = options.device;
    request.options.validation = options.validation;
    request.options.include_dirs = options.include_dirs;
    RenderOutcome outcome = render(compiler, request, machine);
    result.diagnostics = std::move(outcome.diagnostics);
    place(result.diagnostics, planned.path_place);
    result.missing_machine = outcome.missing_machine;
    if (!outcome.ok) {
        result.message = outcome.error;
        return;
    }
    result.now = {.device = outcome.device, .driver = outcome.driver};
    for (const DrawnShader& shader : outcome.shaders) result.now.spirv_bytes += shader.spirv_bytes;
    encode_srgb(outcome.image);
    const Image received = quantized(outcome.image);
    Judgement(planned, options, result).run(received, all_texts(outcome.shaders));
    if (options.keeps_pictures && result.received_png.empty())
        if (const Outcome<std::string> png = encode_png_as_is(received)) result.received_png = png.value;
}

}  // namespace

SnapshotCase run_case(const Compiler& compiler, const PlannedCase& planned, const SnapshotOptions& options,
                      RenderMachine& machine) {
    const auto begin = std::chrono::steady_clock::now();
    SnapshotCase result{.name = planned.name, .file = planned.file, .reference = planned.picture()};
    if (planned.problem)
        result.diagnostics = {*planned.problem};
    else
        draw_and_judge(compiler, planned, options, machine, result);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

}  // namespace patina::runtime
