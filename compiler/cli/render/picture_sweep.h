// `patina render --sweep` and `--lighting`: one picture for each value, or for each pair of values, on a labelled
// sheet.
//
//   Sweep sweep;
//   add_sweep_options(command, sweep);
//   read_sweep(sweep, arguments->request);                   // once the command line is parsed
//   if (!sweep.axes.empty()) outcome = render_sheet(compiler, request, sweep, tone, machine);
#pragma once

#include <string>
#include <vector>

#include "compiler/cli/program.h"
#include "runtime/picture/tone.h"
#include "runtime/render/render_request.h"

namespace patina::cli {

struct SweepAxis {
    std::string name;                 // a property, or "lighting"
    std::vector<std::string> values;  // as --set takes them; models of lighting; none: all models
    bool is_lighting = false;
};

struct Sweep {
    std::vector<std::string> texts{};  // of --sweep
    std::string lighting{};            // of --lighting
    std::vector<SweepAxis> axes{};     // at most two
};

void add_sweep_options(CLI::App& command, Sweep& sweep);
// Finds the axes; a single model goes into the request. Throws the usage error.
void read_sweep(Sweep& sweep, runtime::RenderRequest& request);

// A lighting model that does not fit.
struct LeftOut {
    std::string model, why;
};
// One that makes nothing of some inputs that the graph sets.
struct Partial {
    std::string model;
    std::vector<std::string> inputs;
};

// All pictures on one sheet, with their tone. The outcome's `values` are of all of them.
struct SheetOutcome {
    runtime::RenderOutcome drawn{};
    std::vector<LeftOut> left_out{};  // of all lighting models
    std::vector<Partial> partial{};   // of the models on the sheet, where they have a star
};
// The report about the models: a line for each reason, folded to the width of a terminal.
std::vector<std::string> lines_of(const std::vector<LeftOut>& left_out, const std::vector<Partial>& partial);

SheetOutcome render_sheet(const Compiler& compiler, const runtime::RenderRequest& request, const Sweep& sweep,
                          const runtime::Tone& tone, runtime::RenderMachine& machine);

}  // namespace patina::cli
