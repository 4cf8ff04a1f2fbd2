//! Notes: what a grader should know of a submission beside its points.

/// A note on a submission.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// Sentences.
    pub text: String,
    /// Whether a person should look at the submission because of it; otherwise it only says what was done.
    pub wants_a_look: bool,
}

impl Note {
    /// A note that says what was done.
    pub fn quiet(text: impl Into<String>) -> Self {
        Self { text: text.into(), wants_a_look: false }
    }

    /// A note because of which a person should look at the submission.
    pub fn to_look_at(text: impl Into<String>) -> Self {
        Self { text: text.into(), wants_a_look: true }
    }
}
