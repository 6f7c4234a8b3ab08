//! Explicit matrices that are too large, not finite or not positive definite are rejected. The error contains the
//! invalid number.

use kit::unit_bodies;
use stickslip::cgm::{self, NonNegative, Problem, Settings};
use stickslip::dense::DenseOperator;
use stickslip::influence::Component;
use stickslip::{Error, Grid, Operator};

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

/// The solution of a matrix that is not symmetric is that of its variational inequality, not that of a minimum.
#[test]
fn asymmetric_matrices_are_not_declared_symmetric() {
    let matrix = |entries: [f64; 4]| DenseOperator::from_rows(2, entries.to_vec()).unwrap();
    let skew = matrix([1.0, 0.9, 0.0, 1.0]);
    assert!(!skew.is_symmetric());
    assert!(matrix([1.0, 0.5, 0.5, 1.0]).is_symmetric());
    assert!(matrix([1.0, 0.5 + 1e-10, 0.5, 1.0]).is_symmetric());

    let problem = Problem::new(&skew, [&[-2.8, -1.0]], NonNegative);
    let (settings, mut x) = (Settings::default().tolerance(1e-12), vec![1.0; 2]);
    cgm::minimise(&problem, &settings, [&mut x]).unwrap();
    assert!(
        (x[0] - 1.9).abs() < 1e-9 && (x[1] - 1.0).abs() < 1e-9,
        "{x:?}"
    );
}
