//! The quality of pictures: the number of sub-frames that each is the mean of.

/// The number of sub-frames of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quality(u32);

impl Quality {
    /// One sub-frame: the plain picture.
    pub const DRAFT: Self = Self(1);
    /// For a look at it, and for the window at rest.
    pub const GOOD: Self = Self(16);
    /// For films.
    pub const FILM: Self = Self(64);
    /// For single pictures.
    pub const POSTER: Self = Self(256);
    /// The qualities with names, the quickest first.
    pub const NAMED: [(&'static str, Self); 4] =
        [("draft", Self::DRAFT), ("good", Self::GOOD), ("film", Self::FILM), ("poster", Self::POSTER)];
    /// The most sub-frames.
    pub const MOST: u32 = 65_536;

    /// A quality by its name or its number of sub-frames, 1 to [`Self::MOST`].
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let named = Self::NAMED.iter().find(|(name, _)| *name == text).map(|&(_, quality)| quality);
        let counted = || text.parse().ok().filter(|count| (1..=Self::MOST).contains(count)).map(Self);
        named.or_else(counted)
    }

    /// The number of sub-frames.
    #[must_use]
    pub const fn sub_frames(self) -> u32 {
        self.0
    }

    /// Whether it has more sub-frames than one.
    #[must_use]
    pub const fn is_refined(self) -> bool {
        self.0 > 1
    }
}

impl Default for Quality {
    fn default() -> Self {
        Self::DRAFT
    }
}

impl std::fmt::Display for Quality {
    /// Its name, or else its number.
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match Self::NAMED.iter().find(|(_, quality)| quality == self) {
            Some((name, _)) => formatter.write_str(name),
            None => write!(formatter, "{}", self.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_numbers() {
        for (name, quality) in Quality::NAMED {
            assert_eq!(Quality::parse(name), Some(quality));
            assert_eq!(Quality::parse(&quality.sub_frames().to_string()), Some(quality));
            assert_eq!(quality.to_string(), name);
        }
        assert_eq!(Quality::parse("65536").map(Quality::sub_frames), Some(65_536));
        for wrong in ["", "0", "-1", "65537", "Film", "1.5", "film "] {
            assert_eq!(Quality::parse(wrong), None, "{wrong}");
        }
        assert_eq!(Quality::parse("3").unwrap().to_string(), "3");
    }
}
