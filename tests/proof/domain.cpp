#include "proof/domain.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/resolve/check_graph.h"

namespace patina::proof {
namespace {

// What a port takes that has no [range], is no [color] and no unit vector.
struct NamedPort {
    std::string_view port;
    std::vector<std::vector<double>> corners;
    std::array<double, 2> box{-64, 64};
    bool only_corners = false;  // nothing between them
};
std::vector<std::vector<double>> numbers(std::initializer_list<double> values) {
    std::vector<std::vector<double>> corners;
    for (const double value : values) corners.push_back({value});
    return corners;
}

const std::vector<NamedPort>& rows() {
    static const std::vector<NamedPort> all = {
        // The middle, the walls and the corners of the default box.
        {"BoxProjectedDirection.position", {{0, 0, 0}, {1, 0, 0}, {-1, 1, 1}}, {-1, 1}},
        {"BoxProjectedDirection.center", {{0, 0, 0}, {0, 0.5, -1}}, {-1, 1}},
        {"BoxProjectedDirection.boxMin", numbers({-1}), {-2, -1}},
        {"BoxProjectedDirection.boxMax", numbers({1}), {1, 2}},
        {"BoxProjectedDirection.nearest", numbers({0, 0.5}), {0, 1}},
        {"BoxProjectedDirection.direction", {{0, 0, 1}, {-1, 0, 0}, {1, 1e-7, 0}, {3, -2, 1}}, {-2, 2}},
        {"DecodeHDR.encoded", {{0, 0, 0, 0}, {1, 1, 1, 0}, {1, 1, 1, 1}, {64, 1, 0, 1}}, {0, 1}},
        // Gamma space, RGBM and plain half floats: factor, exponent of alpha, whether alpha counts.
        {"DecodeHDR.instructions",
         {{1, 1, 0, 0}, {34.493242, 2.2, 0, 1}, {4.59479380, 1, 0, 1}, {1, 0, 0, 1}},
         {},
         true},
        {"DecodeLightmap.encoded", {{0, 0, 0, 0}, {1, 1, 1, 0}, {1, 1, 1, 1}, {64, 1, 0, 1}}, {0, 1}},
        // No fog and the three kinds: density, start, end. Where fog starts and ends at once, it is a wall.
        {"FogFactor.settings",
         {{0, 0.1, 10, 30}, {1, 0, 10, 30}, {1, 0, 5, 5}, {2, 10, 0, 0}, {3, 10, 0, 0}, {3, 0, 0, 0}},
         {},
         true},
        {"LightVector.lightPosition", {{0, 1, 0, 0}, {0, 0, 0, 1}, {5, -2, 3, 1}}, {}, true},
        {"LightVector.position", {{0, 0, 0}, {5, -2, 3}}},
        {"FourPointLights.falloff", numbers({0, 0.25, 1000}), {0, 25}},
        {"MatcapUV.normalVS", {{0, 0, 1}, {0, 0, -1}, {3, 0, 0}, {0.6, 0.8, 1e-4}, {0, 0, 0}}, {0.01, 2}},
        {"NormalReconstructZ.xy", {{0, 0}, {1, 0}, {0.6, -0.8}, {1, 1}, {-3, 2}}, {-1, 1}},
        {"HueRotate.angle", numbers({0, 2, -7})},
        {"CosinePalette.position", numbers({0, 2, -7})},
        {"Dither.pixel", {{0.5, 0.5}, {3.5, 2.5}, {4095.5, 0.5}}, {0, 4096}},
        {"NormalFromHeight.height", numbers({0, 1, -64})},
        {"NormalFromHeight.strength", numbers({0, 0.01, -1}), {0, 1}},
        {"ValueRamp.value0", numbers({0, 1}), {0, 1}},
        {"ValueRamp.value1", numbers({0, 1}), {0, 1}},
        {"ValueRamp.value2", numbers({0, 1}), {0, 1}},
        {"ValueRamp.value3", numbers({0, 1}), {0, 1}},
        {"ValueRamp.value4", numbers({0, 1}), {0, 1}},
        {"ValueRamp.value5", numbers({0, 1}), {0, 1}},
        {"ValueRamp.value6", numbers({0, 1}), {0, 1}},
        {"ValueRamp.value7", numbers({0, 1}), {0, 1}},
        {"TangentFrame.normal", {{0, 0, 1}, {0, -3, 0}, {0.01, 0, 0}}, {0.01, 2}},
        // Not along the normal.
        {"TangentFrame.tangent", {{1, 1, 0, 1}, {0, 1, 1, -1}, {1, 0.5, 2, 1}}, {}, true},
        {"NormalizeFloored.value", {{0, 0, 0}, {1e-12, 0, 0}, {0, -0.03, 0}, {1000, 1, 0}}},
        {"SafeDivide.dividend", numbers({0, 1, -1000}), {-1000, 1000}},
        {"SafeDivide.divisor", numbers({0, -0.0, 1e-35, -1e-20, 1e-6, 1000}), {-1, 1}},
        {"SafeDivide.fallback", numbers({0, 9})},
        {"SafePower.base", numbers({0, -0.0, -2, 1e-35, 0.001, 1, 1000}), {-1, 10}},
        {"SafePower.exponent", numbers({0, 0.5, 1, 2, 8}), {0, 8}},
        {"FiniteOr.value", numbers({0, 1e30, NAN, INFINITY, -INFINITY})},
        {"FiniteOr.fallback", numbers({0, 5})},
    };
    return all;
}

bool has(const nodelang::ParamDecl& param, std::string_view attribute) {
    return std::any_of(param.attributes.begin(), param.attributes.end(),
                       [&](const nodelang::Attribute& a) { return a.name == attribute; });
}

std::size_t components_of(std::string_view type) {
    if (type == "floatN") return 3;
    return std::isdigit(type.back()) ? static_cast<std::size_t>(type.back() - '0') : 1;
}

std::vector<double> widened(std::vector<double> corner, std::size_t components) {
    if (corner.size() == 1) corner.resize(components, corner[0]);
    return corner;
}

PortDomain port_domain(std::string_view node, const nodelang::ParamDecl& param) {
    PortDomain domain{.components = components_of(param.type.name), .corners = {}};
    const std::string name = std::string(node) + "." + std::string(param.name);
    const auto row = std::find_if(rows().begin(), rows().end(), [&](const NamedPort& r) { return r.port == name; });
    const auto add = [&](std::vector<double> corner) {
        domain.corners.push_back(widened(std::move(corner), domain.components));
    };
    if (row != rows().end()) {
        for (const std::vector<double>& corner : row->corners) add(corner);
        domain.box = row->box;
        domain.only_corners = row->only_corners;
    } else if (const auto range = resolve::range_of(param.attributes)) {
        // Both ends, close to the lower one, and zero.
        add({(*range)[0]});
        add({(*range)[1]});
        add({(*range)[0] + 1e-5 * ((*range)[1] - (*range)[0])});
        if ((*range)[0] < 0 && (*range)[1] > 0) add({0});
        domain.box = *range;
    } else if (has(param, "color")) {
        add({0});
        add({1});
        if (domain.components == 3) add({1, 0, 0});
    } else if (param.doc.find("unit ") != std::string_view::npos && domain.components == 3) {
        domain.is_direction = true;
        // Up, down, along the surface, a little above and below it, and between.
        for (const double z : {1.0, -1.0, 0.0, 1e-4, -1e-4, 0.6}) add({std::sqrt(1 - z * z), 0, z});
        add({0, 1, 0});
        // HalfVector is shorter where light and view are opposite.
        if (param.name == "halfVector") add({0});
    } else if (node == "PackSH9" || param.type.name == "float3" || param.type.name == "float4") {
        // Coefficients, colours beyond white, positions: any number.
        add({0});
        add({-64});
        add({64});
        domain.box = {-64, 64};
    } else {
        ADD_FAILURE() << name << " says nothing of what it takes: give it a [range], or a row in this file";
        add({0});
    }
    return domain;
}

std::size_t numbers_of(const std::vector<PortDomain>& ports) {
    std::size_t count = 0;
    for (const PortDomain& port : ports) count += port.numbers();
    return count;
}

}  // namespace

Domain::Domain(std::vector<PortDomain> ports)
    : ports_(std::move(ports)), sequence_(std::max<std::size_t>(1, numbers_of(ports_))), spread_(ports_.size() + 1) {
    for (const PortDomain& port : ports_) {
        inputs_ += port.components;
        combinations_ *= static_cast<double>(port.corners.size());
    }
}

std::size_t Domain::corners(std::size_t most) const {
    return combinations_ > static_cast<double>(most) ? most : static_cast<std::size_t>(combinations_);
}

void Domain::corner(std::size_t index, std::size_t most, double* in) const {
    std::size_t rest = index;
    for (std::size_t p = 0; p < ports_.size(); ++p) {
        const std::size_t count = ports_[p].corners.size();
        std::size_t which = rest % count;
        rest /= count;
        if (combinations_ > static_cast<double>(most))
            which = static_cast<std::size_t>(spread_(index, p) * static_cast<double>(count));
        in = std::copy(ports_[p].corners[which].begin(), ports_[p].corners[which].end(), in);
    }
}

void Domain::point(std::size_t index, double* in) const {
    std::size_t dimension = 0;
    for (const PortDomain& port : ports_) {
        if (port.is_direction) {
            const Direction d = on_sphere(sequence_(index, dimension), sequence_(index, dimension + 1));
            in = std::copy(d.begin(), d.end(), in);
        } else if (port.only_corners) {
            const double at = sequence_(index, dimension) * static_cast<double>(port.corners.size());
            const std::vector<double>& corner = port.corners[static_cast<std::size_t>(at)];
            in = std::copy(corner.begin(), corner.end(), in);
        } else {
            for (std::size_t c = 0; c < port.components; ++c)
                *in++ = port.box[0] + (port.box[1] - port.box[0]) * sequence_(index, dimension + c);
        }
        dimension += port.numbers();
    }
}

Domain domain_of(const nodelang::FunctionDecl& function) {
    std::vector<PortDomain> ports;
    for (const nodelang::ParamDecl& param : function.params) {
        if (!param.is_const && !param.is_out) ports.push_back(port_domain(function.name, param));
    }
    return Domain(std::move(ports));
}

}  // namespace patina::proof
