//! The edge of a contact and of its stick zone inside the cells: areas, outlines and pressures more accurate than a count.
//!
//! A cell is in contact or it is not, so that a counted area is wrong by the edge of the contact times a part of a cell, and
//! the pressure of the outermost cells by a part of itself. The edge is better known than that: at a distance s from a smooth
//! one the pressure rises and the gap opens as
//!
//! ```math
//! p = K \sqrt{s}, \qquad g = \frac{4 K}{3 E^*}\,s^{3/2}, \qquad\text{so that}\qquad
//! \varphi = \begin{cases} p^2 & \text{inside,} \\ -K^{4/3} \left(\tfrac34 E^* g\right)^{2/3} & \text{outside} \end{cases}
//! ```
//!
//! passes through zero at the edge with the slope $`K^2`$ on both sides. About each cell at the edge a quadratic, and a
//! square of its own outside, is fitted to $`\varphi`$ of the 7 x 7 cells around it by weighted least squares, without those
//! nearest the edge, whose values are wrong; $`K^2`$ is its slope at the edge, found in three rounds. Its zero is the edge:
//! it gives the part of the cell that is covered, and $`\sqrt{\varphi}`$ the pressure at the centre and its mean over the cell.
//!
//! The stick zone has the same edge, with what friction could still bear, $`\mu p - |q|`$, in place of the pressure, the slip
//! in place of the gap, and the modulus $`1/E = \tfrac12 (c_n + c_l \sin^2\theta)`$ in place of $`E^*`$, $`\theta`$ between
//! the traction and the normal of the edge, $`c_n = \sum (1-\nu)/G`$ and $`c_l = \sum \nu/G`$ of both bodies. That of a
//! history, which may have turned, is told at [`History::edges`](crate::History::edges).
//!
//! # Where it holds
//!
//! A fit is refused if it misses the values by more than 0.05 cells (root mean square; 0.02 for the stick zone of a
//! history, and 0.01 without any value outside), contradicts the state of the cell, has fewer than ten values to go by, or no cell within reach that has all its neighbours in the set. The cell then has
//! its own pressure, and counts as covered but for a part c of its area for each side at the edge: 0.088 with
//! [`CellValue::Uniform`], 0.129 with [`CellValue::Centre`], 0.102 on grids with [`Boundary::Periodic`], measured on circles
//! and turned ellipses. So a sharp punch keeps its raw cells, and a rough contact whose shortest waves are less than sixteen
//! cells long nearly all of them; the corrected area is still right to 2.5 % there if hundreds of cells touch (mean over seeds: 1 %), where counting reads 4 to
//! 16 % high; of fifty cells it may miss by 7 %.
//! Of 600 ellipses of any shape, angle and place two had a worse pressure than that of the cells, three cells across and
//! with 20 and 29 of them in all; the median ratio of the errors was 0.36.
//!
//! Of dissimilar bodies the edge of the contact holds as well, to 1e-3 of the area; that of the stick zone to 0.6 % up to
//! Dundurs' beta 0.29, to 2 % up to 0.5, and beyond only to 14 %: from 0.5 up a third to nearly all of its fits are refused.
//!
//! Of 200 random scenes on 60 x 60 cells, ellipses, quartics, rough spheres and rough planes, free and periodic, in 360
//! solutions, seven had an area, a pressure at the centres or means with an error by more than a tenth above that of the cells:
//! two quartics 13 cells across whose fits were refused in two thirds (pressure at the centres up to 17 % worse, each with both
//! cell values), a periodic plane (likewise), and a free plane with 50 cells in contact (area, both).
//!
//! # Narrow slip rings
//!
//! A slip ring of less than two cells has no slip to go by: its cells lie at the edge of the contact too. The fit is then
//! extrapolated from the stick zone, and is refused if it misses by more than 0.01 cells. Under spheres and ellipses the
//! squared value is a quadratic, and the edge is found. Under a gap r^4 the cells keep their values.
//! [`unfitted_fraction`](Edges::unfitted_fraction) of [`TangentialEdges::stick`] reports this. The table lists errors on 32 x 32
//! cells over three contact radii, mean of four places, of the cells and found here:
//!
//! | contact, force over mu W | slip ring, cells | traction | largest traction | stick area | refused |
//! |---|---|---|---|---|---|
//! | sphere, 0.2 | 0.8 | 5.2e-2, 1.0e-2 | 1.3e-1, 5e-3 | 1.4e-2, 2.2e-3 | 0.23 |
//! | sphere, 0.4 | 1.7 | 2.3e-2, 5.6e-3 | 2.9e-2, 8e-4 | 1.8e-2, 2.0e-3 | 0.18 |
//! | ellipse 2 : 1, 0.4 | 0.8 to 1.7 | 4.5e-2, 1.2e-2 | 4.4e-2, 6e-3 | 1.5e-2, 4.4e-3 | 0.38 |
//! | gap r^4, 0.2 | 0.5 | 7.5e-2, 6.5e-2 | 1.8e-1, 1.8e-1 | 1.4e-2, 1.2e-2 | 0.97 |
//! | gap r^4, 0.4 | 1.0 | 3.7e-2, 3.2e-2 | 2.9e-2, 2.9e-2 | 1.2e-2, 1.0e-2 | 0.98 |
//! | gap r^4, 0.8 | 2.9 | 1.5e-2, 1.2e-2 | 1.8e-3, 1.4e-3 | 1.2e-2, 8.4e-3 | 0.59 |
//!
//! On 64 x 64 cells the traction of the gap r^4 at 0.4 has 6e-3 instead of 1.3e-2. In a ring of about two cells under this
//! gap (40 x 40 cells, 0.6) the largest traction is 1.4 times, and the stick area 1.7 times, as wrong as that of the cells.
//!
//! The means over cells other than those at the edge are $`p + \Delta_h p/24`$.
//!
//! The largest traction is that of the cell nearest the edge of the stick zone, where $`\mu p`$ falls by up to a fifteenth
//! from a cell to the next: on a sphere at 40 % of the sliding force, 128 x 128 cells, it is right to 3e-4 on the mean of
//! eight places and to 9e-4 at the worst.
//!
//! ```
//! use stickslip::*;
//! let grid = Grid::square(64, 3.0)?;
//! let pair = ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?;
//! let bodies = HalfSpace::new(grid, pair)?.with_cell_value(CellValue::Centre)?;
//! let hertz = analytical::HertzSphere::new(&pair, 1.0, 4.0 / 3.0)?; // of radius 1
//! let (ball, load) = (surface::sphere(grid, 1.0)?, NormalControl::Force(4.0 / 3.0));
//! let contact = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
//! let edges = contact.edges()?;
//! let exact = hertz.contact_area();
//! assert!((contact.contact_area() / exact - 1.0).abs() > 9e-3); // counted
//! assert!((edges.area() / exact - 1.0).abs() < 6e-4);
//! assert_eq!(edges.unfitted_fraction(), 0.0);
//! // The outline lies on the circle, to a hundredth of a cell or two.
//! let radii = edges.outline().iter().flatten().map(|[x, y]| x.hypot(*y));
//! let furthest = radii.map(|r| (r - hertz.contact_radius()).abs()).fold(0.0, f64::max);
//! assert!(furthest < 0.03 * grid.dx());
//! # Ok::<(), Error>(())
//! ```
//!
//! Source: the asymptotics of a smooth edge, K. L. Johnson, Contact Mechanics (1985), sections 5.1 and 4.2; the part c in
//! place of the $`(\pi - 1 + \ln 2)/24`$ of V. A. Yastrebov, G. Anciaux, J.-F. Molinari,
//! <https://doi.org/10.1016/j.triboint.2017.04.023>, which assumes random cells of no size.
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
use crate::normal::NormalSolution;
use crate::support::debug::shown;

use search::{LARGEST_MISS, Search};
pub use tangential::TangentialEdges;

/// The edge of a set of cells, the contact or its stick zone, found inside the cells. Obtained from
/// [`NormalSolution::edges`], [`TangentialSolution::edges`](crate::TangentialSolution::edges) and
/// [`History::edges`](crate::History::edges).
#[derive(Clone, PartialEq)]
pub struct Edges {
    cells: Vec<EdgeCell>,
    centres: Field,
    means: Field,
    outline: Vec<[[f64; 2]; 2]>,
    repeats: [bool; 2],
    area: f64,
}

shown!(Edges: grid(), area(), unfitted_fraction());

/// A cell at the edge: one of the set with a neighbour outside, or one outside beside the set, at its corners too.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct EdgeCell {
    /// Its index in the grid, row-major.
    pub index: usize,
    /// The part of it that the set covers, from zero to one.
    pub covered: f64,
    /// The pressure, or what friction could still bear, at its centre (a pressure).
    pub centre: f64,
    /// The mean of the same over the cell (a pressure).
    pub mean: f64,
    /// Whether the edge was fitted; else these are those of the raw cell.
    pub is_fitted: bool,
}

impl Edges {
    /// The grid of the cells.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.centres.grid()
    }

    /// The cells at the edge, by rising index.
    #[must_use]
    pub fn cells(&self) -> &[EdgeCell] {
        &self.cells
    }

    /// Values at the centres of all cells: of a contact the pressure, of a stick zone what friction could still bear
    /// (pressures); those at the edge from the fit.
    #[must_use]
    pub fn centres(&self) -> &Field {
        &self.centres
    }

    /// Means of the same over the cells.
    #[must_use]
    pub fn means(&self) -> &Field {
        &self.means
    }

    /// Area of the set, with the parts of the cells at its edge (a length squared).
    #[must_use]
    pub fn area(&self) -> f64 {
        self.area
    }

    /// The edge as straight pieces, each from one point to the other (lengths), inside the cells at the edge; of cells whose
    /// fit was refused the sides.
    #[must_use]
    pub fn outline(&self) -> &[[[f64; 2]; 2]] {
        &self.outline
    }

    /// The part of the cells at the edge whose fit was refused; zero without any.
    #[must_use]
    pub fn unfitted_fraction(&self) -> f64 {
        let refused = self.cells.iter().filter(|cell| !cell.is_fitted).count();
        refused as f64 / self.cells.len().max(1) as f64
    }
}

/// The part of a cell that counting it takes too much for each of its sides at the edge.
fn excess(boundary: Boundary, cell_value: CellValue) -> f64 {
    match (boundary, cell_value) {
        (Boundary::Periodic, _) => 0.102,
        (_, CellValue::Uniform) => 0.088,
        (_, CellValue::Centre) => 0.129,
    }
}

impl NormalSolution {
    /// The edge of the contact inside the cells, and the pressure there; the page of [`edges`](crate::edges) tells how.
    ///
    /// # Errors
    /// [`Error::Memory`]; [`Error::Ranks`] for a slab of a grid that ranks share; [`Error::UnsupportedForCoatings`] where an outermost
    /// layer is thinner than four cells.
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

/// Cells that the outermost layer is thick at least: in it the pressure falls to zero as on a half-space of it.
const THINNEST: f64 = 4.0;

/// `Ok` if the edges of a contact are those of its outermost layers.
fn check_resolved(normal: &NormalSolution) -> Result<()> {
    if normal.pair().kernel().is_some() {
        let (quantity, remedy) = ("an edge inside the cells", "take the areas of the cells");
        normal.pair().check_homogeneous(quantity, remedy)?;
    }
    let grid = normal.grid();
    let bodies = normal.pair().bodies();
    let outermost = bodies.iter().filter_map(|body| body.layers().first());
    let thinnest = outermost
        .map(Layer::thickness)
        .fold(f64::INFINITY, f64::min);
    // Along an axis on which nothing changes a cell may have any side.
    let sides = [(grid.nx(), grid.dx()), (grid.ny(), grid.dy())];
    let sides = sides.into_iter().filter(|(cells, _)| *cells > 1);
    let widest = sides.map(|(_, side)| side).fold(0.0, f64::max);
    if thinnest < THINNEST * widest {
        let quantity = "an edge inside the cells, on layers thinner than four of them,";
        let remedy = "take smaller cells, or the areas of the cells";
        normal.pair().check_homogeneous(quantity, remedy)?;
    }
    Ok(())
}

/// `Ok` if a grid is no slab of one that ranks share.
fn check_whole(grid: Grid) -> Result<()> {
    if grid == grid.whole() {
        Ok(())
    } else {
        Err(Error::Ranks(RankFailure::UnsupportedOnRanks(
            "edges of a contact",
        )))
    }
}
