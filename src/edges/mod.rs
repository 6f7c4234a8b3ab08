//! Edges of a contact and of its stick zone inside the cells. The resulting areas, outlines and pressures are more accurate than
//! counts of cells.
//!
//! A cell is either in contact or not. The error of the counted area is therefore the length of the edge times a fraction of a
//! cell side. The error of the pressure in the outermost cells is a fraction of this pressure. The values near the edge determine
//! the position of the edge more accurately. At a distance s from a smooth edge the pressure rises and the gap opens as
//!
//! ```math
//! p = K \sqrt{s}, \qquad g = \frac{4 K}{3 E^*}\,s^{3/2}, \qquad\text{so that}\qquad
//! \varphi = \begin{cases} p^2 & \text{inside,} \\ -K^{4/3} \left(\tfrac34 E^* g\right)^{2/3} & \text{outside} \end{cases}
//! ```
//!
//! passes through zero at the edge with the slope $`K^2`$ on both sides. For each cell at the edge, a quadratic is fitted to
//! $`\varphi`$ of the surrounding 7 x 7 cells by weighted least squares. The fit has an additional square term for the cells
//! outside. The cells nearest the edge are excluded because their values are inaccurate. The slope $`K^2`$ at the edge is
//! determined in three rounds. The zero of the quadratic is the edge and determines the covered fraction of the cell. The square
//! root $`\sqrt{\varphi}`$ gives the pressure at the centre and its mean over the cell.
//!
//! The formulas for the edge of the stick zone have the same form. The friction reserve $`\mu p - |q|`$ replaces the pressure,
//! and the slip replaces the gap. The modulus E with $`1/E = \tfrac12 (c_n + c_l \sin^2\theta)`$ replaces $`E^*`$. Here
//! $`\theta`$ is the angle between the traction and the normal of the edge. The coefficients $`c_n = \sum (1-\nu)/G`$ and
//! $`c_l = \sum \nu/G`$ are sums over both bodies. In a history the load may have been reversed.
//! [`History::edges`](crate::History::edges) describes the stick zone of a history.
//!
//! # Validity
//!
//! A fit is rejected in the following cases:
//!
//! - The root mean square of the residual of the fit exceeds 0.05 cells. The limit is 0.02 cells for the stick zone of a history,
//!   and 0.01 cells without any value outside.
//! - The fit contradicts the state of the cell.
//! - The fit has fewer than ten values.
//! - No cell within reach has all its neighbours in the set.
//!
//! A cell whose fit is rejected keeps its raw pressure. Its covered area is reduced by a fraction c of the cell area for each
//! side at the edge. The fraction was measured on circles and rotated ellipses. It is 0.088 with [`CellValue::Uniform`], 0.129
//! with [`CellValue::Centre`], and 0.102 on grids with [`Boundary::Periodic`]. A sharp punch therefore keeps its raw cells.
//! Nearly all cells of a rough contact also keep their raw values if its shortest waves are less than sixteen cells long. If
//! hundreds of cells of such a contact touch, the error of the corrected area is at most 2.5 %. Its mean over seeds is 1 %. The
//! counted area is 4 to 16 % too large. If fifty cells touch, the error of the corrected area can reach 7 %. The page on
//! [accuracy](crate::guide::accuracy#rough-surfaces) lists smaller errors, for three periodic surfaces by number of cells per
//! wave.
//!
//! The tests used 600 ellipses of random shape, angle and position. The pressure error of the fit exceeded the error of the raw
//! cells for two ellipses. Both were three cells across, with 20 and 29 cells in total. The median ratio of the error of the fit
//! to the error of the raw cells was 0.36.
//!
//! For dissimilar bodies the edge of the contact has the same accuracy, 1e-3 of the area. The error of the edge of the stick zone
//! increases with Dundurs' beta. It is 0.6 % for beta up to 0.29, 2 % for beta up to 0.5, and up to 14 % for larger values. For
//! beta of 0.5 or more, between a third and nearly all of the fits of the stick zone are rejected.
//!
//! A test with 200 random cases on 60 x 60 cells gave 360 solutions. The cases were ellipses, quartics, rough spheres and rough
//! planes on free and periodic grids. In seven solutions, an error of the fit exceeded the error of the raw cells by more than a
//! tenth. The compared quantities were the area and the pressure, at the centres and in the mean. These seven solutions were:
//!
//! - Two quartics 13 cells across, each with both cell values. Two thirds of their fits were rejected. The error of the pressure
//!   at the centres was up to 17 % larger.
//! - A periodic plane, with a larger error of the pressure at the centres.
//! - A free plane with 50 cells in contact and with both cell values. The error of the area was larger.
//!
//! # Narrow slip rings
//!
//! A slip ring less than two cells wide provides no values of the slip. Its cells are also at the edge of the contact. In this
//! case the fit is extrapolated from the stick zone. It is rejected if its residual exceeds 0.01 cells. Under spheres and
//! ellipses the squared value is a quadratic, and the fit finds the edge. For a gap proportional to r^4, the fit is rejected and
//! the cells keep their raw values. [`unfitted_fraction`](Edges::unfitted_fraction) of [`TangentialEdges::stick`] reports the
//! fraction of these cells. The table lists relative errors on 32 x 32 cells over three contact radii, averaged over four
//! positions. The first value is the error of the raw cells, and the second value is the error of the fit. The largest traction
//! is compared with the largest exact value at the centre of a cell:
//!
//! | contact, force over mu W | slip ring, cells | traction | largest traction | stick ratio | rejected fits |
//! |---|---|---|---|---|---|
//! | sphere, 0.2 | 0.8 | 5.2e-2, 1.0e-2 | 1.3e-1, 5e-3 | 1.4e-2, 2.2e-3 | 0.23 |
//! | sphere, 0.4 | 1.7 | 2.3e-2, 5.6e-3 | 2.9e-2, 8e-4 | 1.8e-2, 2.0e-3 | 0.18 |
//! | ellipse 2 : 1, 0.4 | 0.8 to 1.7 | 4.5e-2, 1.2e-2 | 4.4e-2, 6e-3 | 1.5e-2, 4.4e-3 | 0.38 |
//! | gap r^4, 0.2 | 0.5 | 7.5e-2, 6.5e-2 | 1.8e-1, 1.8e-1 | 1.4e-2, 1.2e-2 | 0.97 |
//! | gap r^4, 0.4 | 1.0 | 3.7e-2, 3.2e-2 | 2.9e-2, 2.9e-2 | 1.2e-2, 1.0e-2 | 0.98 |
//! | gap r^4, 0.8 | 2.9 | 1.5e-2, 1.2e-2 | 1.8e-3, 1.4e-3 | 1.2e-2, 8.4e-3 | 0.59 |
//!
//! Two other grids were tested with the gap r^4. At 0.4 on 64 x 64 cells, the error of the traction is 6e-3 with the fit and
//! 1.3e-2 for the raw cells. At 0.6 on 40 x 40 cells, the slip ring is about two cells wide. The fit then does not change the
//! mean error of the largest traction, 1.3e-2. It increases the error of the stick ratio by a factor of 1.4.
//!
//! Away from the edge, the means over cells are $`p + \Delta_h p/24`$.
//!
//! The largest traction belongs to the cell nearest the edge of the stick zone. Near this edge $`\mu p`$ decreases by up to a
//! fifteenth from one cell to the next. Consider a sphere at 40 % of the sliding force on 128 x 128 cells, at eight positions.
//! The error of the largest traction is 3e-4 in the mean and at most 9e-4.
//!
//! ```
//! use stickslip::*;
//! let grid = Grid::square(64, 3.0)?;
//! let pair = ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?;
//! let bodies = HalfSpace::new(grid, pair)?.with_cell_value(CellValue::Centre)?;
//! let hertz = analytical::HertzSphere::new(&pair, 1.0, 4.0 / 3.0)?; // of radius 1
//! let (ball, load) = (surface::sphere(grid, 1.0)?, NormalLoad::Force(4.0 / 3.0));
//! let contact = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
//! let edges = contact.edges()?;
//! let exact = hertz.contact_area();
//! assert!((contact.contact_area() / exact - 1.0).abs() > 9e-3); // counted
//! assert!((edges.area() / exact - 1.0).abs() < 6e-4);
//! assert_eq!(edges.unfitted_fraction(), 0.0);
//! // The outline is on the circle to within one or two hundredths of a cell.
//! let radii = edges.outline().iter().flatten().map(|[x, y]| x.hypot(*y));
//! let furthest = radii.map(|r| (r - hertz.contact_radius()).abs()).fold(0.0, f64::max);
//! assert!(furthest < 0.03 * grid.dx());
//! # Ok::<(), Error>(())
//! ```
//!
//! Source: the asymptotics of a smooth edge, K. L. Johnson, Contact Mechanics (1985), sections 5.1 and 4.2. The fraction c
//! replaces the value $`(\pi - 1 + \ln 2)/24`$ of V. A. Yastrebov, G. Anciaux, J.-F. Molinari,
//! <https://doi.org/10.1016/j.triboint.2017.04.023>, which assumes random cells of vanishing size.
//!
//! [`CellValue::Uniform`]: crate::CellValue::Uniform
//! [`CellValue::Centre`]: crate::CellValue::Centre
//! [`Boundary::Periodic`]: crate::Boundary::Periodic

mod fit;
#[cfg(feature = "history")]
mod history;
mod outline;
mod search;
mod spots;
mod states;
mod stencil;
mod tangential;

use crate::bodies::layers::Layer;
use crate::error::{Error, RankFailure, Result};
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::cell_value::CellValue;
use crate::grid::field::Field;
use crate::grid::record::checked_struct;
use crate::normal::NormalSolution;
use crate::support::debug::shown;

use search::{LARGEST_MISS, Search};
pub use tangential::TangentialEdges;

checked_struct! {
    /// Edge of a set of cells (the contact or its stick zone), located inside the cells. The functions [`NormalSolution::edges`],
    /// [`TangentialSolution::edges`](crate::TangentialSolution::edges) and [`History::edges`](crate::History::edges) return this
    /// type.
    #[derive(Clone, PartialEq)]
    pub struct Edges {
        cells: Vec<EdgeCell>,
        centres: Field,
        means: Field,
        outline: Vec<[[f64; 2]; 2]>,
        repeats: [bool; 2],
        area: f64,
    }
    #[serde(remote = "Edges", deny_unknown_fields)]
    check(read) {
        let grid = read.grid();
        read.centres.check("field of centres", grid)?;
        read.means.check("field of means", grid)?;
        let count = grid.cells();
        match read.cells.iter().find(|cell| cell.index >= count) {
            None => Ok(()),
            Some(cell) => Err(Error::Range {
                quantity: "cells",
                start: cell.index,
                end: cell.index.saturating_add(1),
                count,
            }),
        }
    }
}

shown!(Edges: grid(), area(), unfitted_fraction());

/// Cell at the edge of the set. It is a cell of the set with a neighbour outside, or a cell outside that touches the set at a
/// side or a corner.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct EdgeCell {
    /// Index of the cell in the grid, row-major.
    pub index: usize,
    /// Fraction of the cell that the set covers, from zero to one.
    pub covered: f64,
    /// Pressure, or friction reserve, at the centre of the cell (a pressure).
    pub centre: f64,
    /// Mean of the pressure, or of the friction reserve, over the cell (a pressure).
    pub mean: f64,
    /// Whether the edge was fitted. If not, the values are the raw values of the cell.
    pub is_fitted: bool,
}

impl Edges {
    /// Returns the grid of the cells.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.centres.grid()
    }

    /// Returns the cells at the edge, sorted by index.
    #[must_use]
    pub fn cells(&self) -> &[EdgeCell] {
        &self.cells
    }

    /// Returns the values at the centres of all cells (pressures). The values are the pressure for a contact and the friction
    /// reserve for a stick zone. At the edge they are the values of the fit.
    #[must_use]
    pub fn centres(&self) -> &Field {
        &self.centres
    }

    /// Returns the means of the pressure, or of the friction reserve, over the cells (pressures).
    #[must_use]
    pub fn means(&self) -> &Field {
        &self.means
    }

    /// Returns the area of the set, including the covered fractions of the cells at its edge (a length squared).
    #[must_use]
    pub fn area(&self) -> f64 {
        self.area
    }

    /// Returns the edge as straight pieces inside the cells at the edge. Each piece is given by its two end points (lengths). For
    /// cells whose fit was rejected, the pieces are cell sides.
    #[must_use]
    pub fn outline(&self) -> &[[[f64; 2]; 2]] {
        &self.outline
    }

    /// Returns the fraction of the cells at the edge whose fit was rejected, or zero without cells at the edge.
    #[must_use]
    pub fn unfitted_fraction(&self) -> f64 {
        let refused = self.cells.iter().filter(|cell| !cell.is_fitted).count();
        refused as f64 / self.cells.len().max(1) as f64
    }
}

/// Returns the overestimate of the covered area by counting, per side of a cell at the edge. The unit is the area of a cell.
fn excess(boundary: Boundary, cell_value: CellValue) -> f64 {
    match (boundary, cell_value) {
        (Boundary::Periodic, _) => 0.102,
        (_, CellValue::Uniform) => 0.088,
        (_, CellValue::Centre) => 0.129,
    }
}

impl NormalSolution {
    /// Returns the edge of the contact inside the cells, and the pressure at this edge. The documentation of
    /// [`edges`](crate::edges) describes the method.
    ///
    /// # Errors
    /// - [`Error::Memory`] if memory runs out.
    /// - [`Error::Ranks`] for a slab of a grid that is distributed over ranks.
    /// - [`Error::UnsupportedForCoatings`] if an outermost layer is thinner than four cells, or if the bodies are defined by a
    ///   kernel.
    pub fn edges(&self) -> Result<Edges> {
        let grid = self.grid();
        check_whole(grid)?;
        check_resolved(self)?;
        let modulus = self.pair().contact_modulus();
        Search {
            grid,
            repeats: self.boundary().repeats(),
            inside: self.pressure().as_slice(),
            outside: self.gap().as_slice(),
            is_outside_known: &|_| true,
            modulus: &|_, _| modulus,
            excess: excess(self.boundary(), self.cell_value()),
            largest_miss: LARGEST_MISS,
        }
        .edges()
    }
}

/// Smallest thickness of the outermost layer, in cells. On a layer of at least this thickness the pressure falls to
/// zero as on a half-space of the same material.
const THINNEST: f64 = 4.0;

/// Returns an error if the outermost layers are too thin to determine the edges of a contact.
fn check_resolved(normal: &NormalSolution) -> Result<()> {
    if normal.pair().kernel().is_some() {
        let (quantity, remedy) = (
            "the sub-cell edge of a contact",
            "use the areas of the cells",
        );
        normal.pair().check_homogeneous(quantity, remedy)?;
    }
    let grid = normal.grid();
    let bodies = normal.pair().bodies();
    let outermost = bodies.iter().filter_map(|body| body.layers().first());
    let thinnest = outermost
        .map(Layer::thickness)
        .fold(f64::INFINITY, f64::min);
    // The cell side is irrelevant along an axis with a single cell.
    let sides = [(grid.nx(), grid.dx()), (grid.ny(), grid.dy())];
    let sides = sides.into_iter().filter(|(cells, _)| *cells > 1);
    let widest = sides.map(|(_, side)| side).fold(0.0, f64::max);
    if thinnest < THINNEST * widest {
        let quantity = "the sub-cell edge of a contact on layers thinner than four cells";
        let remedy = "use smaller cells, or the areas of the cells";
        normal.pair().check_homogeneous(quantity, remedy)?;
    }
    Ok(())
}

/// Returns an error if the grid is only a slab of a distributed grid.
fn check_whole(grid: Grid) -> Result<()> {
    if grid == grid.whole() {
        Ok(())
    } else {
        Err(Error::Ranks(RankFailure::UnsupportedOnRanks(
            "the edge of a contact",
        )))
    }
}
