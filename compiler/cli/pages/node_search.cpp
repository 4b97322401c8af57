#include "compiler/cli/pages/node_search.h"

#include <algorithm>
#include <array>
#include <string>

#include "compiler/base/text.h"
#include "compiler/cli/pages/page.h"
#include "compiler/cli/pages/search_words.h"

namespace patina::cli {
namespace {

// Words for things that have no node of that name, and the nodes to look at, the nearest first. "Sdf*": all that begin
// so.
struct Synonym {
    std::string_view words;
    std::array<std::string_view, 3> names;
};
constexpr Synonym kSynonyms[] = {
    {"distance field", {"Sdf*"}},
    {"stripe", {"SquareWave", "Bricks"}},
    {"line", {"SdfLine", "SquareWave"}},
    {"dots", {"Ellipse", "SdfCircle", "Voronoi"}},
    {"polka", {"Ellipse"}},
    {"grayscale", {"Luminance", "Saturation"}},
    {"gray scale", {"Luminance", "Saturation"}},
    {"black white", {"Luminance", "Saturation"}},
    {"desaturate", {"Saturation"}},
    {"lut", {"SampleTexture3D", "ColorRamp", "SampleCurve"}},
    {"lookup table", {"SampleTexture3D", "ColorRamp", "SampleCurve"}},
    {"color grading", {"WhiteBalance", "SampleTexture3D", "Contrast"}},
    {"pixel", {"Posterize", "Floor"}},
    {"mosaic", {"Posterize", "Voronoi"}},
    {"quantize", {"Posterize", "Round"}},
    {"toon", {"Posterize", "ColorRamp", "Step"}},
    {"cel", {"Posterize", "ColorRamp", "Step"}},
    {"brightness", {"Luminance", "Contrast"}},
    {"gradient", {"ColorRamp", "SampleGradient"}},
    {"rim", {"FresnelEffect"}},
    {"glow", {"FresnelEffect"}},
    {"velvet", {"DistributionCharlie", "FresnelEffect"}},
    {"iridescence", {"FresnelThinFilm", "CosinePalette"}},
    {"iridescent", {"FresnelThinFilm", "CosinePalette"}},
    {"luma", {"Luminance"}},
    {"luminosity", {"Luminance"}},
    {"scroll", {"TilingOffset"}},
    {"pan", {"TilingOffset"}},
    {"panner", {"TilingOffset"}},
    {"turbulence", {"FractalNoise", "CurlNoise"}},
    {"cracks", {"Worley", "Voronoi"}},
    {"glitter", {"Worley", "Random"}},
    {"halftone", {"Ellipse", "Dither"}},
    {"vignette", {"SphereMask"}},
    {"zigzag", {"TriangleWave"}},
    {"sss", {"DisneySubsurface"}},
    {"world position", {"Position"}},
    {"outline", {"SdfOutline", "FresnelEffect"}},
    {"threshold", {"Step", "Smoothstep"}},
    {"random", {"Random", "RandomRange"}},
    {"seamless", {"*Tiled"}},
    {"repeat", {"TilingOffset", "Fraction"}},
    {"detile", {"StochasticTiling", "HexTiling"}},
    {"animate", {"Time"}},
    {"mirror", {"Reflect"}},
    {"blur", {"SampleTexture2DLevel", "SampleTexture2DBias"}},
    {"ripple", {"Sine", "RadialShear"}},
    {"distort", {"Twirl", "Spherize", "WarpedNoise"}},
};

struct Text {
    std::vector<Words> parts;  // a name each, or one text
    int weight;
};

constexpr int kOwnName = 40, kOtherName = 32;
constexpr int kEachWord = 8;  // more for a node that has all words

std::vector<Text> texts_of(const NodeInfo& node) {
    std::string rest = node.doc;
    for (const PortInfo& port : node.ports) {
        rest += " " + port.name + " " + port.doc;
        for (const auto& choice : port.enumerators) rest += " " + choice.name + " " + choice.doc;
    }
    std::vector<Words> others;
    for (const std::string& name : node.also) others.push_back(words_of(name));
    return {{{words_of(node.name)}, kOwnName},
            {std::move(others), kOtherName},
            {{words_of(first_sentence(node.doc))}, 12},
            {{words_of(node.category)}, 8},
            {{words_of(rest)}, 4}};
}

bool has(const std::vector<std::string>& words, const std::string& wanted) {
    return std::find(words.begin(), words.end(), wanted) != words.end();
}

// 2: a name has the whole word, 1: a word of it begins with `wanted`, 0: neither.
int match(const Words& words, const std::string& wanted) {
    if (has(words.single, wanted) || has(words.joined, wanted)) return 2;
    const auto begins = [&](const std::string& word) { return wanted.size() > 2 && word.starts_with(wanted); };
    return std::any_of(words.single.begin(), words.single.end(), begins) ? 1 : 0;
}

// "Sdf*": names that begin so; "*Tiled": that end so.
bool is_named(std::string_view name, std::string_view pattern) {
    if (pattern.starts_with('*')) return name.ends_with(pattern.substr(1));
    if (pattern.ends_with('*')) return name.starts_with(pattern.substr(0, pattern.size() - 1));
    return name == pattern;
}

// The rank of a node among the names of a synonym, from 0; -1 if it is none of them.
int rank_of(const Synonym& synonym, std::string_view node) {
    for (std::size_t i = 0; i < synonym.names.size() && !synonym.names[i].empty(); ++i) {
        if (is_named(node, synonym.names[i])) return static_cast<int>(i);
    }
    return -1;
}

// A query's word, and which of the synonyms whose words are all in the query it belongs to.
struct Wanted {
    std::string word;
    std::vector<const Synonym*> synonyms{};
};

std::vector<Wanted> wanted_by(std::string_view query) {
    const std::vector<std::string> words = search_words(query);
    std::vector<Wanted> wanted;
    for (const std::string& word : words) wanted.push_back({word});
    for (const Synonym& synonym : kSynonyms) {
        const std::vector<std::string> parts = search_words(synonym.words);
        if (!std::all_of(parts.begin(), parts.end(), [&](const std::string& part) { return has(words, part); }))
            continue;
        for (Wanted& each : wanted) {
            if (has(parts, each.word)) each.synonyms.push_back(&synonym);
        }
    }
    return wanted;
}

// The weight of the best text that has the word.
int weight_of(const NodeInfo& node, const std::vector<Text>& texts, const Wanted& wanted) {
    int best = 0;
    for (const Text& text : texts) {
        for (const Words& part : text.parts) best = std::max(best, text.weight * match(part, wanted.word) / 2);
    }
    for (const Synonym* synonym : wanted.synonyms) {
        if (const int rank = rank_of(*synonym, node.name); rank >= 0) best = std::max(best, kOtherName - rank);
    }
    return best;
}

// More for a name that has all the words and little else: "noise" is nearer to ValueNoise than to ValueNoiseTiled.
int weight_of_names(const std::vector<Text>& texts, std::span<const Wanted> wanted) {
    int best = 0;
    for (const Text& text : texts) {
        if (text.weight < kOtherName) continue;
        for (const Words& name : text.parts) {
            if (!std::all_of(wanted.begin(), wanted.end(), [&](const Wanted& w) { return match(name, w.word) == 2; }))
                continue;
            const int size = static_cast<int>(name.single.size()), count = static_cast<int>(wanted.size());
            best = std::max(best, text.weight / 2 * std::min(count, size) / size);
        }
    }
    return best;
}

}  // namespace

const NodeInfo* find_named(std::span<const NodeInfo> nodes, std::string_view name) {
    const std::string wanted = spelled_alike(name);
    const NodeInfo* other = nullptr;
    for (const NodeInfo& node : nodes) {
        if (spelled_alike(node.name) == wanted) return &node;
        const auto is_wanted = [&](const std::string& also) { return spelled_alike(also) == wanted; };
        if (!other && std::any_of(node.also.begin(), node.also.end(), is_wanted)) other = &node;
    }
    return other;
}

std::vector<const NodeInfo*> search_nodes(std::span<const NodeInfo> nodes, std::string_view words) {
    struct Found {
        const NodeInfo* node;
        int weight;
        bool has_all;
    };
    const std::vector<Wanted> wanted = wanted_by(words);
    const std::string whole = spelled_alike(words);
    std::vector<Found> found;
    for (const NodeInfo& node : nodes) {
        const std::vector<Text> texts = texts_of(node);
        Found each{.node = &node, .weight = weight_of_names(texts, wanted), .has_all = true};
        for (const Wanted& word : wanted) {
            const int weight = weight_of(node, texts, word);
            each.weight += weight;
            each.has_all = each.has_all && weight > 0;
        }
        if (each.has_all) each.weight += kEachWord * (static_cast<int>(wanted.size()) - 1);
        if (spelled_alike(node.name) == whole) each.weight += 1000;  // "one minus" is more than a filler and "minus"
        if (each.weight > 0) found.push_back(each);
    }
    std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.weight > b.weight; });
    std::vector<const NodeInfo*> best;
    for (const Found& each : found) {
        if (each.has_all || 2 * each.weight >= found.front().weight) best.push_back(each.node);
    }
    return best;
}

std::vector<Hint> search_hints(std::string_view query, bool by_half) {
    constexpr std::size_t kMost = 3;
    const std::vector<std::string> words = search_words(query);
    std::vector<Hint> found;
    for (const Hint& hint : hints()) {
        const Words name = words_of(hint.name);
        const bool is_most = (by_half ? 2 : 1) * words.size() >= name.single.size() || has(name.joined, words.front());
        const auto is_in_name = [&](const std::string& word) { return match(name, word) == 2; };
        const auto is_same = [&](const Hint& other) { return other.text == hint.text; };
        if (is_most && std::all_of(words.begin(), words.end(), is_in_name) && found.size() < kMost &&
            std::none_of(found.begin(), found.end(), is_same))
            found.push_back(hint);
    }
    return found;
}

}  // namespace patina::cli
