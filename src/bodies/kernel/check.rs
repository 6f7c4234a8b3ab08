//! Checks that responses belong to bodies that store positive energy.

use crate::bodies::kernel::ResponseTensor;
use crate::bodies::layers::Response;
use crate::error::{Result, at_least, finite, positive};
use crate::grid::Grid;

/// Largest difference of a tensor from its mirror image that counts as round-off.
const MIRRORED: f64 = 1e-10;

/// Name of the value 1 in errors: the ratio of the permitted difference to the actual difference must be at least 1.
pub(super) const AS_ALLOWED: &str = "a difference equal to the permitted difference";

/// Least thickness of a layer divided by the diagonal of a grid, as limited by the range of the tables of coated
/// bodies.
const THINNEST: f64 = 1e-25;

/// Checks that the tables of a layer of this thickness cover the grid.
pub(crate) fn check_thickness(thickness: f64, grid: Grid) -> Result<()> {
    let [length, width] = [grid.nx() as f64 * grid.dx(), grid.ny() as f64 * grid.dy()];
    let quantity = "ratio of the layer thickness to the diagonal of the grid";
    at_least(
        "the smallest permitted ratio",
        THINNEST,
        quantity,
        thickness / length.hypot(width),
    )?;
    Ok(())
}

/// Returns a coupling divided by the geometric mean of the two compliances that it couples. The order of the divisions
/// prevents overflow.
pub(super) fn ratio(coupling: f64, one: f64, other: f64) -> f64 {
    coupling / one.sqrt() / other.sqrt()
}

pub(super) fn stronger(one: f64, other: f64) -> f64 {
    if other.abs() > one.abs() { other } else { one }
}

pub(super) fn checked(found: Response) -> Result<Response> {
    positive("response of the kernel to waves of pressure", found.normal)?;
    positive(
        "response of the kernel to traction along waves",
        found.along,
    )?;
    positive(
        "response of the kernel to traction across waves",
        found.across,
    )?;
    finite("coupling of the kernel", found.coupling)?;
    let coupling = ratio(found.coupling, found.normal, found.along);
    let quantity = "ratio of the energy of a wave to its energy without coupling";
    positive(quantity, 1.0 - coupling * coupling)?;
    Ok(found)
}

pub(super) fn checked_far(far: Response) -> Result<Response> {
    let quantity = "product of wave number and response of the kernel to long waves";
    for value in [far.normal, far.along, far.across, far.coupling] {
        finite(quantity, value)?;
    }
    Ok(far)
}

pub(super) fn checked_tensor(found: ResponseTensor) -> Result<ResponseTensor> {
    positive("response of the kernel to waves of pressure", found.zz)?;
    positive(
        "response of the kernel to waves of traction along x",
        found.xx,
    )?;
    positive(
        "response of the kernel to waves of traction along y",
        found.yy,
    )?;
    for value in [found.xy, found.zx, found.zy] {
        finite("coupling of the kernel", value)?;
    }
    Ok(found)
}

/// Checks that a tensor agrees with the tensor of the wave vector that is mirrored along x or y.
pub(super) fn check_mirrored(
    found: &ResponseTensor,
    mirrored: &ResponseTensor,
    [along_x, along_y]: [bool; 2],
) -> Result<()> {
    let signs = [false, false, false, true, along_x, along_y];
    let unit = found.xx.max(found.yy).max(found.zz);
    let values = found.values().into_iter().zip(mirrored.values());
    let differences = values.zip(signs).map(|((found, mirrored), is_odd)| {
        let mirrored = if is_odd { -mirrored } else { mirrored };
        (found - mirrored).abs() / unit
    });
    let most = differences.fold(0.0, |a: f64, b| if b.is_nan() { b } else { a.max(b) });
    let quantity =
        "ratio of the permitted to the actual difference between a response and its mirror image";
    at_least(AS_ALLOWED, 1.0, quantity, MIRRORED / most.max(MIRRORED))?;
    Ok(())
}

/// Returns the wave numbers at which a kernel is checked.
pub(super) fn wave_numbers(thickness: f64) -> impl Iterator<Item = f64> {
    (-28..=12).map(move |n| (0.5 * f64::from(n)).exp2() / thickness)
}

/// Iterates over the wave numbers of a grid in half octaves, from the longest wave to the shortest.
pub(super) fn waves_of(grid: Grid) -> impl Iterator<Item = f64> {
    let pi = std::f64::consts::PI;
    let longest = grid.longest_side();
    let shortest = pi * (1.0 / grid.dx()).hypot(1.0 / grid.dy());
    let next =
        move |k: &f64| (*k < shortest).then_some((std::f64::consts::SQRT_2 * k).min(shortest));
    std::iter::successors(Some(2.0 * pi / longest), next)
}
