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
    Coated(const Material &base, std::vector<Layer> layers) : base(base), layers(std::move(layers)) {}
    Material base;
    std::vector<Layer> layers;
};

} // namespace stickslip

#endif // STICKSLIP_MATERIALS_HPP
