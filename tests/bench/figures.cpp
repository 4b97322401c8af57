#include "tests/bench/figures.h"

#include <algorithm>
#include <cstdio>

namespace patina::bench {
namespace {

void row(const std::string& what, double value, const char* unit, double limit) {
    std::printf("%-44s %10.2f %-3s", what.c_str(), value, unit);
    if (limit > 0) std::printf("  at most %g: %s", limit, value <= limit ? "met" : "NOT MET");
    std::printf("\n");
}

}  // namespace

void Figures::ReportRuns(const std::vector<Run>& runs) {
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
        const double ms = run.real_accumulated_time / static_cast<double>(run.iterations) * 1e3;
        const auto [entry, is_new] = best_ms_.emplace(run.run_name.function_name + run.run_name.args, ms);
        if (!is_new) entry->second = std::min(entry->second, ms);
    }
    ConsoleReporter::ReportRuns(runs);
}

double Figures::best_ms(const std::string& benchmark) const {
    const auto found = best_ms_.find(benchmark);
    return found == best_ms_.end() ? 0 : found->second;
}

void Figures::time(const std::string& benchmark, double limit_ms) const {
    if (const double ms = best_ms(benchmark); ms > 0) row(benchmark, ms, "ms", limit_ms);
}

void Figures::ratio(const std::string& shorter, const std::string& longer, double limit) const {
    const double a = best_ms(shorter), b = best_ms(longer);
    if (a > 0 && b > 0) row(longer + " / " + shorter, b / a, "x", limit);
}

void Figures::size(const std::string& what, std::size_t bytes, std::size_t limit) {
    row(what, static_cast<double>(bytes) / 1024, "KB", static_cast<double>(limit) / 1024);
}

int run(int argc, char** argv, void (*register_all)(), void (*print_figures)(const Figures&)) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    register_all();
    Figures figures;
    benchmark::RunSpecifiedBenchmarks(&figures);
    print_figures(figures);
    return 0;
}

}  // namespace patina::bench
