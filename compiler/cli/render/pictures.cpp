#include <filesystem>
#include <memory>

#include "compiler/cli/diff/report.h"
#include "compiler/cli/outputs.h"
#include "runtime/picture/compare.h"
#include "runtime/picture/contact_sheet.h"
#include "runtime/render/render_request.h"

namespace patina::cli {
namespace {

constexpr double kThreshold = 3.01 / 255;  // a smaller difference is one of rounding
constexpr float kGain = 8;

bool draw(const Console& console, const Compiler& compiler, const Version& version, const PictureWish& wish,
          runtime::RenderMachine& machine, runtime::Image& image) {
    runtime::RenderRequest request{.graph = version.path, .size = wish.size};
    request.options.path = wish.options.passes()->path;
    request.options.switches = wish.options.switches;
    request.options.include_dirs = wish.options.include_dirs;
    request.options.accept_parts = true;
    const std::string path = std::filesystem::path(version.path).lexically_normal().generic_string();
    request.options.files = std::make_shared<const runtime::MemoryFiles>(runtime::MemoryFiles{{path, version.text}});
    runtime::RenderOutcome outcome = runtime::render(compiler, request, machine);
    report(console, outcome.diagnostics);
    if (!outcome.error.empty()) complain(console, Complaint::CannotRender, {outcome.error});
    image = std::move(outcome.image);
    return outcome.ok;
}

}  // namespace

std::optional<PictureChange> compare_pictures(const Console& console, const Version& before, const Version& after,
                                              const PictureWish& wish) {
    const Compiler compiler;
    runtime::RenderMachine machine;
    runtime::Image linear[2];
    if (!draw(console, compiler, before, wish, machine, linear[0])) return std::nullopt;
    if (!draw(console, compiler, after, wish, machine, linear[1])) return std::nullopt;

    // As a person sees them: encoded, and not brighter than white.
    runtime::Image encoded[2] = {linear[0], linear[1]};
    for (runtime::Image& image : encoded) {
        runtime::encode_srgb(image);
        image = runtime::quantized(image);
    }
    const runtime::Comparison comparison = runtime::compare(encoded[0], encoded[1], kThreshold);
    runtime::Image difference = runtime::difference_image(encoded[0], encoded[1], kThreshold, kGain);
    runtime::decode_srgb(difference);

    const runtime::SheetLayout layout{.columns = 3, .column_labels = {"before", "after", "difference x 8"}};
    const runtime::Image cells[] = {linear[0], linear[1], std::move(difference)};
    runtime::Outcome<runtime::Image> sheet = runtime::contact_sheet(layout, cells);
    runtime::Outcome<std::string> bytes =
        sheet ? runtime::encode_image(wish.output, sheet.value) : runtime::Failure{sheet.error};
    if (!bytes) {
        complain(console, Complaint::CannotRender, {bytes.error});
        return std::nullopt;
    }
    OutputFiles files;
    files.add(wish.output, std::move(bytes.value));
    const std::string inputs[] = {before.path, after.path};
    if (!Outputs(console).write(after.path, files, inputs)) return std::nullopt;
    return PictureChange{.path = wish.output, .share = comparison.share, .largest = comparison.largest};
}

}  // namespace patina::cli
