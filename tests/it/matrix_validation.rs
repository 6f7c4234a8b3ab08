//! Explicit matrices that are too large, not finite or not positive definite are rejected. The error contains the
//! invalid number.

use kit::unit_bodies;
use stickslip::cgm::NonNegative;
use stickslip::dense::DenseOperator;
use stickslip::influence::Component;
use stickslip::{Error, Grid};

#[test]
fn matrices_that_are_invalid_are_rejected() {
    kit::assert_refused! {
        DenseOperator::from_rows(2, vec![0.0; 3]) => Error::Length { .. },
        DenseOperator::from_rows(1, vec![f64::NAN]) => Error::Sample { .. },
    }
    let large = unit_bodies(Grid::new(65, 64, 1.0, 1.0).unwrap(), 0.3);
    kit::assert_refused! {
        DenseOperator::of_half_space(&large, Component::ZZ) => Error::TooManyCells { cells: 4160, limit: 4096 },
    }
    let indefinite = DenseOperator::from_rows(2, vec![1.0, 2.0, 2.0, 1.0]).unwrap();
    let error = indefinite.minimise(&[-1.0, -1.0], &NonNegative, None).err();
    assert_eq!(error, Some(Error::NotPositiveDefinite { row: 1 }));
    let matrix = DenseOperator::from_rows(1, vec![1.0]).unwrap();
    kit::assert_refused! { matrix.minimise(&[0.0], &NonNegative, Some(-1.0)) => Error::Total { .. } }
}
