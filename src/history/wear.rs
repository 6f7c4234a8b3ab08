//! Depth removed by wear, and how many cycles may be jumped.
