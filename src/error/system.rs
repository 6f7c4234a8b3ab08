//! Error of the operating system that caused an error of a file.

use std::sync::Arc;

/// Error of the operating system for a file.
///
/// Two values are equal if they have the same [code](Self::code) and the same message.
#[derive(Debug, Clone, thiserror::Error)]
#[error(transparent)]
pub struct SystemError(Arc<std::io::Error>);

impl SystemError {
    /// Returns the error number of the operating system, if any.
    #[must_use]
    pub fn code(&self) -> Option<i32> {
        self.0.raw_os_error()
    }

    /// Returns the kind of the error.
    #[must_use]
    pub fn kind(&self) -> std::io::ErrorKind {
        self.0.kind()
    }
}

impl From<std::io::Error> for SystemError {
    fn from(error: std::io::Error) -> Self {
        Self(Arc::new(error))
    }
}

impl PartialEq for SystemError {
    fn eq(&self, other: &Self) -> bool {
        self.code() == other.code() && self.to_string() == other.to_string()
    }
}
