// 1,000 random graphs mean the same to GLSL and HLSL on the GPU and to the CPU interpreter. WITNESS_SEED=17 prints and
// runs only that one, WITNESS_SEED=0-2000 runs these.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include "witness/bench.h"
#include "witness/random_graph.h"

namespace patina::witness {
namespace {

constexpr int kMostFailures = 3;

// Multiples of 1 / 64 between -2 and 2: sums and products of two are exact, and ties happen.
Image random_texels(unsigned seed) {
    Image texels = runtime::make_image(kSide, kSide * kLayers);
    unsigned state = seed * 2654435761u + 1;
    for (float& channel : texels.pixels) {
        state = state * 1664525u + 1013904223u;
        channel = static_cast<float>(static_cast<int>(state >> 24) - 128) / 64;
    }
    return texels;
}

struct Tally {
    int compared = 0, skipped = 0;  // channels of pixels
    int failures = 0;
};

class RandomGraphs : public testing::Test {
protected:
    static void SetUpTestSuite() { bench = std::make_unique<Bench>(); }
    static void TearDownTestSuite() { bench.reset(); }
    static inline std::unique_ptr<Bench> bench;

    // How far a witness may be from the CPU's result in double: what rounding to float makes, and what noise makes.
    // Negative: the result is useless, because it is not a number, huge, or all noise.
    static double tolerance(std::size_t i, const Image& exact, const Image& single, const std::vector<Image>& twins,
                            bool uses_half) {
        const double value = static_cast<double>(exact.pixels[i]);
        double spread = 8 * std::abs(static_cast<double>(single.pixels[i]) - value);
        for (const Image& twin : twins)
            spread = std::max(spread, 1.75 * std::abs(static_cast<double>(twin.pixels[i]) - value));
        const double size = std::max(1.0, std::abs(value));
        const double most = uses_half ? 0.1 : 0.02;
        if (!(std::abs(value) < 1e6) || !(spread <= most * size)) return -1;
        return spread + (uses_half ? 5e-3 : 1e-5) * size;
    }

    // A GPU may take numbers below the smallest normal one as 0, and sign() or step() turn that into a difference of 1.
    // So does this run, whose distance from the exact one says how far a drawn value may be off.
    static Image run_as_drawn(const Material& material, const Inputs& inputs) {
#ifdef __SSE2__
        constexpr unsigned kFlushes = 0x8040;  // MXCSR: results (bit 15) and operands (bit 6)
        const unsigned before = _mm_getcsr();
        _mm_setcsr(before | kFlushes);
#endif
        Image image = bench->run(material, Precision::Float, inputs);
#ifdef __SSE2__
        _mm_setcsr(before);
#endif
        return image;
    }

    void compare(unsigned seed, Tally& tally) {
        const RandomGraph graph = random_graph(bench->compiler(), seed);
        const Inputs inputs{.width = kSide, .height = kSide, .data = texture_of(random_texels(seed)), .time = 0.75f};
        const auto material = bench->compile(graph.exact.json, graph.exact.files);
        if (!material) {
            ADD_FAILURE() << "seed " << seed;
            ++tally.failures;
            return;
        }
        const Image exact = bench->run(*material, Precision::Double, inputs);
        const Image single = run_as_drawn(*material, inputs);
        std::vector<Image> twins;
        for (const GraphText& text : graph.twins) {
            const auto twin = bench->compile(text.json, text.files, true);
            if (!twin) {
                ADD_FAILURE() << "a twin of seed " << seed;
                ++tally.failures;
                return;
            }
            twins.push_back(bench->run(*twin, Precision::Double, inputs));
        }
        for (const Target& target : {Target::Glsl, Target::Hlsl}) {
            const Image image = bench->draw(*material, target, inputs);
            ASSERT_EQ(image.pixels.size(), exact.pixels.size());
            for (std::size_t i = 0; i < image.pixels.size(); ++i) {
                const double allowed = tolerance(i, exact, single, twins, graph.uses_half);
                if (allowed < 0) {
                    ++tally.skipped;
                    continue;
                }
                ++tally.compared;
                // Written so that a lone NaN fails.
                const double off =
                    std::abs(static_cast<double>(image.pixels[i]) - static_cast<double>(exact.pixels[i]));
                if (off <= allowed) continue;
                ++tally.failures;
                report(seed, graph, target, i, image, exact, allowed);
                break;
            }
        }
    }

    static std::string text_of(const RandomGraph& graph) {
        std::string text = graph.exact.json;
        for (const auto& [name, file] : graph.exact.files) text += "--- " + name + "\n" + file;
        return text;
    }

    static void report(unsigned seed, const RandomGraph& graph, Target target, std::size_t i, const Image& image,
                       const Image& exact, double allowed) {
        ADD_FAILURE() << "seed " << seed << ": pixel (" << i / 4 % kSide << ", " << i / 4 / kSide << "), channel "
                      << "rgba"[i % 4] << ": " << target.name() << " says " << image.pixels[i] << ", the CPU "
                      << exact.pixels[i] << ", tolerance " << allowed << "\n"
                      << text_of(graph);
    }

    void compare_all(unsigned begin, unsigned end) {
        if (const char* only = std::getenv("WITNESS_SEED")) {
            const char* last = std::strchr(only, '-');
            begin = static_cast<unsigned>(std::atoi(only));
            end = last ? static_cast<unsigned>(std::atoi(last + 1)) + 1 : begin + 1;
            if (!last) std::printf("%s\n", text_of(random_graph(bench->compiler(), begin)).c_str());
        }
        Tally tally;
        for (unsigned seed = begin; seed < end && tally.failures < kMostFailures; ++seed) compare(seed, tally);
        std::printf("compared %d values, skipped %d\n", tally.compared, tally.skipped);
        // Else the graphs prove little.
        EXPECT_GT(tally.compared, 6 * tally.skipped);
        bench->expect_silence();
    }
};

TEST_F(RandomGraphs, Quick) {
    compare_all(0, 50);
}

TEST_F(RandomGraphs, AThousand) {
    compare_all(50, 1050);
}

}  // namespace
}  // namespace patina::witness
