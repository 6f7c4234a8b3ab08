// Materials and pairs of bodies on a grid.

#ifndef STICKSLIP_BODIES_HPP
#define STICKSLIP_BODIES_HPP

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

/// Two elastic half-spaces on a grid.
class HalfSpace {
  public:
    HalfSpace(const Grid &grid, const Material &body_1, const Material &body_2, const Boundary *boundary = nullptr)
        : own_(detail::made<Own>(
              [&](auto **out) { return stickslip_half_space_new(&grid, &body_1, &body_2, boundary, out); })) {}

    HalfSpace(const Grid &grid, const Coated &body_1, const Coated &body_2, const Boundary *boundary = nullptr)
        : own_(detail::made<Own>([&](auto **out) {
              return stickslip_half_space_new_coated(&grid, &body_1.base, body_1.layers.data(), body_1.layers.size(),
                                                     &body_2.base, body_2.layers.data(), body_2.layers.size(), boundary,
                                                     out);
          })) {}

    /// Creates half-spaces whose rows are distributed over ranks; grids and fields contain the local rows.
    HalfSpace(const Grid &grid, const Coated &body_1, const Coated &body_2, const stickslip_ranks &ranks,
              const Boundary *boundary = nullptr)
        : own_(detail::made<Own>([&](auto **out) {
              return stickslip_half_space_new_distributed(
                  &grid, &body_1.base, body_1.layers.data(), body_1.layers.size(), &body_2.base, body_2.layers.data(),
                  body_2.layers.size(), boundary, &ranks, out);
          })) {}

    /// Returns the first local row, as a row number of the whole grid.
    std::size_t first_row() const {
        return detail::asked<std::size_t>([&](auto *out) { return stickslip_half_space_first_row(get(), out); });
    }

    /// Sets the meaning of cell values, STICKSLIP_UNIFORM (default) or STICKSLIP_CENTRE, for objects that are created
    /// afterwards.
    void set_cell_value(std::int32_t value) { check(stickslip_half_space_set_cell_value(get(), value)); }
    std::int32_t cell_value() const {
        return detail::asked<std::int32_t>([&](auto *out) { return stickslip_half_space_cell_value(get(), out); });
    }
    Grid grid() const {
        return detail::asked<Grid>([&](Grid *out) { return stickslip_half_space_grid(get(), out); });
    }
    stickslip_pair pair() const {
        return detail::asked<stickslip_pair>([&](auto *out) { return stickslip_half_space_pair(get(), out); });
    }
    stickslip_half_space *get() const { return own_.get(); }

  private:
    using Own = detail::Owned<stickslip_half_space, stickslip_half_space_free>;
    Own own_;
};

} // namespace stickslip

#endif // STICKSLIP_BODIES_HPP
