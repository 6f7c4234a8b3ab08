//! Tangent stiffnesses of contacts.

use stickslip_rs::stiffness::{ContactStiffness, NormalStiffness, TangentialStiffness};

/// Derivative of the normal force with respect to the approach.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_normal_stiffness {
    /// Stiffness (a force over a length); zero without contact. The set of contact cells is fixed. On a sphere the
    /// stiffness is 2 E* a (Hertz).
    pub value: f64,
    /// Bound on the relative error of the linear solve; infinite if pressure and traction are coupled. It excludes the
    /// effect of errors of the pressure.
    pub bound: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

/// Derivatives of the forces along x and y and of the moment with respect to the shifts along x and y and the twist. The
/// sets of stick and slip cells are fixed, and the pressure is constant unless it is coupled. Rows are loads, and columns
/// are motions. In C, the order of the indices is loading[row][column]. The first two rows and columns are forces over
/// lengths; the last diagonal entry is a moment over radians, and the other entries are forces over radians. Loads and
/// motions that are not part of the model are NaN. These are the direction across the axis and the twist in the scalar
/// model, and the twist on periodic grids.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_tangential_stiffness {
    /// Derivative with respect to the motion at the end of the step, if the motion continues in its direction. Stick
    /// cells follow the motion, and slip cells stay at their friction limit. In the vector model the traction of slip
    /// cells turns with the slip. On a ball under a constant normal load, the derivative is 8 G* a (1 - F/(mu W))^(1/3)
    /// (Cattaneo and Mindlin).
    ///
    /// Cells that came into contact in the step follow the motion only partially. After a step that presses a ball from
    /// zero load, the derivative is about two thirds of Mindlin's stiffness 8 G* a, although all cells stick.
    /// stickslip_history_next_stiffness computes the derivative for the next step, in which these cells resist fully.
    pub loading: [[f64; 3]; 3],
    /// Derivative for a reversal of the motion, at which all contact cells stick. For a circular contact it is Mindlin's
    /// stiffness 8 G* a.
    pub reversal: [[f64; 3]; 3],
    /// Bound on the errors: the error of an entry is at most bound times the square root of the product of the diagonal
    /// entries of its row and its column, for the twist about the centre of the contact. The bound is infinite if
    /// pressure and traction are coupled. It excludes the effect of errors of pressure and traction.
    pub bound: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

/// Tangent stiffness of a contact.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_stiffness {
    /// Derivative of the normal force with respect to the approach.
    pub normal: stickslip_normal_stiffness,
    /// Derivatives of the tangential forces and the moment with respect to shift and twist.
    pub tangential: stickslip_tangential_stiffness,
    /// Derivatives of the tangential forces (forces over lengths) and the moment (a force) with respect to the approach
    /// while slip continues: the friction limit of slip cells follows the pressure. They are valid if the shift grows in
    /// the same step, or if the approach decreases. If the bodies are pressed further at a constant shift, the slip cells
    /// stick and the derivatives are zero. The derivatives have no error bound. NaN for loads that are not part of the
    /// model.
    pub by_approach: [f64; 3],
    /// Derivatives of the normal force with respect to the shifts along x and y (forces over lengths) and the twist (a
    /// force). They are zero unless pressure and traction are coupled, and NaN for motions that are not part of the
    /// model.
    pub normal_by_motion: [f64; 3],
    /// Reserved for future members: zero.
    pub reserved: [u64; 5],
}

/// Converts derivatives that are not part of the model to NaN.
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
