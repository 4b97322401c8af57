#include "runtime/picture/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace patina::runtime {
namespace {

using Color = std::array<float, 3>;

struct Channel {
    int width = 0, height = 0;
    std::vector<float> values{};
};
using Channels = std::array<Channel, 3>;

// --- colour spaces

// Linear sRGB to CIE XYZ (IEC 61966-2-1), and its inverse; white is the sum of a row.
constexpr float kToXyz[3][3] = {
    {0.4124564f, 0.3575761f, 0.1804375f}, {0.2126729f, 0.7151522f, 0.0721750f}, {0.0193339f, 0.1191920f, 0.9503041f}};
constexpr float kFromXyz[3][3] = {{3.2404542f, -1.5371385f, -0.4985314f},
                                  {-0.9692660f, 1.8760108f, 0.0415560f},
                                  {0.0556434f, -0.2040259f, 1.0572252f}};

// XYZ, with white at 1, 1, 1.
Color xyz_of(const Color& rgb) {
    Color xyz{};
    for (int row = 0; row < 3; row++) {
        const float* m = kToXyz[row];
        xyz[row] = (m[0] * rgb[0] + m[1] * rgb[1] + m[2] * rgb[2]) / (m[0] + m[1] + m[2]);
    }
    return xyz;
}

Color rgb_of(Color xyz) {
    for (int row = 0; row < 3; row++) xyz[row] *= kToXyz[row][0] + kToXyz[row][1] + kToXyz[row][2];
    Color rgb{};
    for (int row = 0; row < 3; row++) {
        const float* m = kFromXyz[row];
        rgb[row] = std::clamp(m[0] * xyz[0] + m[1] * xyz[1] + m[2] * xyz[2], 0.0f, 1.0f);
    }
    return rgb;
}

// Lab without its cube root, so that it can be filtered: achromatic, red-green, blue-yellow.
Color opponent_of(const Color& xyz) {
    return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}
Color xyz_of_opponent(const Color& opponent) {
    const float y = (opponent[0] + 16) / 116;
    return {opponent[1] / 500 + y, y, y - opponent[2] / 200};
}

// CIELAB, with less colour in the dark (the Hunt effect).
Color perceived(const Color& xyz) {
    constexpr float kDelta = 6.0f / 29;
    Color f{};
    for (int c = 0; c < 3; c++)
        f[c] = xyz[c] > kDelta * kDelta * kDelta ? std::cbrt(xyz[c]) : xyz[c] / (3 * kDelta * kDelta) + 4.0f / 29;
    const float lightness = 116 * f[1] - 16;
    return {lightness, 0.01f * lightness * 500 * (f[0] - f[1]), 0.01f * lightness * 200 * (f[1] - f[2])};
}

float hyab(const Color& a, const Color& b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

// --- filters

Channel like(const Channel& channel) {
    return {channel.width, channel.height, std::vector<float>(channel.values.size())};
}

// One row of weights along x, then another along y. Pixels beyond an edge are as those at it.
Channel filtered(const Channel& from, const std::vector<float>& along_x, const std::vector<float>& along_y) {
    const int radius = int(along_x.size() / 2), width = from.width, height = from.height;
    Channel once = like(from), twice = like(from);
    std::vector<float> row(std::size_t(width + 2 * radius));
    for (int y = 0; y < height; y++) {
        const float* in = from.values.data() + std::size_t(y) * width;
        for (int x = 0; x < width + 2 * radius; x++) row[x] = in[std::clamp(x - radius, 0, width - 1)];
        float* out = once.values.data() + std::size_t(y) * width;
        for (int i = 0; i < int(along_x.size()); i++)
            for (int x = 0; x < width; x++) out[x] += along_x[i] * row[x + i];
    }
    for (int y = 0; y < height; y++) {
        float* out = twice.values.data() + std::size_t(y) * width;
        for (int i = 0; i < int(along_y.size()); i++) {
            const float* in = once.values.data() + std::size_t(std::clamp(y + i - radius, 0, height - 1)) * width;
            for (int x = 0; x < width; x++) out[x] += along_y[i] * in[x];
        }
    }
    return twice;
}

// exp(-scale x^2) from -radius to radius.
std::vector<float> gaussian(double scale, int radius) {
    std::vector<float> weights;
    for (int x = -radius; x <= radius; x++) weights.push_back(float(std::exp(-scale * x * x)));
    return weights;
}

double sum_of(const std::vector<float>& weights) {
    double sum = 0;
    for (float weight : weights) sum += weight;
    return sum;
}

// One term of the contrast sensitivity of a channel, as a filter over degrees x: a sqrt(pi / b) exp(-pi^2 x^2 / b).
struct Sensitivity {
    double a, b;
};
constexpr Sensitivity kAchromatic[] = {{1, 0.0047}};
constexpr Sensitivity kRedGreen[] = {{1, 0.0053}};
constexpr Sensitivity kBlueYellow[] = {{34.1, 0.04}, {13.5, 0.025}};
constexpr double kWidest = 0.04;

// What an eye sees of the channel from where the screen is looked at.
Channel seen(const Channel& channel, std::span<const Sensitivity> terms) {
    constexpr double kPi = std::numbers::pi;
    const int radius = int(std::ceil(3 * std::sqrt(kWidest / (2 * kPi * kPi)) * kPixelsPerDegree));
    double total = 0;
    Channel result = like(channel);
    for (const Sensitivity& term : terms) {
        const std::vector<float> row = gaussian(kPi * kPi / (term.b * kPixelsPerDegree * kPixelsPerDegree), radius);
        const double scale = term.a * std::sqrt(kPi / term.b), sum = sum_of(row);
        total += scale * sum * sum;
        const Channel part = filtered(channel, row, row);
        for (std::size_t i = 0; i < part.values.size(); i++) result.values[i] += float(scale) * part.values[i];
    }
    for (float& value : result.values) value /= float(total);
    return result;
}

// Positive weights sum to 1, negative ones to -1.
std::vector<float> balanced(std::vector<float> weights) {
    double positive = 0, negative = 0;
    for (float weight : weights) (weight > 0 ? positive : negative) += std::abs(weight);
    for (float& weight : weights) weight /= float(weight > 0 ? positive : negative);
    return weights;
}

// How strongly each pixel is part of an edge, and of a point or a thin line.
struct Features {
    Channel edges, points;
};
Features features_of(const Channel& luminance) {
    constexpr double kFeatureWidth = 0.082;  // degrees
    const double deviation = 0.5 * kFeatureWidth * kPixelsPerDegree;
    const int radius = int(std::ceil(3 * deviation));
    std::vector<float> across = gaussian(1 / (2 * deviation * deviation), radius), slope = across, bend = across;
    for (int x = -radius; x <= radius; x++) {
        slope[x + radius] *= float(-x);
        bend[x + radius] *= float(x * x / (deviation * deviation) - 1);
    }
    slope = balanced(slope);
    bend = balanced(bend);
    const auto sum = float(sum_of(across));
    for (float& weight : across) weight /= sum;
    const auto strength = [&](const std::vector<float>& along) {
        Channel x = filtered(luminance, along, across);
        const Channel y = filtered(luminance, across, along);
        for (std::size_t i = 0; i < x.values.size(); i++) x.values[i] = std::hypot(x.values[i], y.values[i]);
        return x;
    };
    return {strength(slope), strength(bend)};
}

// --- a picture as it is seen

struct Seen {
    std::vector<Color> colors{};
    Features features{};
};

Seen seen(const Image& encoded) {
    constexpr float kBackground = 0.5f;  // encoded
    const std::size_t count = std::size_t(encoded.width) * encoded.height;
    Channels channels;
    for (Channel& channel : channels) channel = {encoded.width, encoded.height, std::vector<float>(count)};
    Channel luminance = channels[0];
    for (std::size_t i = 0; i < count; i++) {
        const float* pixel = encoded.pixels.data() + 4 * i;
        Color rgb{};
        for (int c = 0; c < 3; c++) {
            const float shown = pixel[c] * pixel[3] + kBackground * (1 - pixel[3]);
            rgb[c] = std::isnan(shown) ? 0 : srgb_decode(std::clamp(shown, 0.0f, 1.0f));
        }
        const Color xyz = xyz_of(rgb), opponent = opponent_of(xyz);
        for (int c = 0; c < 3; c++) channels[c].values[i] = opponent[c];
        luminance.values[i] = xyz[1];
    }
    channels = {seen(channels[0], kAchromatic), seen(channels[1], kRedGreen), seen(channels[2], kBlueYellow)};
    Seen result{.colors = std::vector<Color>(count), .features = features_of(luminance)};
    for (std::size_t i = 0; i < count; i++) {
        const Color opponent{channels[0].values[i], channels[1].values[i], channels[2].values[i]};
        result.colors[i] = perceived(xyz_of(rgb_of(xyz_of_opponent(opponent))));
    }
    return result;
}

// --- errors

// From the distance of two colours: small ones count for more than large ones.
float color_error(float distance) {
    constexpr float kPower = 0.7f, kSplit = 0.4f, kAtSplit = 0.95f;
    static const float kMost = std::pow(hyab(perceived(xyz_of({0, 1, 0})), perceived(xyz_of({0, 0, 1}))), kPower);
    const float error = std::pow(distance, kPower), split = kSplit * kMost;
    if (error < split) return kAtSplit / split * error;
    return std::min(kAtSplit + (error - split) / (kMost - split) * (1 - kAtSplit), 1.0f);
}

}  // namespace

double flip(const Image& a, const Image& b) {
    if (a.pixels == b.pixels || a.pixels.empty()) return 0;
    const Seen p = seen(a), q = seen(b);
    double sum = 0;
    for (std::size_t i = 0; i < p.colors.size(); i++) {
        const float edge = std::abs(p.features.edges.values[i] - q.features.edges.values[i]);
        const float point = std::abs(p.features.points.values[i] - q.features.points.values[i]);
        // A feature that is in one picture only makes a difference of colour larger.
        const float feature = std::sqrt(std::min(std::max(edge, point) / std::numbers::sqrt2_v<float>, 1.0f));
        sum += std::pow(color_error(hyab(p.colors[i], q.colors[i])), 1 - feature);
    }
    return sum / double(p.colors.size());
}

}  // namespace patina::runtime
