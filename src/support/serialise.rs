//! Serialisation code that is not derived. It checks deserialised values and serialises numbers that may be
//! infinite or NaN.
//!
//! JSON supports finite numbers only. In human-readable formats NaN and the infinities are therefore written as the
//! strings `NaN`, `Infinity` and `-Infinity`. In all other formats every number is written as a number.

use std::fmt;

use serde::de::{Deserialize, Deserializer, Error, Unexpected, Visitor};
use serde::ser::{Serialize, Serializer};

/// Serialisation of a number, for `#[serde(with = "crate::support::serialise::number")]`.
pub(crate) mod number {
    use super::{Deserialize, Deserializer, NumberText, Serialize, Serializer};

    #[expect(
        clippy::trivially_copy_pass_by_ref,
        reason = "the signature that the derived code calls"
    )]
    pub(crate) fn serialize<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        NumberText(*value).serialize(serializer)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
        NumberText::deserialize(deserializer).map(|NumberText(value)| value)
    }
}

/// Serialisation of a sequence of numbers, for `#[serde(with = "crate::support::serialise::numbers")]`.
pub(crate) mod numbers {
    use super::{Deserialize, Deserializer, NumberText, Serializer};

    pub(crate) fn serialize<S: Serializer>(
        values: &[f64],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(values.iter().copied().map(NumberText))
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Vec<f64>, D::Error> {
        let numbers = Vec::deserialize(deserializer)?;
        Ok(numbers.into_iter().map(|NumberText(value)| value).collect())
    }
}

/// Serialisation of an array of any length, for `#[serde(with = "crate::support::serialise::array")]`.
pub(crate) mod array {
    use super::{Deserializer, Error, Serializer, numbers};

    pub(crate) fn serialize<S: Serializer, const N: usize>(
        values: &[f64; N],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        numbers::serialize(values, serializer)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>, const N: usize>(
        deserializer: D,
    ) -> Result<[f64; N], D::Error> {
        let values = numbers::deserialize(deserializer)?;
        let found = values.len();
        <[f64; N]>::try_from(values)
            .map_err(|_| D::Error::invalid_length(found, &"a different number of entries"))
    }
}

/// Returns the deserialised value if it passes the check.
pub(crate) fn checked<T, E: Error, F: fmt::Display>(
    read: T,
    check: impl FnOnce(&T) -> Result<(), F>,
) -> Result<T, E> {
    check(&read).map_err(E::custom)?;
    Ok(read)
}

/// Number in its serialised form.
struct NumberText(f64);

const NAN: &str = "NaN";
const INFINITY: &str = "Infinity";
const MINUS_INFINITY: &str = "-Infinity";

impl Serialize for NumberText {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self(value) = *self;
        if value.is_finite() || !serializer.is_human_readable() {
            serializer.serialize_f64(value)
        } else if value.is_nan() {
            serializer.serialize_str(NAN)
        } else {
            serializer.serialize_str(if value > 0.0 {
                INFINITY
            } else {
                MINUS_INFINITY
            })
        }
    }
}

impl<'de> Deserialize<'de> for NumberText {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        if deserializer.is_human_readable() {
            deserializer.deserialize_any(NumberOrWord)
        } else {
            f64::deserialize(deserializer).map(Self)
        }
    }
}

struct NumberOrWord;

impl Visitor<'_> for NumberOrWord {
    type Value = NumberText;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("a number, \"NaN\", \"Infinity\" or \"-Infinity\"")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<NumberText, E> {
        Ok(NumberText(value))
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<NumberText, E> {
        Ok(NumberText(value as f64))
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<NumberText, E> {
        Ok(NumberText(value as f64))
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<NumberText, E> {
        match word {
            NAN => Ok(NumberText(f64::NAN)),
            INFINITY => Ok(NumberText(f64::INFINITY)),
            MINUS_INFINITY => Ok(NumberText(f64::NEG_INFINITY)),
            _ => Err(E::invalid_value(Unexpected::Str(word), &self)),
        }
    }
}
