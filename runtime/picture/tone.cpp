#include "runtime/picture/tone.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace patina::runtime {
namespace {

using Color = std::array<float, 3>;
using Matrix = std::array<Color, 3>;  // rows

Color times(const Matrix& matrix, const Color& color) {
    Color result{};
    for (std::size_t row = 0; row < 3; row++)
        for (std::size_t i = 0; i < 3; i++) result[row] += matrix[row][i] * color[i];
    return result;
}

template <class Function>
Color each(Color color, Function function) {
    for (float& value : color) value = function(value);
    return color;
}

// github.com/KhronosGroup/ToneMapping, PBR_Neutral, README: F90 is 0.04, what a dielectric reflects at least.
Color khronos_neutral(Color color) {
    constexpr float kStart = 0.8f - 0.04f, kDesaturation = 0.15f;
    const float lowest = std::min({color[0], color[1], color[2]});
    const float offset = lowest < 0.08f ? lowest - 6.25f * lowest * lowest : 0.04f;
    color = each(color, [&](float x) { return x - offset; });
    const float peak = std::max({color[0], color[1], color[2]});
    if (peak < kStart) return color;
    const float room = 1 - kStart, new_peak = 1 - room * room / (peak + room - kStart);
    const float white = 1 - 1 / (kDesaturation * (peak - new_peak) + 1);
    return each(color, [&](float x) { return std::lerp(x * new_peak / peak, new_peak, white); });
}

Color agx(Color color) {
    constexpr Matrix kInset = {{{0.842479062253094f, 0.0784335999999992f, 0.0792237451477643f},
                                {0.0423282422610123f, 0.878468636469772f, 0.0791661274605434f},
                                {0.0423756549057051f, 0.0784336f, 0.879142973793104f}}};
    constexpr Matrix kOutset = {{{1.19687900512017f, -0.0980208811401368f, -0.0990297440797205f},
                                 {-0.0528968517574562f, 1.15190312990417f, -0.0989611768448433f},
                                 {-0.0529716355144438f, -0.0980434501171241f, 1.15107367264116f}}};
    static constexpr float kLowest = -12.47393f, kHighest = 4.026069f;  // stops
    color = each(times(kInset, color), [](float x) {
        const float stops = std::clamp(std::log2(std::max(x, 1e-10f)), kLowest, kHighest);
        const float t = (stops - kLowest) / (kHighest - kLowest);
        return (((((15.5f * t - 40.14f) * t + 31.96f) * t - 6.868f) * t + 0.4298f) * t + 0.1191f) * t - 0.00232f;
    });
    // The result is encoded for a display with exponent 2.2.
    return each(times(kOutset, color), [](float x) { return std::pow(std::max(x, 0.0f), 2.2f); });
}

Color aces(Color color) {
    constexpr Matrix kInput = {
        {{0.59719f, 0.35458f, 0.04823f}, {0.07600f, 0.90834f, 0.01566f}, {0.02840f, 0.13383f, 0.83777f}}};
    constexpr Matrix kOutput = {
        {{1.60475f, -0.53108f, -0.07367f}, {-0.10208f, 1.10813f, -0.00605f}, {-0.00327f, -0.07276f, 1.07602f}}};
    color = each(times(kInput, color), [](float x) {
        return (x * (x + 0.0245786f) - 0.000090537f) / (x * (0.983729f * x + 0.4329510f) + 0.238081f);
    });
    return each(times(kOutput, color), [](float x) { return std::clamp(x, 0.0f, 1.0f); });
}

constexpr float kWhite = 1.005f;  // what rounds to more than 255 of 255 by a step

}  // namespace

Color tone_mapped(Tonemap curve, Color color) {
    switch (curve) {
        case Tonemap::None: return color;
        case Tonemap::KhronosNeutral: return khronos_neutral(color);
        case Tonemap::Agx: return agx(color);
        case Tonemap::Aces: return aces(color);
    }
    return color;
}

Image toned(Image linear, const Tone& tone) {
    const float factor = float(std::exp2(tone.exposure.value_or(0)));
    for (std::size_t i = 0; i < linear.pixels.size(); i += 4) {
        float* pixel = linear.pixels.data() + i;
        const Color made = tone_mapped(tone.curve, {pixel[0] * factor, pixel[1] * factor, pixel[2] * factor});
        std::copy(made.begin(), made.end(), pixel);
    }
    return linear;
}

std::optional<Clipping> clipping(const Image& linear) {
    std::vector<float> peaks;
    for (std::size_t i = 0; i < linear.pixels.size(); i += 4) {
        const float* pixel = linear.pixels.data() + i;
        const float peak = std::max({pixel[0], pixel[1], pixel[2]});
        if (!(peak > kWhite) || !std::isfinite(peak) || !(pixel[3] > 0)) continue;
        peaks.push_back(peak);
    }
    const std::size_t count = linear.pixels.size() / 4;
    if (double(peaks.size()) < kUnseen * double(count) || peaks.empty()) return std::nullopt;
    std::ranges::sort(peaks, std::greater());
    // So many of the brightest pixels clip.
    const auto exposure_leaving = [&](std::size_t left) {
        return left < peaks.size() ? std::floor(-std::log2(double(peaks[left])) * 100) / 100 : 0.0;
    };
    const double for_all = exposure_leaving(std::size_t(std::ceil(kUnseen * double(count))) - 1);
    const double for_most = exposure_leaving(std::size_t(kHighlights * double(count)));
    const double exposure = for_most - for_all > 1 ? for_most : for_all;
    const auto is_left = [&](float peak) { return peak * std::exp2(exposure) > double(kWhite); };
    return Clipping{.share = double(peaks.size()) / double(count),
                    .exposure = exposure,
                    .left = double(std::ranges::count_if(peaks, is_left)) / double(count)};
}

}  // namespace patina::runtime
