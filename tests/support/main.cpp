// main() of the programs that have the tests of several files. `build/unit_ir --file ir_fold_test` runs those of one.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace {

// A filter for the tests that are written in the file NAME.cpp; empty: there are none.
std::string tests_of(std::string_view name) {
    std::string filter;
    const testing::UnitTest& all = *testing::UnitTest::GetInstance();
    for (int i = 0; i < all.total_test_suite_count(); ++i) {
        const testing::TestSuite& suite = *all.GetTestSuite(i);
        for (int k = 0; k < suite.total_test_count(); ++k) {
            const testing::TestInfo& test = *suite.GetTestInfo(k);
            if (std::filesystem::path(test.file()).stem() != name) continue;
            if (!filter.empty()) filter += ':';
            filter += std::string(suite.name()) + '.' + test.name();
        }
    }
    return filter;
}

}  // namespace

int main(int count, char** arguments) {
    testing::InitGoogleTest(&count, arguments);
    if (count == 1) return RUN_ALL_TESTS();
    if (count != 3 || std::string_view(arguments[1]) != "--file") {
        std::fprintf(stderr, "usage: %s [--file NAME] [--gtest_...]: NAME is that of a file of tests, without .cpp\n",
                     arguments[0]);
        return 2;
    }
    const std::string filter = tests_of(arguments[2]);
    if (filter.empty()) {
        std::fprintf(stderr, "%s has no test of a file %s.cpp\n", arguments[0], arguments[2]);
        return 2;
    }
    GTEST_FLAG_SET(filter, filter);
    return RUN_ALL_TESTS();
}
