// Results that are kept by their keys: which of them are found again, and which are dropped.
#include "compiler/base/cache.h"

#include <gtest/gtest.h>

namespace patina {
namespace {

TEST(Cache, KeepsTheLastOfEachKey) {
    Cache<int> numbers(1 << 10);
    EXPECT_EQ(numbers.ask("a").value, nullptr);
    numbers.keep("a", 1, 4);
    numbers.keep("a", 2, 4);
    numbers.keep("b", 3, 4);
    ASSERT_NE(numbers.ask("a").value, nullptr);
    EXPECT_EQ(*numbers.ask("a").value, 2);
    EXPECT_EQ(*numbers.ask("b").value, 3);
}

TEST(Cache, SaysWhatIsAskedForAgain) {
    Cache<int> numbers(1 << 10);
    EXPECT_FALSE(numbers.ask("a").is_asked_again);
    EXPECT_FALSE(numbers.ask("b").is_asked_again);
    EXPECT_TRUE(numbers.ask("a").is_asked_again);
    EXPECT_EQ(numbers.ask("a").value, nullptr);
}

TEST(Cache, DropsWhatHasNotBeenUsedForLong) {
    Cache<int> numbers(12'000);  // ten or eleven of 1,000 bytes
    numbers.keep("used", 0, 1000);
    for (int i = 0; i < 100; ++i) {
        numbers.keep("n" + std::to_string(i), i, 1000);
        ASSERT_NE(numbers.ask("used").value, nullptr) << i;
    }
    EXPECT_EQ(numbers.ask("n0").value, nullptr);
    ASSERT_NE(numbers.ask("n99").value, nullptr);
    EXPECT_EQ(*numbers.ask("n99").value, 99);
    for (int i = 0; i < 3; ++i) numbers.keep("large", 1, 100'000);
    EXPECT_EQ(numbers.ask("large").value, nullptr);
    EXPECT_NE(numbers.ask("n99").value, nullptr) << "what is too large to keep drives out nothing";
    int kept = 0;
    for (int i = 0; i < 100; ++i) kept += numbers.ask("n" + std::to_string(i)).value != nullptr;
    EXPECT_LE(kept, 11);
}

// The key takes room, too.
TEST(Cache, CountsKeys) {
    Cache<int> numbers(12'000);
    for (char letter = 'a'; letter <= 'z'; ++letter) numbers.keep(std::string(1000, letter), letter, 0);
    int kept = 0;
    for (char letter = 'a'; letter <= 'z'; ++letter) kept += numbers.ask(std::string(1000, letter)).value != nullptr;
    EXPECT_GE(kept, 5);
    EXPECT_LE(kept, 11);
}

}  // namespace
}  // namespace patina
