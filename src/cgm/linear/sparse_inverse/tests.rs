use super::*;
use crate::error::Error;
use crate::parallel::layout::Layout;

const SIZE: [usize; 2] = [11, 9];

/// Returns the coefficient of two cells at a distance, which decays like the compliance of a half-space.
fn coefficient(columns: usize, rows: usize) -> f64 {
    if columns + rows == 0 {
        3.5
    } else {
        1.0 / (columns as f64).hypot(1.1 * rows as f64)
    }
}

fn inverse(columns: usize) -> SparseInverse<1> {
    static FACTORS: OnceLock<Arc<SparseFactors<1>>> = OnceLock::new();
    let factors = FACTORS.get_or_init(|| Arc::new(SparseFactors::new(|_, x, y| coefficient(x, y))));
    SparseInverse {
        factors: Arc::clone(factors),
        columns,
    }
}

/// Returns the matrix of the sparse inverse on the cells that move.
fn matrix([columns, rows]: [usize; 2], moves: impl Fn(usize) -> bool + Sync) -> Vec<Vec<f64>> {
    let layout = Layout::of([columns, rows]);
    let mut moving = FreeCells::new(layout.clone()).unwrap();
    moving.update(&moves);
    let marks: Vec<f64> = (0..layout.cells())
        .map(|cell| f64::from(u8::from(moves(cell))))
        .collect();
    let (inverse, mut scratch) = (inverse(columns), SparseScratch::default());
    inverse
        .find_patterns(&moving, &marks, &mut scratch)
        .unwrap();
    let unit = |cell: usize| {
        let mut unit = vec![0.0; layout.cells()];
        unit[cell] = 1.0;
        let mut image = [vec![0.0; layout.cells()]];
        assert!(inverse.apply(&moving, [&unit], &mut image, &scratch));
        let [image] = image;
        (0..layout.cells())
            .filter(|cell| moves(*cell))
            .map(|cell| image[cell])
            .collect()
    };
    (0..layout.cells())
        .filter(|cell| moves(*cell))
        .map(unit)
        .collect()
}

/// Returns the coefficients of the cells that move.
fn compliance([columns, rows]: [usize; 2], moves: impl Fn(usize) -> bool) -> Vec<Vec<f64>> {
    let cells: Vec<_> = (0..columns * rows).filter(|cell| moves(*cell)).collect();
    let entry = |a: usize, b: usize| {
        let along = |of: fn(usize, usize) -> usize| of(a, columns).abs_diff(of(b, columns));
        coefficient(along(|a, n| a % n), along(|a, n| a / n))
    };
    let row = |&a: &usize| cells.iter().map(|&b| entry(a, b)).collect();
    cells.iter().map(row).collect()
}

fn product(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let entry = |row: &[f64], column: usize| {
        row.iter()
            .zip(b)
            .fold(0.0, |sum, (a, b)| sum + a * b[column])
    };
    a.iter()
        .map(|row| (0..b.len()).map(|column| entry(row, column)).collect())
        .collect()
}

fn assert_is_inverse(size: [usize; 2], moves: impl Fn(usize) -> bool + Sync) {
    let unity = product(&matrix(size, &moves), &compliance(size, &moves));
    for (a, row) in unity.iter().enumerate() {
        for (b, value) in row.iter().enumerate() {
            let unit = f64::from(u8::from(a == b));
            assert!((value - unit).abs() < 1e-12, "{a} {b} {value}");
        }
    }
}

/// The inverse is exact if every cell is an earlier neighbour of all later cells.
#[test]
fn sparse_inverse_of_few_adjacent_cells_is_the_inverse() {
    for corner in [0, 4, 9, 11, 40, 11 * 7, 11 * 7 + 9] {
        let moves = move |cell: usize| [0, 1, 11, 12].iter().any(|step| corner + step == cell);
        assert_is_inverse(SIZE, moves);
    }
    assert_is_inverse([1, 30], |cell| (7..10).contains(&cell));
    assert_is_inverse([30, 1], |cell| (7..10).contains(&cell));
    assert_is_inverse([2, 9], |cell| (6..10).contains(&cell));
}

/// The first and the last cell of two adjacent rows are not neighbours.
#[test]
fn ends_of_adjacent_rows_are_not_neighbours() {
    let ends = [10, 11, 22, 32];
    let found = matrix(SIZE, |cell| ends.contains(&cell));
    let own = 1.0 / coefficient(0, 0);
    // Cells 11 and 22 are adjacent, as are cells 10 and 32, which are two rows apart.
    assert!((found[0][0] - own).abs() > 1e-3 && (found[1][1] - own).abs() > 1e-3);
    for [a, b] in [[0, 1], [0, 2], [1, 3], [2, 3]] {
        assert!(found[a][b].abs() < f64::MIN_POSITIVE, "{a} {b}");
    }
}

/// Among all rows with this pattern and a unit last entry, the row minimises `g'Cg`, whose reciprocal is the weight. Therefore
/// `W G C G'` has a unit diagonal.
#[test]
fn rows_have_least_energy() {
    let factors = SparseFactors::<1>::new(|_, x, y| coefficient(x, y));
    let [table] = factors.tables().unwrap();
    assert_eq!(table.len(), PATTERNS);
    let place = |entry: usize| EARLIER.get(entry).copied().unwrap_or([0; 2]);
    for (pattern, row) in table.iter().enumerate() {
        let mut row = *row;
        let weight = std::mem::replace(&mut row[EARLIER.len()], 1.0);
        for entry in 0..ENTRIES {
            let product: f64 = (0..ENTRIES)
                .map(|other| {
                    let ([x, y], [u, v]) = (place(entry), place(other));
                    coefficient(x.abs_diff(u).into(), y.abs_diff(v).into()) * row[other]
                })
                .sum();
            let is_own = entry == EARLIER.len();
            if pattern >> entry & 1 == 1 && !is_own {
                assert!(product.abs() < 1e-12, "pattern {pattern}, entry {entry}");
            } else if is_own {
                assert!((product * weight - 1.0).abs() < 1e-12);
            } else {
                assert!(row[entry].abs() < f64::MIN_POSITIVE);
            }
        }
    }
}

/// A change of units by a power of two scales the weights without rounding.
#[test]
fn rows_do_not_depend_on_units() {
    let factors =
        [1.0, 8.0].map(|unit| SparseFactors::<1>::new(|_, x, y| unit * coefficient(x, y)));
    let [[one], [other]] = factors.each_ref().map(|factors| factors.tables().unwrap());
    for (one, other) in one.iter().zip(other) {
        let mut scaled = *other;
        scaled[EARLIER.len()] *= 8.0;
        assert_eq!(one.map(f64::to_bits), scaled.map(f64::to_bits));
    }
}

#[test]
fn indefinite_coefficients_are_rejected() {
    let factors = SparseFactors::<1>::new(|_, x, y| if x + y == 0 { 1.0 } else { -2.0 });
    assert!(matches!(factors.tables(), Err(Error::NotPositive { .. })));
}

#[test]
fn sparse_inverse_is_for_few_scattered_cells() {
    let suits = |moves: fn(usize) -> bool| {
        let layout = Layout::of([80, 80]);
        let mut moving = FreeCells::new(layout.clone()).unwrap();
        moving.update(moves);
        let marks: Vec<f64> = (0..layout.cells())
            .map(|cell| f64::from(u8::from(moves(cell))))
            .collect();
        let inverse = inverse(80);
        has_few(&moving) && inverse.prepare(&moving, &marks, &mut SparseScratch::default())
    };
    assert!(suits(|cell| cell % 7 == 0));
    // Half of the cells.
    assert!(!suits(|cell| cell % 2 == 0));
    // A square of 40 x 40 cells, and 16 squares of 4 x 4 cells.
    assert!(!suits(|cell| cell % 80 < 40 && cell / 80 < 40));
    assert!(suits(|cell| cell % 20 < 4 && cell / 80 % 20 < 4));
}

/// Returns random numbers between zero and one.
fn random_numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Solves a small system by Gaussian elimination.
fn solve(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Vec<f64> {
    for p in 0..right.len() {
        let (pivots, value) = (matrix[p].clone(), right[p]);
        for q in (0..right.len()).filter(|q| *q != p) {
            let factor = matrix[q][p] / pivots[p];
            for (entry, pivot) in matrix[q].iter_mut().zip(&pivots) {
                *entry -= factor * pivot;
            }
            right[q] -= factor * value;
        }
    }
    let solved = right.iter().enumerate();
    solved.map(|(p, value)| value / matrix[p][p]).collect()
}

/// Returns the factor of the moving cells, whose rows are computed from the definition.
fn dense_factor([columns, rows]: [usize; 2], moves: impl Fn(usize) -> bool) -> Vec<Vec<f64>> {
    let matrix = compliance([columns, rows], &moves);
    let cells: Vec<_> = (0..columns * rows).filter(|cell| moves(*cell)).collect();
    let row = |row: usize| {
        let is_listed = |&other: &usize| {
            let [[x, y], [u, v]] = [row, other].map(|k| [cells[k] % columns, cells[k] / columns]);
            other <= row && x.abs_diff(u).pow(2) + y.abs_diff(v).pow(2) <= 5
        };
        let listed: Vec<_> = (0..cells.len()).filter(is_listed).collect();
        let part = |&p: &usize| listed.iter().map(|&q| matrix[p][q]).collect();
        let mut unit = vec![0.0; listed.len()];
        unit[listed.len() - 1] = 1.0;
        let solved = solve(listed.iter().map(part).collect(), unit);
        let scale = solved[listed.len() - 1].sqrt();
        let mut factor = vec![0.0; cells.len()];
        for (cell, value) in listed.into_iter().zip(solved) {
            factor[cell] = value / scale;
        }
        factor
    };
    (0..cells.len()).map(row).collect()
}

/// Grids of all widths have cells near their edges. The mean eigenvalue of the preconditioned matrix is one.
#[test]
fn sparse_inverse_is_product_of_dense_factors() {
    let mut random = random_numbers(7);
    for case in 0..100 {
        let size = [1 + case % 13, 1 + 5 * case % 12];
        let fraction = random();
        let moves: Vec<bool> = (0..size[0] * size[1])
            .map(|_| random() < fraction)
            .collect();
        let moves = |cell: usize| moves[cell];
        let (found, factor) = (matrix(size, moves), dense_factor(size, moves));
        let transposed: Vec<Vec<f64>> = (0..factor.len())
            .map(|a| factor.iter().map(|row| row[a]).collect())
            .collect();
        let expected = product(&transposed, &factor);
        for (a, (found, expected)) in found.iter().zip(&expected).enumerate() {
            for (b, (found, expected)) in found.iter().zip(expected).enumerate() {
                let error = (found - expected).abs();
                assert!(error < 1e-13, "case {case}, {size:?}, cells {a} and {b}");
            }
        }
        let unity = product(&found, &compliance(size, moves));
        let trace = (0..unity.len()).fold(0.0, |trace, cell| trace + unity[cell][cell]);
        let count = unity.len() as f64;
        assert!((trace - count).abs() <= 1e-12 * count, "case {case}");
    }
}

#[test]
fn sparse_inverse_is_symmetric_and_positive_definite() {
    let mut random = random_numbers(1);
    for case in 0..50 {
        let fraction = random();
        let moves: Vec<bool> = (0..SIZE[0] * SIZE[1])
            .map(|_| random() < fraction)
            .collect();
        let found = matrix(SIZE, |cell| moves[cell]);
        let vector: Vec<f64> = found.iter().map(|_| random() - 0.5).collect();
        let (mut energy, mut square) = (0.0, 0.0);
        for (a, row) in found.iter().enumerate() {
            for (b, value) in row.iter().enumerate() {
                assert!((value - found[b][a]).abs() < 1e-14, "case {case}");
                energy += vector[a] * value * vector[b];
            }
            square += vector[a] * vector[a];
        }
        assert!(energy >= 1e-3 * square, "case {case}");
    }
}

/// Computes the product with the sparse inverse cell by cell, from rows and columns of the neighbours.
fn product_by_cells([columns, rows]: [usize; 2], moves: &[bool], direction: &[f64]) -> Vec<f64> {
    let factors = SparseFactors::<1>::new(|_, x, y| coefficient(x, y));
    let [table] = factors.tables().unwrap();
    let mut image = vec![0.0; moves.len()];
    for cell in (0..moves.len()).filter(|cell| moves[*cell]) {
        let neighbours = EARLIER.map(|[x, y]| {
            let x = (cell % columns).checked_add_signed(x.into())?;
            let y = (cell / columns).checked_add_signed(y.into())?;
            (x < columns && y < rows && moves[y * columns + x]).then_some(y * columns + x)
        });
        let bits = neighbours.iter().enumerate();
        let pattern = bits.fold(0, |bits, (bit, place)| {
            bits | usize::from(place.is_some()) << bit
        });
        let places = neighbours.into_iter().chain([Some(cell)]);
        let mut row = table[pattern];
        let weight = std::mem::replace(&mut row[EARLIER.len()], 1.0);
        let entries = row.into_iter().zip(places);
        let entries: Vec<_> = entries
            .filter_map(|(entry, place)| Some((entry, place?)))
            .collect();
        let sum = entries
            .iter()
            .fold(0.0, |sum, (entry, place)| sum + entry * direction[*place]);
        let half = weight * sum;
        for (entry, place) in entries {
            image[place] += entry * half;
        }
    }
    image
}

/// The chunks of these grids are several rows, one row, and pieces of a row.
#[test]
fn sparse_inverse_adds_to_neighbours_in_other_chunks() {
    let mut random = random_numbers(3);
    for size in [[700, 12], [2100, 6], [9000, 3], [1, 9000]] {
        let layout = Layout::of(size);
        assert!(layout.tasks() > 1);
        let moves: Vec<bool> = (0..layout.cells()).map(|_| random() < 0.4).collect();
        let direction: Vec<f64> = moves
            .iter()
            .map(|moves| if *moves { random() - 0.5 } else { 0.0 })
            .collect();
        let marks: Vec<f64> = moves
            .iter()
            .map(|moves| f64::from(u8::from(*moves)))
            .collect();
        let mut moving = FreeCells::new(layout.clone()).unwrap();
        moving.update(|cell| moves[cell]);
        let (inverse, mut scratch) = (inverse(size[0]), SparseScratch::default());
        inverse
            .find_patterns(&moving, &marks, &mut scratch)
            .unwrap();
        let mut image = [vec![7.0; layout.cells()]];
        assert!(inverse.apply(&moving, [&direction], &mut image, &scratch));
        let expected = product_by_cells(size, &moves, &direction);
        for cell in (0..layout.cells()).filter(|cell| moves[*cell]) {
            let error = (image[0][cell] - expected[cell]).abs();
            assert!(error < 1e-13, "{size:?}, cell {cell}");
        }
    }
}
