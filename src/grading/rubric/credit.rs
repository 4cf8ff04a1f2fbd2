//! Partial credit: how an error becomes a share of the points.

use crate::animation_diff::Tolerances;

/// What is within these tolerances earns this share of the points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// The largest errors.
    pub tolerances: Tolerances,
    /// The share, 0 to 1.
    pub share: f64,
}

/// How errors become shares of the points.
#[derive(Clone, Debug, PartialEq)]
pub struct Credit {
    /// The rubric's tolerances with share 1, then each wider and of a lower share than the one before.
    pub bands: Vec<Band>,
    /// Whether playback earns the mean of its frames' shares; otherwise the share of its worst frame.
    pub share_of_frames: bool,
    /// Whether playback is also judged by the submission's own keyframes where those lost points.
    pub follow_through: bool,
    /// Whether keyframes are compared in the order that loses the fewest points; otherwise index by index.
    pub align_keyframes: bool,
}

impl Credit {
    /// Full points within the tolerances, and a lower share within each of the wider bands.
    #[must_use]
    pub fn new(tolerances: Tolerances, wider: Vec<Band>) -> Self {
        let bands = [Band { tolerances, share: 1.0 }].into_iter().chain(wider).collect();
        Self { bands, share_of_frames: false, follow_through: false, align_keyframes: false }
    }

    /// The share that errors in scene units and in degrees earn: that of the first band that holds both. What is beyond every band, or NaN,
    /// earns nothing.
    #[must_use]
    pub fn share(&self, units: f64, degrees: f64) -> f64 {
        let holds = |band: &&Band| units <= band.tolerances.translation && degrees <= band.tolerances.rotation_degrees;
        self.bands.iter().find(holds).map_or(0.0, |band| band.share)
    }
}

/// The first band of a rubric that is not wider than the one before, or not of a lower share: a sentence.
pub(super) fn problem(tolerances: Tolerances, bands: &[Band]) -> Option<String> {
    let mut before = Band { tolerances, share: 1.0 };
    for (index, band) in bands.iter().enumerate() {
        let Band { tolerances: Tolerances { translation, rotation_degrees }, share } = *band;
        let numbers =
            [("translation", translation, 1e6), ("rotation_degrees", rotation_degrees, 1e6), ("share", share, 1.0)];
        if let Some((name, number, most)) =
            numbers.into_iter().find(|(_, number, most)| !(0.0..=*most).contains(number))
        {
            return Some(format!("bands[{index}].{name} is {number}, expected 0 to {most}"));
        }
        let what = if index == 0 { "the tolerances".to_owned() } else { format!("bands[{}]", index - 1) };
        let (wide, narrow) = (band.tolerances, before.tolerances);
        let is_narrower = wide.translation < narrow.translation || wide.rotation_degrees < narrow.rotation_degrees;
        if is_narrower || wide == narrow {
            return Some(format!("bands[{index}] is not wider than {what}"));
        }
        if share >= before.share {
            let whose = if index == 0 { "1".to_owned() } else { format!("{}, as {what} has", before.share) };
            return Some(format!("bands[{index}].share is {share}, expected less than {whose}"));
        }
        before = *band;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn band(translation: f64, rotation_degrees: f64, share: f64) -> Band {
        Band { tolerances: Tolerances { translation, rotation_degrees }, share }
    }

    #[test]
    fn the_first_band_that_holds_both_errors_gives_the_share() {
        let credit = Credit::new(Tolerances::default(), vec![band(0.01, 1.0, 0.5), band(0.1, 10.0, 0.25)]);
        for (units, degrees, share) in [
            (0.0, 0.0, 1.0),
            (0.001, 0.1, 1.0),
            (0.002, 0.0, 0.5),
            (0.0, 2.0, 0.25),
            (0.2, 0.0, 0.0),
            (f64::NAN, 0.0, 0.0),
            (0.0, f64::INFINITY, 0.0),
        ] {
            assert_eq!(credit.share(units, degrees), share, "{units} {degrees}");
        }
    }

    #[test]
    fn bands_widen_and_fall() {
        let problem = |bands: &[Band]| problem(Tolerances::default(), bands);
        assert_eq!(problem(&[band(0.01, 0.1, 0.5), band(0.01, 1.0, 0.0)]), None);
        for (bands, sentence) in [
            (vec![band(0.01, 1.0, 1.5)], "bands[0].share is 1.5, expected 0 to 1"),
            (vec![band(f64::NAN, 1.0, 0.5)], "bands[0].translation is NaN, expected 0 to 1000000"),
            (vec![band(0.001, 0.1, 0.5)], "bands[0] is not wider than the tolerances"),
            (vec![band(0.01, 1.0, 0.5), band(0.1, 0.5, 0.2)], "bands[1] is not wider than bands[0]"),
            (vec![band(0.01, 1.0, 1.0)], "bands[0].share is 1, expected less than 1"),
            (
                vec![band(0.01, 1.0, 0.5), band(0.1, 2.0, 0.5)],
                "bands[1].share is 0.5, expected less than 0.5, as bands[0] has",
            ),
        ] {
            assert_eq!(problem(&bands).as_deref(), Some(sentence));
        }
    }
}
