//! Undo and redo: document snapshots that share what did not change.

use std::sync::Arc;

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

/// How far undo and redo lead. Positions count steps that were made and not undone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reach {
    /// The first position.
    pub first: u64,
    /// The present one.
    pub position: u64,
    /// The last position.
    pub last: u64,
}

#[derive(Clone, Debug)]
struct Step {
    document: Document,
    label: Phrase,
}

/// Steps, the latest on top. Copies share their steps, so that a copy costs nothing.
#[derive(Clone, Debug, Default)]
struct Stack {
    top: Option<Arc<Link>>,
    /// How many steps may be taken off.
    len: usize,
    /// How many there are: those below the last [`MOST_STEPS`] are forgotten now and then.
    linked: usize,
}

#[derive(Clone, Debug)]
struct Link {
    step: Step,
    below: Option<Arc<Link>>,
}

impl Stack {
    fn push(&mut self, step: Step) {
        self.top = Some(Arc::new(Link { step, below: self.top.take() }));
        self.len = (self.len + 1).min(MOST_STEPS);
        self.linked += 1;
        if self.linked >= 2 * MOST_STEPS {
            self.forget_below();
        }
    }

    fn pop(&mut self) -> Option<Step> {
        self.len = self.len.checked_sub(1)?;
        self.linked -= 1;
        let Link { step, below } = Arc::unwrap_or_clone(self.top.take()?);
        self.top = below;
        Some(step)
    }

    fn top(&self) -> Option<&Step> {
        self.top.as_ref().filter(|_| self.len > 0).map(|link| &link.step)
    }

    fn forget_below(&mut self) {
        let links = std::iter::successors(self.top.as_deref(), |link| link.below.as_deref());
        let kept: Vec<Step> = links.take(self.len).map(|link| link.step.clone()).collect();
        let top = kept.into_iter().rev().fold(None, |below, step| Some(Arc::new(Link { step, below })));
        *self = Self { top, len: self.len, linked: self.len };
    }
}

impl Drop for Stack {
    fn drop(&mut self) {
        // One after the other: a long list would need a deep stack of calls.
        let mut next = self.top.take();
        while let Some(mut link) = next.and_then(Arc::into_inner) {
            next = link.below.take();
        }
    }
}

/// What was before each edit, and what was undone. A copy is cheap.
#[derive(Clone, Debug, Default)]
pub struct History {
    undo: Stack,
    redo: Stack,
    run: Option<Run>,
    /// How many steps were made and not undone, also those that are forgotten.
    position: u64,
}

impl History {
    /// Records an edit that led from `before` to `after`. An edit that changed nothing is dropped; one of the same run as the
    /// last is part of that step.
    pub fn record(&mut self, before: Document, after: &Document, label: Phrase, run: Option<Run>) {
        let continues = run.is_some() && run == self.run;
        self.run = run;
        if continues {
            if self.undo.top().is_some_and(|step| step.document.same_as(after)) {
                self.undo.pop();
                self.position -= 1;
                self.run = None;
            }
            return;
        }
        if before.same_as(after) {
            self.run = None;
            return;
        }
        self.redo = Stack::default();
        self.undo.push(Step { document: before, label });
        self.position += 1;
    }

    /// Ends a run: the next edit is a step of its own.
    pub const fn end_run(&mut self) {
        self.run = None;
    }

    /// Steps back: puts the document before the last edit in place and says what was undone.
    pub fn undo(&mut self, document: &mut Document) -> Option<Phrase> {
        let step = self.undo.pop()?;
        self.position -= 1;
        self.run = None;
        self.redo.push(Step { document: std::mem::replace(document, step.document), label: step.label });
        Some(step.label)
    }

    /// Steps forward again: puts back what the last undo took away and says what it was.
    pub fn redo(&mut self, document: &mut Document) -> Option<Phrase> {
        let step = self.redo.pop()?;
        self.position += 1;
        self.run = None;
        self.undo.push(Step { document: std::mem::replace(document, step.document), label: step.label });
        Some(step.label)
    }

    /// Forgets all steps.
    pub fn forget(&mut self) {
        *self = Self { position: self.position, ..Self::default() };
    }

    /// The positions that undo and redo lead to, and the one between them.
    pub fn reach(&self) -> Reach {
        let (undo, redo) = (self.undo.len as u64, self.redo.len as u64);
        Reach { first: self.position - undo, position: self.position, last: self.position + redo }
    }

    /// What the next undo would take back.
    #[must_use]
    pub fn undo_label(&self) -> Option<Phrase> {
        self.undo.top().map(|step| step.label)
    }

    /// What the next redo would bring back.
    #[must_use]
    pub fn redo_label(&self) -> Option<Phrase> {
        self.redo.top().map(|step| step.label)
    }
}
