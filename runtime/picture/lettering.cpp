#include "runtime/picture/lettering.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <filesystem>
#include <mutex>

namespace patina::runtime {
namespace {

constexpr int kSmallest = 7;  // pixels of an em that can be read

// Debian, Fedora, Arch, and what an administrator adds.
constexpr const char* kFonts[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                  "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                                  "/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/local/share/fonts/DejaVuSans.ttf"};

std::string font_file() {
    std::error_code ignored;
    for (const char* font : kFonts)
        if (std::filesystem::exists(font, ignored)) return font;
    return {};
}

}  // namespace

Outcome<Lettering> lettering(const std::string& text, int size) {
    static const std::string font = font_file();
    if (font.empty())
        return Failure{"labels need the font DejaVuSans.ttf, which is not installed: install fonts-dejavu-core"};
    if (text.empty()) return Lettering{.width = 0, .height = size * 3 / 2, .coverage = {}};
    // FreeType's face is one for the process.
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    const OIIO::ROI extent = OIIO::ImageBufAlgo::text_size(text, size, font);
    Lettering made{.width = std::max(extent.xend, 1) + 1, .height = size * 3 / 2, .coverage = {}};
    OIIO::ImageBuf drawn(OIIO::ImageSpec(made.width, made.height, 1, OIIO::TypeDesc::FLOAT));
    OIIO::ImageBufAlgo::zero(drawn);
    const float white[] = {1.0f};
    if (!OIIO::ImageBufAlgo::render_text(drawn, 0, size * 9 / 8, text, size, font, white))
        return Failure{"cannot write the label '" + text + "': " + drawn.geterror()};
    made.coverage.resize(std::size_t(made.width) * std::size_t(made.height));
    drawn.get_pixels(OIIO::ROI(0, made.width, 0, made.height, 0, 1, 0, 1), OIIO::TypeDesc::FLOAT, made.coverage.data());
    return made;
}

Outcome<Lettering> lettering_within(std::string text, int size, int width) {
    Outcome<Lettering> made = lettering(text, size);
    if (!made || made.value.width <= width) return made;
    const int height = made.value.height;
    const int smaller = std::max(size * width / made.value.width, std::min(size, kSmallest));
    made = lettering(text, smaller);
    while (made && made.value.width > width && text.size() > 4) {
        text.resize(text.size() - 4);
        text += "...";
        made = lettering(text, smaller);
    }
    // The same line height as its neighbours, so that labels are aligned.
    if (made) {
        made.value.height = height;
        made.value.coverage.resize(std::size_t(made.value.width) * std::size_t(height), 0.0f);
    }
    return made;
}

void put(Image& image, const Lettering& text, int x, int y, const std::array<float, 3>& linear_color) {
    for (int row = std::max(0, -y); row < text.height && y + row < image.height; ++row) {
        for (int column = std::max(0, -x); column < text.width && x + column < image.width; ++column) {
            const std::size_t at = std::size_t(row) * std::size_t(text.width) + std::size_t(column);
            if (at >= text.coverage.size()) return;
            const float share = std::clamp(text.coverage[at], 0.0f, 1.0f);
            const std::span<float> pixel = image.at(x + column, y + row);
            for (std::size_t i = 0; i < 3; ++i) pixel[i] += share * (linear_color[i] - pixel[i]);
            pixel[3] += share * (1 - pixel[3]);
        }
    }
}

}  // namespace patina::runtime
