// Inputs that no author would write, made at random from ones that are: whatever they hold, nothing crashes, and each
// is accepted or refused with a message that says where. A kind of input is a row of a table: how inputs are made, and
// what must hold of each.
//
//   Fuzzer fuzzer = kind.open(setup);
//   Random random(1234);
//   const Input input = fuzzer.make(random);
//   const Verdict verdict = fuzzer.run(input, random);   // verdict.wrong: what is wrong; empty: nothing
#pragma once

#include <filesystem>
#include <functional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "patina/patina.h"

namespace patina::fuzz {

using Random = std::mt19937;
std::size_t below(Random& random, std::size_t limit);
// True once in `count`.
bool one_in(std::size_t count, Random& random);

struct Verdict {
    bool is_accepted = false;
    std::string wrong{};  // empty: nothing
    std::string said{};   // why it is refused, for those who look at one input
};

struct Input {
    std::string bytes;
    std::string path{};  // of the seed, for files that it names; empty: none
};

struct Fuzzer {
    std::function<Input(Random&)> make;
    std::function<Verdict(const Input& input, Random&)> run;
};

struct Setup {
    std::filesystem::path scratch;  // a folder of this process
    std::filesystem::path seeds;    // a folder of the user's; empty: the project's own seeds
};

struct InputKind {
    std::string_view name, what;
    unsigned quick;  // how many inputs take a second in a release build
    Fuzzer (*open)(const Setup& setup);
};
std::vector<InputKind> text_kinds(), picture_kinds(), model_kinds();

// --- seeds
using Seed = Input;
// The files of the user's folder, or of these folders of the project, that end so and have at most `most` bytes; in
// the order of their paths.
std::vector<Seed> seeds_in(const Setup& setup, std::span<const std::string_view> folders, std::string_view ending,
                           std::size_t most = 1 << 16);
std::string read_file(const std::filesystem::path& path);
void write_file(const std::filesystem::path& path, std::string_view bytes);

// --- changes
// Bits, bytes, numbers of several bytes, and pieces: of files that are no text. Often near the begin.
std::string changed_bytes(std::string bytes, std::string_view other, Random& random);
// Characters, numbers and lines: most of what a line holds keeps its form.
std::string changed_lines(std::string text, std::string_view other, Random& random);
// Words, quoted words, numbers and statements of texts in the node language or in JSON.
class TokenChanges {
public:
    TokenChanges(std::span<const Seed> seeds, std::span<const std::string_view> words);
    std::string make(std::size_t seed, Random& random) const;
    std::string make(Random& random) const { return make(below(random, files_.size()), random); }

private:
    using Tokens = std::vector<std::string>;
    std::string like(const Tokens& tokens, const std::string& token, Random& random) const;
    void change(Tokens& tokens, Random& random) const;
    void attribute(Tokens& tokens, Random& random) const;

    std::vector<Tokens> files_;
    Tokens pool_;
};
// One of the seeds, changed in one of the ways for texts; sometimes cut off, as an editor saves it.
Input changed_text(std::span<const Seed> seeds, const TokenChanges& tokens, Random& random);

// --- what must hold of messages
// Prints them in every form. What is wrong with them; empty: nothing. `must_have_line`: errors have a line, too.
std::string wrong_with(std::span<const Diagnostic> diagnostics, bool is_ok, bool must_have_line = true);
std::string first_error(std::span<const Diagnostic> diagnostics);
// The library, which is loaded once.
const Compiler& compiler();

}  // namespace patina::fuzz
