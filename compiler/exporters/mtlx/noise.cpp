// Noise of MaterialX, which an import has written as files of nodes (compiler/importers/mtlx/noise_code.h): the
// functions are known by their names.
#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/exporters/mtlx/flatten.h"
#include "compiler/exporters/mtlx/node_writer.h"

namespace patina::exporters::mtlx {
namespace {

// The inputs are the function's parameters, in order.
struct Row {
    std::string_view function, category, inputs;
};
constexpr std::string_view kOctaves2 = "texcoord octaves lacunarity diminish",
                           kOctaves3 = "position octaves lacunarity diminish";
constexpr Row kNoises[] = {
    {"MaterialXNoise2D", "noise2d", "texcoord"},
    {"MaterialXNoise2DVector", "noise2d", "texcoord"},
    {"MaterialXNoise3D", "noise3d", "position"},
    {"MaterialXNoise3DVector", "noise3d", "position"},
    {"MaterialXFractal2D", "fractal2d", kOctaves2},
    {"MaterialXFractal2DVector", "fractal2d", kOctaves2},
    {"MaterialXFractal3D", "fractal3d", kOctaves3},
    {"MaterialXFractal3DVector", "fractal3d", kOctaves3},
    {"MaterialXCellNoise2D", "cellnoise2d", "texcoord"},
    {"MaterialXCellNoise3D", "cellnoise3d", "position"},
    {"MaterialXWorleyNoise2D", "worleynoise2d", "texcoord jitter"},
    {"MaterialXWorleyNoise3D", "worleynoise3d", "position jitter"},
};

const Row* row_of(std::string_view function) {
    const auto row = std::find_if(std::begin(kNoises), std::end(kNoises),
                                  [&](const Row& each) { return each.function == function; });
    return row == std::end(kNoises) ? nullptr : row;
}

}  // namespace

bool is_noise(std::string_view function) {
    return row_of(function) != nullptr;
}

std::optional<Ref> NodeWriter::noise(ir::Value value) {
    const Row* const row = row_of(callee(value));
    if (!row) return std::nullopt;
    std::vector<Argument> arguments;
    const auto args = function_.args(value);
    for (const std::string_view name : split(row->inputs, " ")) {
        const ir::Value given = args[arguments.size()];
        Argument made{.name = std::string(name), .value = this->value(given), .type = "float"};
        if (name == "octaves") made.type = "integer";
        if (name == "texcoord" || name == "position") made.type = type_word(function_[given].type.width());
        const auto whole = name == "octaves" ? whole_.find(made.value.name) : whole_.end();
        if (whole != whole_.end()) {
            made.value = whole->second;
        } else if (name == "octaves" && !made.value.is_number()) {
            refuse(value, "a number of octaves that is computed");
            made.value = {.numbers = {3}};
        }
        arguments.push_back(std::move(made));
    }
    current_ = value;
    return node(row->category, type_word(function_[value].type.width()), std::move(arguments));
}

}  // namespace patina::exporters::mtlx
