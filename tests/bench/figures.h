// A reporter that remembers the best time of each benchmark, and prints it next to the compiler's promise. The best
// time counts, because other programs can only add to it.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>

namespace patina::bench {

class Figures : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override;

    // A benchmark's best time, and at most how many milliseconds it should be (0: no promise).
    void time(const std::string& benchmark, double limit_ms) const;
    // How much longer the second benchmark takes than the first.
    void ratio(const std::string& shorter, const std::string& longer, double limit) const;
    static void size(const std::string& what, std::size_t bytes, std::size_t limit);

private:
    double best_ms(const std::string& benchmark) const;

    std::map<std::string, double> best_ms_;
};

// The program: reads the options, runs the benchmarks and prints the table. Returns its exit code.
int run(int argc, char** argv, void (*register_all)(), void (*print_figures)(const Figures&));

}  // namespace patina::bench
