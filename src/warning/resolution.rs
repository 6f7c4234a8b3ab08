//! Resolution of the contact and its zones by the cells.

use crate::grid::Grid;
use crate::warning::Warning;

/// Least number of cells of a resolved spot.
pub(crate) const RESOLVED: usize = 5;

/// Minimum numbers of cells in a resolved contact and in a resolved stick zone.
pub(super) const RESOLVED_AREA: [usize; 2] = [100, 50];
/// Minimum numbers of cells in a resolved contact and in a resolved stick zone on a line. One cell is a tenth of this
/// stick zone.
pub(super) const RESOLVED_LINE: [usize; 2] = [20, 10];

/// Least width of a resolved slip zone, in tenths of a cell.
const RESOLVED_WIDTH: usize = 20;

/// Least width of a resolved slip zone of a rolling step, in tenths of a cell. This width is smaller than the width for
/// other steps because forces need less resolution than energies.
const RESOLVED_ROLLING_WIDTH: usize = 10;

/// Smallest mean radius of contact spots, in cells, for which a slip zone can be resolved.
const LEAST_RADIUS: usize = 4;

/// Resolution of the zones of a contact, or of several steps. An entry is `None` if the zone does not exist.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Resolution {
    is_line: bool,
    /// Smallest number of cells in contact (`contact`) and of sticking cells (`stick`).
    contact: Option<usize>,
    stick: Option<usize>,
    /// Width of the widest slip zone in tenths of a cell. It is zero if no cell slips, and large if all cells slip.
    slip_width: Option<usize>,
}

impl Resolution {
    /// Returns the resolution of a contact with this number of cells. A contact that fills the whole grid has no edge
    /// to resolve.
    pub(crate) fn of_contact(grid: Grid, contact: usize) -> Self {
        Self {
            is_line: grid.size().contains(&1),
            contact: (contact > 0 && contact < grid.cells()).then_some(contact),
            ..Self::default()
        }
    }

    /// Returns this resolution with the numbers of sticking and slipping cells. `edge` returns the number of cell sides
    /// along the edge of the contact. This function is called only if cells stick. `hides_slip` states whether a contact without
    /// slipping cells has a slip zone inside its outermost cells.
    pub(crate) fn with_zones(
        self,
        [stick, slip]: [usize; 2],
        hides_slip: bool,
        edge: impl FnOnce() -> usize,
    ) -> Self {
        let width = || {
            // The edge of a disc, measured along cell sides, is 4/pi times as long as its circumference. 452/355 equals 4/pi with
            // a relative error below 1e-7.
            let [sides, length] = if self.is_line { [1, 1] } else { [452, 355] };
            let edge = length * edge();
            // The radius of a disc is twice its area divided by the length of its edge.
            let has_room = self.is_line || 2 * sides * (stick + slip) >= LEAST_RADIUS * edge;
            let tenths = || (20 * sides * slip + edge) / (2 * edge);
            (edge > 0 && has_room).then(|| tenths().max(usize::from(slip > 0)))
        };
        let slip_width = match (stick, slip) {
            (0, 0) => None,
            (0, _) => Some(RESOLVED_WIDTH),
            _ => (slip > 0 || (hides_slip && self.contact.is_some()))
                .then(width)
                .flatten(),
        };
        Self {
            stick: (stick > 0).then_some(stick),
            slip_width,
            ..self
        }
    }

    /// Returns the resolution of a rolling step, for which narrower slip zones count as resolved.
    pub(crate) fn of_rolling(self) -> Self {
        let resolved = |width: usize| {
            if width < RESOLVED_ROLLING_WIDTH {
                width
            } else {
                width.max(RESOLVED_WIDTH)
            }
        };
        Self {
            slip_width: self.slip_width.map(resolved),
            ..self
        }
    }

    /// Combines this resolution with the resolution of another step.
    pub(crate) fn and(self, other: Self) -> Self {
        let fewest = |a: Option<usize>, b: Option<usize>| a.into_iter().chain(b).min();
        Self {
            is_line: self.is_line || other.is_line,
            contact: fewest(self.contact, other.contact),
            stick: fewest(self.stick, other.stick),
            slip_width: self.slip_width.max(other.slip_width),
        }
    }

    /// Returns the warning if the contact has too few cells.
    pub(crate) fn contact_warning(self) -> Option<Warning> {
        let coarse = self.contact.filter(|cells| *cells < self.least()[0]);
        coarse.map(|cells| Warning::UnderresolvedContact { cells })
    }

    /// Returns the warnings for zones with too few cells. A coarse stick zone has no warning if the contact itself is
    /// too coarse.
    pub(crate) fn zone_warnings(self) -> impl Iterator<Item = Warning> {
        let is_coarse = self.contact_warning().is_some();
        let stick = self
            .stick
            .filter(|cells| *cells < self.least()[1] && !is_coarse);
        let stick = stick.map(|cells| Warning::UnderresolvedStickZone { cells });
        let slip = self.slip_width.filter(|tenths| *tenths < RESOLVED_WIDTH);
        let slip = slip.map(|tenths| Warning::UnderresolvedSlipZone { tenths });
        stick.into_iter().chain(slip)
    }

    /// Returns the minimum numbers of cells in a resolved contact and in a resolved stick zone.
    fn least(self) -> [usize; 2] {
        if self.is_line {
            RESOLVED_LINE
        } else {
            RESOLVED_AREA
        }
    }
}
