//! Memory limits, checked before the memory is allocated.

use crate::error::{Error, Result};
use std::fmt;
use std::str::FromStr;

/// A memory limit in bytes.
///
/// Code whose memory grows with a size claimed by an input estimates its need first and calls
/// [`admit`](Self::admit). The program itself takes about ten MiB in addition.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Budget(u64);

impl Budget {
    /// The default for reading one input file: 512 MiB.
    pub const READING: Self = Self(512 << 20);

    /// The default for computing the table of a scene: 2 GiB.
    pub const BASIS: Self = Self(2 << 30);

    /// A budget of this many bytes.
    #[must_use]
    pub const fn new(bytes: u64) -> Self {
        Self(bytes)
    }

    /// The limit in bytes.
    #[must_use]
    pub const fn bytes(self) -> u64 {
        self.0
    }

    /// Checks that `need` bytes are within the budget and that the system can allocate them.
    /// Allocating up to that amount piece by piece afterwards does not abort the process.
    ///
    /// # Errors
    ///
    /// If either check fails; the message names the remedy.
    pub fn admit(self, need: u64) -> Result<()> {
        self.covers(need)?;
        let mut trial = Vec::<u8>::new();
        let given = usize::try_from(need).is_ok_and(|need| trial.try_reserve_exact(need).is_ok());
        // Keeps the compiler from removing the unused allocation.
        std::hint::black_box(&trial);
        if given {
            return Ok(());
        }
        let what = format!("it needs {} of memory, which the system cannot provide", Size(need));
        let remedy = "raise the limit of the process (`ulimit -v`), or give a smaller input";
        Err(Error::new(what, remedy))
    }

    /// Checks that `need` bytes are within the budget.
    ///
    /// # Errors
    ///
    /// If they are not; the message says how to raise the limit.
    pub fn covers(self, need: u64) -> Result<()> {
        if need <= self.0 {
            return Ok(());
        }
        // Rounded up to whole MiB, like the figures in the message, so that this limit is enough.
        let enough = need.div_ceil(MEBI);
        let what = format!("it needs {} of memory, and the budget is {self}", Size(need));
        let remedy = format!("give a smaller input, or raise the budget with --memory {enough}MiB");
        Err(Error::new(what, remedy))
    }
}

impl fmt::Display for Budget {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Size(self.0).fmt(f)
    }
}

impl FromStr for Budget {
    type Err = String;

    /// Parses a whole number of bytes, or of `KiB`, `MiB`, `GiB` or `TiB`. `K`, `M`, `G` and `T`
    /// mean the same binary units.
    fn from_str(text: &str) -> std::result::Result<Self, String> {
        let digits = text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
        let (number, unit) = text.split_at(digits);
        let unit = match unit.trim_start().to_ascii_lowercase().as_str() {
            "" | "b" => 1,
            "k" | "kib" => KIBI,
            "m" | "mib" => MEBI,
            "g" | "gib" => GIBI,
            "t" | "tib" => GIBI << 10,
            _ => 0,
        };
        let bytes = number.parse::<u64>().ok().and_then(|number| number.checked_mul(unit));
        let bytes = bytes.filter(|bytes| *bytes > 0).map(Self);
        bytes.ok_or_else(|| "give a size such as 512MiB or 4GiB".to_owned())
    }
}

const KIBI: u64 = 1 << 10;
const MEBI: u64 = 1 << 20;
const GIBI: u64 = 1 << 30;

/// Bytes in readable units, rounded up.
struct Size(u64);

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            bytes if bytes >= 10 * GIBI => write!(f, "{} GiB", bytes.div_ceil(GIBI)),
            bytes if bytes.is_multiple_of(GIBI) && bytes > 0 => write!(f, "{} GiB", bytes / GIBI),
            bytes if bytes >= MEBI => write!(f, "{} MiB", bytes.div_ceil(MEBI)),
            1 => f.write_str("1 byte"),
            bytes => write!(f, "{bytes} bytes"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read_and_written() {
        for (text, bytes) in
            [("1", 1), ("64K", 65_536), ("512MiB", 512 << 20), ("2 GiB", 2 << 30), ("3t", 3 << 40)]
        {
            assert_eq!(text.parse(), Ok(Budget::new(bytes)), "{text}");
        }
        for text in ["", "0", "0G", "-1", "1.5G", "12 parsecs", "99999999999T", "MiB"] {
            assert!(text.parse::<Budget>().is_err(), "{text}");
        }
        assert_eq!(Budget::READING.to_string(), "512 MiB");
        assert_eq!(Budget::BASIS.to_string(), "2 GiB");
        assert_eq!(Budget::new(1).to_string(), "1 byte");
        assert_eq!(Budget::new(1000).to_string(), "1000 bytes");
    }

    #[test]
    fn the_message_names_need_budget_and_remedy() {
        let budget = Budget::new(1 << 20);
        assert_eq!(budget.admit(1 << 20), Ok(()));
        let text = budget.admit((5 << 20) + 1).expect_err("too much").to_string();
        assert!(text.starts_with("it needs 6 MiB of memory, and the budget is 1 MiB; "), "{text}");
        assert!(text.ends_with("--memory 6MiB"), "{text}");
        assert!("6MiB".parse::<Budget>().expect("a size").admit((5 << 20) + 1).is_ok());
    }

    #[test]
    fn what_the_system_does_not_give_is_an_error() {
        let text = Budget::new(u64::MAX).admit(1 << 60).expect_err("too much").to_string();
        assert!(text.contains("cannot provide"), "{text}");
    }
}
