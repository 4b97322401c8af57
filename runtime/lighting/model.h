// Evaluates a lighting model at one point of a surface, in double precision on the CPU: the light that reaches the
// viewer from one light or from a uniform environment. `patina eval --model` and the proofs of the models use it.
//
//   Model model(compiler, {.model = "unity-brdf1", .values = {{"baseColor", "1,0.5,0.2"}, {"metallic", "1"}}});
//   if (model.ok()) model.direct({.l = {0, 0.6, 0.8}, .v = {0, 0, 1}});   // {r, g, b}
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "patina/interpret.h"

namespace patina::runtime {

using Triple = std::array<double, 3>;

struct ModelChoice {
    std::string model;  // "unity-brdf1", or the file of a lighting graph
    std::string workflow = "metallic-roughness";
    // Surface inputs ("roughness"), or properties of the lighting graph ("_Normalization"), in the graph format's value
    // grammar without links: "0.5", "1,0.5,0.2", "#ff8800", "true", "Classic". The rest keeps its defaults.
    std::vector<std::pair<std::string, std::string>> values{};
};

// Directions of the world, of any length but 0: shaded normal, to the light, to the viewer, along the tangent. The
// tangent is at right angles to the normal; the bitangent is cross(n, t).
struct ModelPoint {
    Triple n{0, 0, 1}, l{0, 0, 1}, v{0, 0, 1}, t{1, 0, 0};
};

// What falls in, linear. The light and the ambient irradiance are E/pi, the environment is radiance.
struct ModelLight {
    Triple light{1, 1, 1}, ambient{0, 0, 0}, environment{0, 0, 0};
};

// The numbers of a word: "0.5", "0,0,1", "[[1, 0], [0, .5]]" (brackets and spaces do not matter); nothing if it holds
// anything else, or a number that no double holds.
std::optional<std::vector<double>> read_numbers(const std::string& word);

// What `patina eval` calls them: n, l, v, t, light, ambient, environment.
std::map<std::string, Triple*> named_inputs(ModelPoint& point, ModelLight& light);

class Model {
public:
    Model(const Compiler& compiler, const ModelChoice& choice, Precision precision = Precision::Double);
    ~Model();
    Model(Model&&) noexcept;

    bool ok() const;  // false: only diagnostics() may be asked
    const std::vector<Diagnostic>& diagnostics() const;

    // Radiance to the viewer. For a light of colour 1 this is pi times the BRDF times n.l.
    Triple direct(const ModelPoint& point);
    Triple color(const ModelPoint& point, const ModelLight& light);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace patina::runtime
