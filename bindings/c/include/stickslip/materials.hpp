// Materials and coated bodies.

#ifndef STICKSLIP_MATERIALS_HPP
#define STICKSLIP_MATERIALS_HPP

#include <utility>
#include <vector>

#include "core.hpp"

namespace stickslip {

/// Returns a material with the given Young's modulus and Poisson's ratio.
inline Material elastic(double youngs_modulus, double poisson_ratio) { return {youngs_modulus, poisson_ratio, 0.0}; }

/// Body with layers, from the outermost inwards, eight at most.
struct Coated {
    Coated(const Material &of_base, std::vector<Layer> of_layers) : base(of_base), layers(std::move(of_layers)) {}
    Material base;
    std::vector<Layer> layers;
};

} // namespace stickslip

#endif // STICKSLIP_MATERIALS_HPP
