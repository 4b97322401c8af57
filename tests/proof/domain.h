// What may arrive at the inputs of a node, as its ports say: a range, a colour, a unit vector; a few ports that say
// less have a row in a table. Used to try every corner of it.
//
//   const Domain domain = domain_of(function);
//   domain.corner(i, in);  domain.point(i, in);
#pragma once

#include <string>
#include <vector>

#include "compiler/nodelang/ast.h"
#include "proof/quadrature.h"

namespace patina::proof {

// Of one input port.
struct PortDomain {
    std::size_t components = 1;
    std::vector<std::vector<double>> corners;  // each with all components
    // Points between the corners: on the unit sphere, in a box, or none.
    bool is_direction = false;
    bool only_corners = false;
    std::array<double, 2> box{0, 1};
    std::size_t numbers() const { return is_direction ? 2 : components; }
};

class Domain {
public:
    explicit Domain(std::vector<PortDomain> ports);

    std::size_t inputs() const { return inputs_; }
    // All combinations of the ports' corners; where there are more than `most`, that many spread evenly among them.
    std::size_t corners(std::size_t most) const;
    void corner(std::size_t index, std::size_t most, double* in) const;
    // Point `index` of a sequence that fills the domain.
    void point(std::size_t index, double* in) const;

private:
    std::vector<PortDomain> ports_;
    std::size_t inputs_ = 0;
    double combinations_ = 1;
    Sequence sequence_, spread_;
};

// Fails the running test where a port's domain is not known.
Domain domain_of(const nodelang::FunctionDecl& function);

}  // namespace patina::proof
