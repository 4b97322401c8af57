#include "compiler/base/stable_list.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace patina {
namespace {

TEST(StableList, ElementsNeverMove) {
    StableList<std::string> list;
    std::vector<const std::string*> places;
    for (int i = 0; i < 2000; ++i) places.push_back(&list.emplace_back(std::to_string(i)));
    const StableList<std::string> moved = std::move(list);
    ASSERT_EQ(moved.size(), places.size());
    std::size_t i = 0;
    for (const std::string& each : moved) {
        EXPECT_EQ(&each, places[i]);
        EXPECT_EQ(&moved[i], places[i]);
        EXPECT_EQ(each, std::to_string(i++));
    }
    EXPECT_EQ(i, places.size());
    EXPECT_EQ(moved.front(), "0");
    EXPECT_EQ(moved.back(), "1999");
}

TEST(StableList, HoldsWhatCannotBeCopied) {
    StableList<std::unique_ptr<int>> list;
    for (int i = 0; i < 10; ++i) list.push_back(std::make_unique<int>(i));
    EXPECT_EQ(*list[7], 7);
    EXPECT_EQ(std::next(list.begin(), 10), list.end());
}

TEST(StableList, AnEmptyOneHasNoElement) {
    const StableList<int> list;
    EXPECT_TRUE(list.empty());
    EXPECT_EQ(list.size(), 0u);
    EXPECT_EQ(list.begin(), list.end());
}

}  // namespace
}  // namespace patina
