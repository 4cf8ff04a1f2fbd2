//! The numbers of requirements: their defaults and bounds.

use super::*;

const ALL: fn(Requirement) -> bool = |_| true;

#[test]
fn missing_numbers_have_their_defaults() {
    assert_eq!(RequirementsText::default().checked(|_| false), Ok(Requirements::default()));
    let some = RequirementsText { lowest_y: Some(0.0), ..RequirementsText::default() };
    let expected = Requirements { lowest_y: 0.0, ..Requirements::default() };
    assert_eq!(some.checked(|requirement| requirement == Requirement::AboveGround), Ok(expected));
}

#[test]
fn numbers_have_bounds() {
    let usual = RequirementsText::default();
    for (text, sentence) in [
        (
            RequirementsText { minimum_keyframes: Some(0), ..usual },
            "requirements.minimum_keyframes is 0, expected a whole number from 1 to 2000",
        ),
        (
            RequirementsText { minimum_nodes_moved: Some(100_001), ..usual },
            "requirements.minimum_nodes_moved is 100001, expected a whole number from 1 to 100000",
        ),
        (
            RequirementsText { lowest_y: Some(f64::NAN), ..usual },
            "requirements.lowest_y is NaN, expected -1000000 to 1000000",
        ),
        (
            RequirementsText { largest_step: Some(-0.5), ..usual },
            "requirements.largest_step is -0.5, expected 0 to 1000000",
        ),
        (
            RequirementsText { largest_step_degrees: Some(181.0), ..usual },
            "requirements.largest_step_degrees is 181, expected 0 to 180",
        ),
    ] {
        assert_eq!(text.checked(ALL), Err(sentence.to_owned()));
    }
    let text = RequirementsText { largest_step: Some(1.0), ..usual };
    assert_eq!(
        text.checked(|requirement| requirement != Requirement::NoJumps),
        Err("requirements.largest_step is there, but points.no_jumps gives no points".to_owned())
    );
}
