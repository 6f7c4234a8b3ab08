//! Small numerical methods: comparison of values, vectors of a cell, small matrices, quadrature, interpolation and eigenvalues.

pub(crate) mod agreement;
pub(crate) mod cell_vector;
pub(crate) mod gauss;
pub(crate) mod interpolation;
pub(crate) mod jacobi;
pub(crate) mod small_matrix;
