// The pass files of the library, changed at random, as a user's own: whatever a file holds, the compiler answers with
// complaints at places or with shaders that other compilers take. A number of the first failure tells which to look at:
//
//   PATINA_FUZZ=1234 build/fuzz_pass_files_test    # prints and compiles that one alone
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>

#include "patina/patina.h"
#include "patina/validate.h"

namespace patina::testing {
namespace {

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t limit) {
    return static_cast<std::size_t>(random()) % limit;
}

std::vector<std::string> library_files() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(PATINA_PASSES)) paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> texts;
    for (const std::filesystem::path& path : paths) {
        std::ifstream file(path);
        std::ostringstream text;
        text << file.rdbuf();
        texts.push_back(text.str());
    }
    return texts;
}

constexpr std::string_view kOperators = " ++ += -= *= /= == != <= >= && || ";

// Words, numbers, quoted words, and every other character alone; comments are left out.
std::vector<std::string> tokens_of(const std::string& text) {
    std::vector<std::string> tokens;
    for (std::size_t at = 0; at < text.size();) {
        const auto is_word = [&](std::size_t i) {
            return std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '_' || text[i] == '.';
        };
        std::size_t end = at + 1;
        if (text.compare(at, 2, "//") == 0) {
            at = std::min(text.find('\n', at), text.size());
            continue;
        }
        if (std::isspace(static_cast<unsigned char>(text[at]))) {
            ++at;
            continue;
        }
        if (text[at] == '"') {
            end = std::min(text.find('"', at + 1), text.size() - 1) + 1;
        } else if (is_word(at)) {
            while (end < text.size() && is_word(end)) ++end;
        } else if (at + 1 < text.size() && kOperators.find(" " + text.substr(at, 2) + " ") != std::string_view::npos) {
            ++end;
        }
        tokens.push_back(text.substr(at, end - at));
        at = end;
    }
    return tokens;
}

std::string joined(const std::vector<std::string>& tokens) {
    std::string text;
    for (const std::string& token : tokens) {
        text += token;
        text += token == ";" || token == "{" || token == "}" ? "\n" : token == "[" || token == "]" ? "" : " ";
    }
    return text;
}

enum class Kind { Quoted, Word, Other };
Kind kind_of(const std::string& token) {
    if (token[0] == '"') return Kind::Quoted;
    return std::isalnum(static_cast<unsigned char>(token[0])) ? Kind::Word : Kind::Other;
}

class Mutator {
public:
    explicit Mutator(std::span<const std::string> files) {
        for (const std::string& file : files) {
            files_.push_back(tokens_of(file));
            for (const std::string& token : files_.back()) pool_.push_back(token);
        }
        for (const char* token : {"0",           "-1",           "1e39",        "float",       "float2",
                                  "int",         "bool",         "half",        "float4x4",    "Texture2D",
                                  "TextureCube", "SamplerState", "Light",       "LightSum",    "LightingSurface",
                                  "void",        "floatN",       "out",         "const",       "ddx",
                                  "Sample",      "uv0",          "vertexColor", "frontFacing", "light",
                                  "time",        "Surface",      "static",      "attribute",   "builtin",
                                  "given",       "node",         "member",      "perObject",   "\"\"",
                                  "\"all\"",     "\"Object\"",   "[",           "[ 3 ]",       "positionOS",
                                  "opaqueColor"}) {
            pool_.push_back(token);
        }
    }

    std::string make(unsigned seed) {
        Random random(seed);
        std::vector<std::string> tokens = files_[below(random, files_.size())];
        for (std::size_t changes = 1 + below(random, 2); changes > 0; --changes) change(tokens, random);
        return joined(tokens);
    }

private:
    using Tokens = std::vector<std::string>;

    static auto at(Tokens& tokens, std::size_t index) { return tokens.begin() + static_cast<std::ptrdiff_t>(index); }

    // Of the same kind, so that the parser is not all that is tried; often of the same file.
    std::string like(const Tokens& tokens, const std::string& token, Random& random) {
        const Tokens& from = below(random, 2) == 0 ? tokens : pool_;
        for (int tries = 0; tries < 1000; ++tries) {
            const std::string& other = from[below(random, from.size())];
            if (kind_of(other) == kind_of(token)) return other;
        }
        return token;
    }

    void change(Tokens& tokens, Random& random) {
        if (tokens.empty()) return;
        const std::size_t place = below(random, tokens.size());
        const std::string old = tokens[place];
        switch (below(random, 12)) {
            case 0: tokens[place] = pool_[below(random, pool_.size())]; break;
            case 1: {  // a piece of any file, anywhere
                Tokens& other = files_[below(random, files_.size())];
                const std::size_t begin = below(random, other.size());
                const std::size_t end = std::min(begin + 1 + below(random, 30), other.size());
                const Tokens piece(at(other, begin), at(other, end));
                tokens.insert(at(tokens, place), piece.begin(), piece.end());
                break;
            }
            case 2: tokens.erase(at(tokens, place)); break;
            case 3:
            case 4: {  // one name for another, everywhere
                const std::string other = like(tokens, old, random);
                if (kind_of(old) != Kind::Other) std::replace(tokens.begin(), tokens.end(), old, other);
                break;
            }
            case 5: statement(tokens, tokens, random); break;
            case 6: statement(tokens, files_[below(random, files_.size())], random); break;
            case 7:
            case 8: attribute(tokens, random); break;
            default:
                for (std::size_t i = place; i < tokens.size(); ++i) {
                    if (kind_of(tokens[i]) == Kind::Other) continue;
                    tokens[i] = like(tokens, tokens[i], random);
                    break;
                }
        }
    }

    // From behind one of `ends` to the next of it, somewhere; nothing if there is none.
    template <class Ends>
    static std::pair<std::size_t, std::size_t> part_of(const Tokens& tokens, Random& random, Ends ends) {
        const auto from = [&](std::size_t i) {
            return static_cast<std::size_t>(
                std::find_if(tokens.begin() + static_cast<std::ptrdiff_t>(i), tokens.end(), ends) - tokens.begin());
        };
        const std::size_t first = from(below(random, tokens.size()));
        if (first == tokens.size()) return {0, 0};
        const std::size_t last = from(first + 1);
        return last == tokens.size() ? std::pair<std::size_t, std::size_t>{0, 0} : std::pair{first + 1, last + 1};
    }

    // Leaves out a statement or declaration, or says one of `other` here.
    static void statement(Tokens& tokens, const Tokens& other, Random& random) {
        const auto ends = [](const std::string& token) { return token == ";" || token == "}" || token == "{"; };
        const auto [begin, end] = part_of(tokens, random, ends);
        const auto [from, to] = part_of(other, random, ends);
        const Tokens copy(other.begin() + static_cast<std::ptrdiff_t>(from),
                          other.begin() + static_cast<std::ptrdiff_t>(to));
        if (below(random, 2) == 0) {
            tokens.erase(at(tokens, begin), at(tokens, end));
        } else {
            tokens.insert(at(tokens, end), copy.begin(), copy.end());
        }
    }

    // Leaves out an attribute, or puts it before another one too.
    void attribute(Tokens& tokens, Random& random) {
        const auto ends = [](const std::string& token) { return token == "]"; };
        Tokens& other = below(random, 2) == 0 ? tokens : files_[below(random, files_.size())];
        const auto [begin, end] = part_of(other, random, ends);
        if (begin == end || other[begin] != "[") return;
        const Tokens copy(at(other, begin), at(other, end));
        if (&other == &tokens && below(random, 2) == 0) tokens.erase(at(tokens, begin), at(tokens, end));
        const auto before = std::find(at(tokens, below(random, tokens.size())), tokens.end(), "[");
        tokens.insert(before, copy.begin(), copy.end());
    }

    std::vector<std::vector<std::string>> files_;
    std::vector<std::string> pool_;
};

constexpr std::string_view kGraph = R"json({
  "patina": 1, "workflow": "metallic-roughness", "lighting": "unity-brdf1", "render": { "surface": "cutout" },
  "properties": [ { "name": "_MainTex", "type": "texture2d", "default": "white" } ],
  "nodes": [ { "id": "albedo", "node": "SampleTexture2D", "in": { "texture": "$_MainTex" } } ],
  "surface": { "baseColor": "albedo.rgb", "alpha": "albedo.a", "emission": "= @vertexColor.rgb" }
})json";
constexpr std::string_view kToon = R"json({
  "patina": 1, "workflow": "metallic-roughness", "lighting": "toon",
  "surface": { "baseColor": "= float3(@uv0, 0)" }
})json";

class PassFiles : public ::testing::Test {
protected:
    // The number of files that were accepted.
    int run(unsigned first, unsigned last) {
        int accepted = 0;
        for (unsigned seed = first; seed < last && !HasFailure(); ++seed) accepted += compiles(seed);
        return accepted;
    }

    bool compiles(unsigned seed) {
        const std::string text = mutator_.make(seed);
        SCOPED_TRACE("file " + std::to_string(seed));
        if (std::getenv("PATINA_FUZZ")) std::cout << text << std::endl;
        CompileOptions options;
        options.request = CompileOptions::Passes{.path = "mine.pass.hlsl"};
        options.keep_programs = true;
        options.files.read = [&](const std::string& path) -> std::optional<std::string> {
            if (path != "mine.pass.hlsl") return {};
            return text;
        };
        const Result result =
            compiler_.compile_text("fuzz.graph.json", std::string(seed % 4 ? kGraph : kToon), options);
        int errors = 0;
        for (const Diagnostic& each : result.diagnostics) {
            EXPECT_GT(each.line, 0) << to_text(each);
            EXPECT_NE(each.code, "internal") << to_text(each);
            errors += each.severity == Severity::Error;
            if (std::getenv("PATINA_FUZZ")) std::cout << to_text(each) << std::endl;
        }
        EXPECT_EQ(result.ok, errors == 0);
        EXPECT_TRUE(result.ok || result.shaders.empty());
        for (const Shader& shader : result.shaders) {
            const Validated validated = validate(shader);
            EXPECT_TRUE(validated.ok) << validated.log << shader.text;
        }
        return result.ok;
    }

    const std::vector<std::string> files_ = library_files();
    Mutator mutator_{files_};
    const Compiler compiler_;
};

// Both outcomes are tried: a test that only ever sees refusals says nothing about shaders.
TEST_F(PassFiles, Quick) {
    if (const char* one = std::getenv("PATINA_FUZZ")) {
        compiles(static_cast<unsigned>(std::atoi(one)));
        return;
    }
    const int accepted = run(0, 200);
    EXPECT_GT(accepted, 20);
    EXPECT_LT(accepted, 180);
}

TEST_F(PassFiles, Thousands) {
    run(200, 5000);
}

}  // namespace
}  // namespace patina::testing
