// Lighting models written a second time, as plain C++ from the papers: what the graphs of nodes/lighting must equal.
// Uses nothing of the compiler and nothing of the node library; of the runtime the table of the split sum.
//
//   for (const ClosedModel& model : closed_models()) model.direct(surface, directions);
#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace patina::proof {

using Color = std::array<double, 3>;
using Vector = std::array<double, 3>;

// A point of a surface in the metallic workflow, and what follows from it.
struct Surface {
    Color base{0.5, 0.5, 0.5};
    double metallic = 0, roughness = 0.5, occlusion = 1;
    // A model's own inputs, by name.
    std::map<std::string, Color> own{};

    double number(const std::string& name) const { return own.at(name)[0]; }
    Color f0() const;  // 0.04 of an insulator, the base colour of a metal
    Color diffuse_color() const;
    double one_minus_reflectivity() const;
};

// All unit vectors; the bitangent is cross(n, t).
struct Directions {
    Vector n{}, l{}, v{}, t{};
};

struct ClosedModel {
    std::string name;
    // Which of the model's variants this is: words for the properties of its graph.
    std::vector<std::pair<std::string, std::string>> variant{};
    // The model's own inputs with their ranges; three numbers for a colour.
    struct Own {
        std::string name;
        bool is_color = false;
        double low = 0, high = 1;
    };
    std::vector<Own> own{};
    // For a light of E/pi = 1.
    Color (*direct)(const Surface&, const Directions&) = nullptr;
    // For an ambient irradiance of E/pi = 1 and an environment of radiance 0, and the other way round. Null: not given.
    Color (*ambient)(const Surface&, const Directions&) = nullptr;
    Color (*environment)(const Surface&, const Directions&) = nullptr;
};

const std::vector<ClosedModel>& closed_models();

}  // namespace patina::proof
