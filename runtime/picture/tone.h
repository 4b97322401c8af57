// From linear light to what a screen shows: exposure, and a curve that brings bright light below 1.
//
//   Image shown = toned(image, {.exposure = -1, .curve = Tonemap::KhronosNeutral});   // still linear
//   if (auto clipped = clipping(shown)) ...   // "with --exposure -0.85 only highlights would clip"
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "runtime/picture/image.h"

namespace patina::runtime {

// None: light above 1 clips.
// KhronosNeutral: Khronos PBR Neutral Tone Mapper, 2024: colours below 0.8 stay as they are, less 0.04.
// Agx: AgX (T. Sobotka, 2022) with B. Wrensch's polynomial for its curve ("Minimal AgX Implementation", 2023).
// Aces: S. Hill's fit of the ACES reference and sRGB output transforms (BakingLab, 2016).
enum class Tonemap { None, KhronosNeutral, Agx, Aces };
struct TonemapWord {
    std::string_view word;
    Tonemap curve;
};
inline constexpr std::array<TonemapWord, 4> kTonemaps = {{{"none", Tonemap::None},
                                                          {"khronos-neutral", Tonemap::KhronosNeutral},
                                                          {"agx", Tonemap::Agx},
                                                          {"aces", Tonemap::Aces}}};

struct Tone {
    std::optional<double> exposure{};  // stops: 1 doubles the light. It comes before the curve. Nothing: 0
    Tonemap curve = Tonemap::None;
};

// Linear light in the primaries of sRGB to linear light.
std::array<float, 3> tone_mapped(Tonemap curve, std::array<float, 3> color);
// Colours; alpha stays.
Image toned(Image linear, const Tone& tone);

// Pixels brighter than white, of those that are not transparent.
struct Clipping {
    double share = 0;  // of all pixels
    // Stops to add, a negative number of two decimals. After them, the share that still clips is less than kUnseen,
    // which nobody sees. It is less than kHighlights if the brightest pixels are more than a stop brighter than all
    // others.
    double exposure = 0;
    double left = 0;  // the share that clips then
};
inline constexpr double kUnseen = 0.001;     // of the pixels
inline constexpr double kHighlights = 0.05;  // of the pixels: as many as highlights may cover
// Nothing if less than kUnseen clips.
std::optional<Clipping> clipping(const Image& linear);

}  // namespace patina::runtime
