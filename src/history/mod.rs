//! Contacts under loads that come and go.

mod path;

pub use path::LoadPath;
