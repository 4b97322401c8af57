// The differences of texts. How few they can be is known from the longest common subsequence, found the slow way.
#include "patina/text_diff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace patina::runtime {
namespace {

using Kind = DiffLine::Kind;

std::string shown(const std::vector<DiffLine>& diff) {
    std::string text;
    for (const DiffLine& line : diff) {
        text += " -+~"[static_cast<int>(line.kind)];
        text += line.text + "\n";
    }
    return text;
}

TEST(TextDiff, EqualTextsHaveNone) {
    EXPECT_TRUE(differences("a\nb\n", "a\nb\n").empty());
    EXPECT_TRUE(differences("", "").empty());
}

TEST(TextDiff, ShowsTheLinesAround) {
    EXPECT_EQ(shown(differences("1\n2\n3\n4\n5\n6\n7\n8\n9\n", "1\n2\n3\n4\nfive\n6\n7\n8\n9\n")),
              "~\n 2\n 3\n 4\n-5\n+five\n 6\n 7\n 8\n~\n");
    const std::vector<DiffLine> diff = differences("a\nb\nc\n", "b\nc\nd\n");
    EXPECT_EQ(shown(diff), "-a\n b\n c\n+d\n");
    EXPECT_EQ(changed_lines(diff), 2u);
    EXPECT_EQ(diff[1].old_line, 2);
    EXPECT_EQ(diff[1].new_line, 1);
    EXPECT_EQ(diff[3].new_line, 3);
}

TEST(TextDiff, OneTextIsEmpty) {
    EXPECT_EQ(shown(differences("", "a\nb")), "+a\n+b\n");
    EXPECT_EQ(shown(differences("a\n", "")), "-a\n");
}

std::size_t longest_common(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> best(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 1; i <= a.size(); i++)
        for (std::size_t j = 1; j <= b.size(); j++)
            best[i][j] = a[i - 1] == b[j - 1] ? best[i - 1][j - 1] + 1 : std::max(best[i - 1][j], best[i][j - 1]);
    return best[a.size()][b.size()];
}

TEST(TextDiff, IsTheShortestThatMakesOneOfTheOther) {
    std::mt19937 random(7);
    const auto any_text = [&] {
        std::string letters(std::uniform_int_distribution<std::size_t>(0, 12)(random), ' ');
        for (char& c : letters) c = char('a' + std::uniform_int_distribution<int>(0, 3)(random));
        return letters;
    };
    const auto lines = [](const std::string& letters) {
        std::string text;
        for (char c : letters) text += std::string(1, c) + "\n";
        return text;
    };
    for (int round = 0; round < 3000; round++) {
        const std::string a = any_text(), b = any_text();
        const std::vector<DiffLine> diff = differences(lines(a), lines(b));
        EXPECT_EQ(changed_lines(diff), a.size() + b.size() - 2 * longest_common(a, b)) << a << " " << b;
        // Lines that are left out are equal, so each text is what is shown of it with these.
        std::string made;
        for (std::size_t i = 0; i < diff.size(); i++) {
            if (diff[i].kind == Kind::Gap) {
                const std::size_t end = i + 1 < diff.size() ? std::size_t(diff[i + 1].new_line - 1) : b.size();
                if (i + 1 < diff.size() && diff[i + 1].kind != Kind::Same) continue;
                made += b.substr(made.size(), end - made.size());
            } else if (diff[i].kind != Kind::Removed) {
                made += diff[i].text;
            }
        }
        if (!diff.empty()) {
            EXPECT_EQ(made, b) << "from " << a;
        }
    }
}

TEST(TextDiff, TextsOfVeryManyDifferencesAreAsQuick) {
    std::string a, b;
    for (int i = 0; i < 5000; i++) {
        a += std::to_string(i) + "\n";
        b += std::to_string(-i - 1) + "\n";
    }
    EXPECT_EQ(changed_lines(differences(a, b)), 10000u);
}

}  // namespace
}  // namespace patina::runtime
