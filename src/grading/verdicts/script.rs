//! The verdict on the hotkey script.

use super::{Marker, UNREADABLE};
use crate::grading::folder;
use crate::grading::item::{Evidence, Verdict};
use crate::grading::parsed::ParsedFile;
use crate::grading::trace;

impl Marker<'_> {
    /// A trace decides; without one the submission's own script, or what the rubric's script does with its keyframes.
    pub(super) fn script(&self) -> Verdict {
        let Some(script) = &self.rubric.script else { return Verdict::unmet("The rubric has no script.") };
        let expected = match &script.expected {
            Ok(expected) => expected,
            Err(problem) => return Verdict::unmet(problem),
        };
        let (evidence, what, problem_at, found) = if let Some(ParsedFile { name, content }) = &self.parsed.trace {
            (Evidence::Trace, name.clone(), name, content.clone())
        } else if let (Some(ParsedFile { name, .. }), Some(ran)) =
            (&self.parsed.script, self.parsed.ran(self.rubric, self.scene))
        {
            (Evidence::Script, name.clone(), name, ran.map(|ran| trace::objects_of(&ran.trace)))
        } else {
            let Ok(read) = &self.parsed.keyframes else { return Verdict::unmet(UNREADABLE) };
            let ran = folder::run(&script.lines, self.scene, Some(&read.with_pace_of(self.rubric, self.scene)));
            let what = format!("the script with {}", read.file);
            (Evidence::Assumed, what, &read.file, ran.map(|ran| trace::objects_of(&ran.trace)))
        };
        let verdict = match found {
            Ok(found) => trace::compared(&what, &found, expected),
            Err(problem) => Verdict::unmet(format!("{problem_at}: {problem}.")),
        };
        verdict.by(evidence)
    }
}
