//! Undo and redo: document snapshots that share what did not change.

use std::collections::VecDeque;

use super::document::Document;
use crate::words::Phrase;

/// How many steps can be undone; older ones are forgotten.
pub const MOST_STEPS: usize = 2000;

/// Edits that merge with the one before where both are of one run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Run {
    /// Presses of `+` and `-`, and drags of the milliseconds between keyframes.
    MsBetweenKeyframes,
    /// Turns of the wheel.
    Wheel,
}

#[derive(Clone, Debug)]
struct Step {
    document: Document,
    label: Phrase,
}

/// What was before each edit, and what was undone.
#[derive(Clone, Debug, Default)]
pub struct History {
    undo: VecDeque<Step>,
    redo: Vec<Step>,
    run: Option<Run>,
}

impl History {
    /// Records an edit that led from `before` to `after`. An edit that changed nothing is dropped; one of the same run as the
    /// last is part of that step.
    pub fn record(&mut self, before: Document, after: &Document, label: Phrase, run: Option<Run>) {
        let continues = run.is_some() && run == self.run;
        self.run = run;
        if continues {
            if self.undo.back().is_some_and(|step| step.document.same_as(after)) {
                self.undo.pop_back();
                self.run = None;
            }
            return;
        }
        if before.same_as(after) {
            self.run = None;
            return;
        }
        self.redo.clear();
        if self.undo.len() == MOST_STEPS {
            self.undo.pop_front();
        }
        self.undo.push_back(Step { document: before, label });
    }

    /// Ends a run: the next edit is a step of its own.
    pub const fn end_run(&mut self) {
        self.run = None;
    }

    /// Steps back: puts the document before the last edit in place and says what was undone.
    pub fn undo(&mut self, document: &mut Document) -> Option<Phrase> {
        let step = self.undo.pop_back()?;
        self.run = None;
        self.redo.push(Step { document: std::mem::replace(document, step.document), label: step.label });
        Some(step.label)
    }

    /// Steps forward again: puts back what the last undo took away and says what it was.
    pub fn redo(&mut self, document: &mut Document) -> Option<Phrase> {
        let step = self.redo.pop()?;
        self.run = None;
        self.undo.push_back(Step { document: std::mem::replace(document, step.document), label: step.label });
        Some(step.label)
    }

    /// How many steps can be undone.
    pub fn steps(&self) -> usize {
        self.undo.len()
    }

    /// Forgets steps beyond a number, and ends a run.
    pub fn forget_after(&mut self, steps: usize) {
        self.undo.truncate(steps);
        self.run = None;
    }

    /// What the next undo would take back.
    #[must_use]
    pub fn undo_label(&self) -> Option<Phrase> {
        self.undo.back().map(|step| step.label)
    }

    /// What the next redo would bring back.
    #[must_use]
    pub fn redo_label(&self) -> Option<Phrase> {
        self.redo.last().map(|step| step.label)
    }
}
