//! Slopes of the forces.

use stickslip_rs::stiffness::{ContactStiffness, NormalStiffness, TangentialStiffness};

/// Normal force by approach.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_normal_stiffness {
    /// A force over a length; zero without contact.
    pub value: f64,
    /// Bound of its relative error; infinite where pressure and traction are found together.
    pub bound: f64,
    /// Room for members to come: zero.
    pub reserved: [u64; 8],
}

/// Forces along x and y and the moment, by shifts along x and y and the twist: rows are loads, columns motions. In C
/// loading[row, column]. NaN for loads and motions that the model does not have: in the scalar model what is across its axis
/// and the twist, on grids that repeat the twist.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_tangential_stiffness {
    /// Derivative with respect to the motion at the end of the step, if the motion continues in its direction. Cells that came
    /// into contact in the step follow the motion only in part. After a step that presses a ball the derivative is about
    /// two thirds of Mindlin's stiffness, although all cells stick. stickslip_history_next_stiffness has the derivative of the
    /// next step, in which they resist fully.
    pub loading: [[f64; 3]; 3],
    /// If the motion reverses: all cells of the contact stick.
    pub reversal: [[f64; 3]; 3],
    /// Bound of the errors: none is larger than this times the root of the product of the two entries on the diagonal;
    /// infinite where pressure and traction are found together.
    pub bound: f64,
    /// Room for members to come: zero.
    pub reserved: [u64; 8],
}

/// The stiffness of a contact.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_stiffness {
    /// Normal force by approach.
    pub normal: stickslip_normal_stiffness,
    /// Tangential forces and moment by shift and twist.
    pub tangential: stickslip_tangential_stiffness,
    /// Tangential forces and moment by the approach while slip continues; NaN for those that the model does not have.
    pub by_approach: [f64; 3],
    /// Normal force by shifts along x and y and the twist: zero but where pressure and traction are found together. NaN for
    /// motions that the model does not have.
    pub normal_by_motion: [f64; 3],
    /// Room for members to come: zero.
    pub reserved: [u64; 5],
}

/// What a model does not have as NaN.
fn present(slopes: [Option<f64>; 3]) -> [f64; 3] {
    slopes.map(|slope| slope.unwrap_or(f64::NAN))
}

impl From<NormalStiffness> for stickslip_normal_stiffness {
    fn from(of: NormalStiffness) -> Self {
        Self {
            value: of.value,
            bound: of.bound,
            reserved: [0; 8],
        }
    }
}

impl From<TangentialStiffness> for stickslip_tangential_stiffness {
    fn from(of: TangentialStiffness) -> Self {
        Self {
            loading: of.loading.map(present),
            reversal: of.reversal.map(present),
            bound: of.bound,
            reserved: [0; 8],
        }
    }
}

impl From<ContactStiffness> for stickslip_stiffness {
    fn from(of: ContactStiffness) -> Self {
        Self {
            normal: of.normal.into(),
            tangential: of.tangential.into(),
            by_approach: present(of.by_approach),
            normal_by_motion: present(of.normal_by_motion),
            reserved: [0; 5],
        }
    }
}
