#include "compiler/importers/gltf/own_names.h"

#include <gtest/gtest.h>

#include <vector>

namespace patina::importers::gltf {
namespace {

std::vector<std::string> owned(OwnNames names, const std::vector<std::string>& wanted) {
    std::vector<std::string> made;
    for (const std::string& each : wanted) made.push_back(names.own(each));
    return made;
}

TEST(OwnNames, CountOn) {
    EXPECT_EQ(owned(OwnNames('_'), {"glass", "glass", "Glass", "glass"}),
              (std::vector<std::string>{"glass", "glass_2", "Glass", "glass_3"}));
}

TEST(OwnNames, SomeSystemsDoNotTellCapitals) {
    EXPECT_EQ(owned(OwnNames('-', false), {"glass", "Glass", "GLASS-2", "glass"}),
              (std::vector<std::string>{"glass", "Glass-2", "GLASS-2-2", "glass-3"}));
}

TEST(OwnNames, WhatLooksNumberedIsTaken) {
    EXPECT_EQ(owned(OwnNames('_'), {"glass_2", "glass", "glass", "glass_2"}),
              (std::vector<std::string>{"glass_2", "glass", "glass_3", "glass_2_2"}));
}

// Counting from 2 again for each of them would take minutes.
TEST(OwnNames, ThousandsOfOneNameTakeLinearTime) {
    OwnNames names('-', false);
    std::string last;
    for (int i = 0; i < 200'000; ++i) last = names.own("glass");
    EXPECT_EQ(last, "glass-200000");
}

}  // namespace
}  // namespace patina::importers::gltf
