// A function of the node language made ready to run millions of times: emitted once, not folded, and executed by the
// interpreter four points at a time. The proofs in this folder integrate, maximise and compare it.
//
//   Term ggx = Term::of("float f(float c, float alpha) { return DistributionGGX(c, alpha) * c; }");
//   ggx({0.9, 0.25});                                                    // one value
//   ggx.each(count, [&](std::size_t i, double* in) { in[0] = c[i]; ... },  // many
//            [&](std::size_t i, const double* out) { sum += out[0] * w[i]; });
//
// Not here: whole materials and pictures (tests/witness).
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "compiler/interpret/machine.h"
#include "compiler/resolve/library.h"

namespace patina::proof {

// The built-in library, loaded once.
const resolve::Library& library();

// How a term is computed.
struct Arithmetic {
    Precision precision = Precision::Double;
    bool half = false;  // a call in half precision: `float` means half inside, inputs and outputs are converted
};

class Term {
public:
    // A function over the library, as text. Its parameters are the inputs, component by component.
    static Term of(const std::string& text, Arithmetic arithmetic = {});
    // A function of the library. `constants`: the text of each const parameter that is not left at its default.
    // floatN is taken as float3.
    static Term node(const nodelang::FunctionDecl& function, const std::map<std::string, std::string>& constants,
                     Arithmetic arithmetic = {});

    std::size_t inputs() const { return machine_.argument_types.size(); }
    std::size_t outputs() const { return machine_.output.count; }
    // True if it reads a texture or a value of the engine.
    bool reads_globals() const { return reads_globals_; }

    // All outputs at one point; the first alone.
    std::vector<double> at(const std::vector<double>& arguments);
    double operator()(const std::vector<double>& arguments) { return at(arguments)[0]; }

    // Runs `count` points: point(i, in) fills in the inputs, value(i, out) looks at the outputs. i is ascending.
    template <class Point, class Value>
    void each(std::size_t count, Point&& point, Value&& value) {
        std::vector<double> in(inputs() * interpret::kLanes), out(outputs());
        for (std::size_t first = 0; first < count; first += interpret::kLanes) {
            const std::size_t lanes = std::min<std::size_t>(interpret::kLanes, count - first);
            for (unsigned lane = 0; lane < lanes; ++lane) {
                point(first + lane, in.data());
                for (std::size_t c = 0; c < inputs(); ++c) machine_.set_argument(c, lane, in[c]);
            }
            interpret::execute(machine_);
            for (unsigned lane = 0; lane < lanes; ++lane) {
                for (std::size_t c = 0; c < out.size(); ++c) out[c] = machine_.result(c, lane);
                value(first + lane, out.data());
            }
        }
    }

private:
    Term(const nodelang::FunctionDecl& function, const nodelang::Declarations& declarations,
         const std::map<std::string, std::string>& constants, Arithmetic arithmetic);
    interpret::Machine machine_;
    bool reads_globals_ = false;
};

}  // namespace patina::proof
