//! Keyframes between marks: lines such as `frame 3`, `end` or `****`.

use super::error::{TextError, TextProblem, quoted};
use super::header;
use super::layout::Layout;
use super::marks::{MOST_HEADER, MarkKind, Marks};
use super::plan::{Plan, Planner, ROW, unused};
use super::report::Certainty;
use super::structure::Irregular;
use crate::words::texts;

impl Planner<'_> {
    fn nodes_in(&self, numbers: usize) -> Option<usize> {
        let nodes = numbers / ROW;
        (numbers.is_multiple_of(ROW) && self.counts.accept(nodes)).then_some(nodes)
    }

    /// Whether keyframes stand between marks that are neither `frame` nor `end`.
    pub(super) fn are_divided_by_other_marks(&self) -> bool {
        let marks = &self.structure.other;
        let first = marks.first_blocks[0];
        let is_keyframe = |numbers: usize| self.nodes_in(numbers).is_some();
        marks.blocks > 1
            && (is_keyframe(marks.first_blocks[1])
                || is_keyframe(first)
                || (1..=MOST_HEADER).any(|header| first > header && is_keyframe(first - header)))
    }

    /// Keyframes between marks.
    pub(super) fn marked(&self, marks: &Marks) -> Result<Plan, TextError> {
        let [mut first, second] = marks.first_blocks;
        let has_second = marks.blocks > 1;
        let mut skip = marks.lead;
        if skip == 0 && self.nodes_in(first).is_none() {
            let rest = (1..=MOST_HEADER).filter(|header| first > *header).map(|header| (header, first - header));
            let fits = |rest: usize| if has_second { rest == second } else { self.nodes_in(rest).is_some() };
            if let Some((header, rest)) = rest.into_iter().find(|&(_, rest)| fits(rest)) {
                (skip, first) = (header, rest);
            }
        }
        let nodes = self.nodes_in(first).or_else(|| self.nodes_in(second).filter(|_| has_second));
        let Some(nodes) = nodes else {
            return Err(self.node_count(marks.first_blocks_at[0], first / ROW));
        };
        let expected = nodes * ROW;
        let [first_at, second_at] = marks.first_blocks_at;
        let odd = if first != expected {
            Some(Irregular { at: first_at, index: 0, found: first, expected })
        } else if has_second && second != expected {
            Some(Irregular { at: second_at, index: 1, found: second, expected })
        } else {
            marks.irregular
        };
        let [text_at, text_end] = marks.first;
        let text = &self.bytes[text_at..text_end];
        let layout = match MarkKind::of(text) {
            MarkKind::Frame => Layout::Frames,
            MarkKind::End => Layout::End,
            MarkKind::Other => Layout::Rows,
        };
        let mut plan = self.new_plan(layout, skip, nodes, marks.blocks);
        if let Some(Irregular { at, index, found, expected }) = odd {
            if !self.options.salvage || index == 0 {
                return Err(self.error(at, TextProblem::KeyframeLength { keyframe: index, found, expected }));
            }
            plan.keyframes = index;
            plan.find(
                Certainty::Warning,
                format!("salvaged: keyframe {index} is not whole: it and those after it are left out"),
            );
        }
        self.check_lead(&mut plan, marks.blocks)?;
        plan.find(
            Certainty::Sure,
            format!("layout: lines such as {} divide the keyframes, each of {nodes} nodes", quoted(text)),
        );
        if let Some((found, expected)) = marks.out_of_turn {
            plan.find(
                Certainty::Warning,
                format!("a line says frame {found} where frame {expected} was expected: the order of the file counts"),
            );
        }
        Ok(plan)
    }

    /// Compares a header before marked keyframes with them.
    fn check_lead(&self, plan: &mut Plan, blocks: usize) -> Result<(), TextError> {
        #[expect(clippy::cast_precision_loss, reason = "counts that are equal to a number of a header are small")]
        let (keyframes, nodes) = (blocks as f32, plan.nodes as f32);
        #[expect(clippy::cast_precision_loss, reason = "counts are small")]
        let is_count = |number: f32| number != keyframes && self.counts.all().any(|count| count as f32 == number);
        let numbers = &self.structure.first[..plan.skip];
        match numbers {
            [] => Ok(()),
            [one] if *one == keyframes || *one == nodes => Ok(()),
            [first, second] if [[*first, *second], [*second, *first]].contains(&[keyframes, nodes]) => Ok(()),
            [_, _, _, ..]
                if numbers.contains(&keyframes)
                    && numbers.iter().all(|&number| number == nodes || !is_count(number)) =>
            {
                let others: Vec<f32> =
                    numbers.iter().copied().filter(|number| ![keyframes, nodes].contains(number)).collect();
                unused(plan, &others);
                Ok(())
            }
            [_, _, ..] => match header::first_two(self.structure) {
                Some((keyframes, nodes)) => self.header_disagrees(plan, keyframes, nodes),
                None => Err(self.lead_error(plan.skip)),
            },
            [_] => Err(self.lead_error(plan.skip)),
        }
    }

    fn lead_error(&self, skip: usize) -> TextError {
        let found = texts::count_numbers(skip).into();
        let expected = texts::TEXT_EXPECTED_FRAME_OR_HEADER.into();
        self.error(self.structure.first_at, TextProblem::Unexpected { found, expected })
    }
}
