//! Infers how the numbers of a text form keyframes: the layout, the header, and the number of nodes per keyframe.

use super::Options;
use super::error::{TextError, TextProblem, in_rows};
use super::layout::Layout;
use super::report::{Certainty, Finding};
use super::structure::{Irregular, Structure, structure};
use crate::rotation_rules::RECOGNISED;
use crate::scene::SceneGraph;
use crate::words::{self, Argument, texts};

/// Numbers per row: a translation and a quaternion.
const ROW: usize = 7;
/// Numbers per matrix.
const MATRIX: usize = 16;
/// The number of nodes of the scene to which the course's later assignments add some.
const COURSE_NODES: usize = 22;
/// The numbers of nodes in those assignments.
const LATER_COURSE_NODES: [usize; 3] = [24, 25, 26];

/// The inferred structure of a text.
#[derive(Debug)]
pub(super) struct Plan {
    /// The layout that the text is in.
    pub(super) layout: Layout,
    /// The byte offset of the first number.
    pub(super) from: usize,
    /// The byte offset after the last number.
    pub(super) end: usize,
    /// Numbers of the header to skip.
    pub(super) skip: usize,
    /// Numbers to skip at the beginning of each row.
    pub(super) lead: usize,
    /// The number of nodes per keyframe.
    pub(super) nodes: usize,
    /// The number of keyframes.
    pub(super) keyframes: usize,
    /// The inferences so far.
    pub(super) findings: Vec<Finding>,
}

impl Plan {
    pub(super) fn find(&mut self, certainty: Certainty, text: impl Into<String>) {
        self.findings.push(Finding { certainty, text: text.into() });
    }
}

/// The possible numbers of nodes per keyframe, the most likely first.
pub(super) fn node_counts(scene: &SceneGraph, options: &Options) -> Vec<usize> {
    let own = options.joints.as_ref().map_or(scene.rbt_count(), super::JointList::rows);
    let is_course = scene.rbt_count() == COURSE_NODES;
    let mut counts = vec![own];
    counts.extend(LATER_COURSE_NODES.into_iter().filter(|&later| is_course && later > own));
    counts
}

/// The numbers of nodes in words: `22, 24, 25 or 26`.
pub(super) fn in_words(counts: &[usize]) -> Argument {
    words::one_of(&counts.iter().map(ToString::to_string).collect::<Vec<_>>())
}

struct Planner<'a> {
    bytes: &'a [u8],
    structure: &'a Structure,
    counts: Vec<usize>,
    salvage: bool,
}

/// The plan of a text that is not CSV.
///
/// # Errors
/// The first error.
pub(super) fn plan(bytes: &[u8], scene: &SceneGraph, options: &Options) -> Result<Plan, TextError> {
    let structure = structure(bytes);
    if let Some(problem) = structure.problem.clone().filter(|_| !options.salvage || structure.numbers == 0) {
        return Err(problem);
    }
    if structure.numbers == 0 {
        return Err(TextError::new(bytes, 0, TextProblem::Empty));
    }
    let planner =
        Planner { bytes, structure: &structure, counts: node_counts(scene, options), salvage: options.salvage };
    let mut plan = if let Some(plan) = planner.matrices() {
        plan?
    } else if structure.marks.divide() {
        planner.marked()?
    } else {
        planner.unmarked()?
    };
    if let Some(problem) = &structure.problem {
        plan.find(Certainty::Warning, format!("salvaged: the rest is not read from here: {problem}"));
    }
    Ok(plan)
}

impl Planner<'_> {
    fn error(&self, at: usize, problem: TextProblem) -> TextError {
        TextError::new(self.bytes, at, problem)
    }

    fn new_plan(&self, layout: Layout, skip: usize, nodes: usize, keyframes: usize) -> Plan {
        Plan { layout, from: 0, end: self.structure.end, skip, lead: 0, nodes, keyframes, findings: Vec::new() }
    }

    fn node_count(&self, at: usize, found: usize) -> TextError {
        self.error(at, TextProblem::NodeCount { found, expected: in_words(&self.counts) })
    }

    /// The first two numbers, if they can be a header.
    fn header(&self) -> Option<(usize, usize)> {
        let whole = |number: &f32| {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is whole and not negative")]
            (number.fract() == 0.0 && *number >= 0.0 && *number < 1e9).then_some(*number as usize)
        };
        Some((whole(self.structure.first.first()?)?, whole(self.structure.first.get(1)?)?))
    }

    /// Recognises matrices by their bottom rows and unit columns.
    fn matrices(&self) -> Option<Result<Plan, TextError>> {
        let structure = self.structure;
        let first: &[f32; MATRIX] = structure.first.as_slice().try_into().ok()?;
        let is_affine = [3, 7, 11].iter().all(|&index| first[index] == 0.0) && first[15] == 1.0;
        let is_unit = |column: usize| {
            let squares: f64 = first[column..column + 3].iter().map(|&number| f64::from(number).powi(2)).sum();
            (squares.sqrt() - 1.0).abs() <= RECOGNISED
        };
        if !is_affine || ![0, 4, 8].into_iter().all(is_unit) || structure.marks.divide() {
            return None;
        }
        let by_line = structure.every_line.filter(|every| every.is_multiple_of(MATRIX)).map(|every| every / MATRIX);
        let nodes = by_line.filter(|nodes| self.counts.contains(nodes)).unwrap_or(self.counts[0]);
        let found = structure.numbers;
        let mut plan = self.new_plan(Layout::Matrices, 0, nodes, found / (nodes * MATRIX));
        if !found.is_multiple_of(nodes * MATRIX) {
            if !self.salvage {
                let at = structure.irregular_line.map_or(structure.end, |line| line.at);
                let hint = structure.hint(self.bytes);
                return Some(Err(self.error(at, TextProblem::Incomplete { found, nodes, width: MATRIX, hint })));
            }
            plan.find(Certainty::Warning, "salvaged: the last keyframe is not whole and is left out");
        }
        plan.find(Certainty::Sure, "layout: matrices in column order: the first has the bottom row 0 0 0 1");
        Some(Ok(plan))
    }

    /// Keyframes between lines `frame [k]` or `end`.
    fn marked(&self) -> Result<Plan, TextError> {
        let structure = self.structure;
        let marks = &structure.marks;
        let [mut first, second] = marks.first_blocks;
        let nodes_in = |numbers: usize| {
            let nodes = numbers / ROW;
            (numbers.is_multiple_of(ROW) && self.counts.contains(&nodes)).then_some(nodes)
        };
        let mut skip = marks.lead;
        if marks.frames == 0 && nodes_in(first).is_none() && first > 2 && nodes_in(first - 2).is_some() {
            (skip, first) = (2, first - 2);
        }
        if skip != 0 && skip != 2 {
            let found = texts::count_numbers(skip).into();
            let expected = texts::TEXT_EXPECTED_FRAME_OR_HEADER.into();
            return Err(self.error(structure.first_at, TextProblem::Unexpected { found, expected }));
        }
        let has_second = marks.blocks > 1;
        let nodes = nodes_in(first).or_else(|| nodes_in(second).filter(|_| has_second));
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
        let layout = if marks.frames > 0 { Layout::Frames } else { Layout::End };
        let mut plan = self.new_plan(layout, skip, nodes, marks.blocks);
        if let Some(Irregular { at, index, found, expected }) = odd {
            if !self.salvage || index == 0 {
                return Err(self.error(at, TextProblem::KeyframeLength { keyframe: index, found, expected }));
            }
            plan.keyframes = index;
            plan.find(
                Certainty::Warning,
                format!("salvaged: keyframe {index} is not whole: it and those after it are left out"),
            );
        }
        let wrong_header = self.header().filter(|&header| skip == 2 && header != (marks.blocks, nodes));
        if let Some((keyframes, header_nodes)) = wrong_header {
            self.header_disagrees(&mut plan, keyframes, header_nodes)?;
        }
        let mark = if marks.frames > 0 { "frame [k]" } else { "end" };
        plan.find(Certainty::Sure, format!("layout: the lines \"{mark}\" divide the keyframes, each of {nodes} nodes"));
        if let Some((found, expected)) = marks.out_of_turn {
            plan.find(
                Certainty::Warning,
                format!(
                    "a line says frame [{found}] where frame [{expected}] was expected: the order of the file counts"
                ),
            );
        }
        Ok(plan)
    }

    fn header_disagrees(&self, plan: &mut Plan, keyframes: usize, nodes: usize) -> Result<(), TextError> {
        let found = self.structure.numbers - 2;
        if !self.salvage {
            let expected = keyframes.saturating_mul(nodes).saturating_mul(ROW);
            let hint = self.structure.hint(self.bytes);
            let problem = TextProblem::Header { keyframes, nodes, expected, found, hint };
            return Err(self.error(self.structure.first_at, problem));
        }
        let found = in_rows(found);
        plan.find(
            Certainty::Warning,
            format!("salvaged: the header says {keyframes} keyframes of {nodes} nodes, and {found} follow"),
        );
        Ok(())
    }

    /// One stream of numbers, with or without a header.
    fn unmarked(&self) -> Result<Plan, TextError> {
        let structure = self.structure;
        let found = structure.numbers;
        if let Some((keyframes, nodes)) = self.header() {
            if keyframes.checked_mul(nodes).and_then(|rows| rows.checked_mul(ROW)) == Some(found - 2) {
                return self.with_header(keyframes, nodes);
            }
            let [first_line, second_line, ..] = structure.first_lines;
            let stands_apart = first_line == 2 || (first_line, second_line) == (1, 1) && structure.first_lines[2] > 1;
            let is_plausible =
                self.counts.contains(&nodes) && keyframes > 0 && !found.is_multiple_of(self.counts[0] * ROW);
            if stands_apart || is_plausible {
                if !self.counts.contains(&nodes) && self.salvage {
                    return Err(self.node_count(structure.first_at, nodes));
                }
                let mut plan = self.new_plan(self.header_layout(), 2, nodes, (found - 2) / (nodes * ROW).max(1));
                self.header_disagrees(&mut plan, keyframes, nodes)?;
                return Ok(plan);
            }
        }
        self.without_header()
    }

    fn with_header(&self, keyframes: usize, nodes: usize) -> Result<Plan, TextError> {
        if keyframes > 0 && !self.counts.contains(&nodes) {
            return Err(self.node_count(self.structure.first_at, nodes));
        }
        let mut plan = self.new_plan(self.header_layout(), 2, nodes, keyframes);
        plan.find(
            Certainty::Sure,
            format!("header: {} of {nodes} nodes, as many numbers as follow", texts::count_keyframes(keyframes)),
        );
        Ok(plan)
    }

    fn header_layout(&self) -> Layout {
        let [first, second, third, fourth] = self.structure.first_lines;
        if self.structure.marks.ends > 0 {
            return Layout::End;
        }
        match (first, second, third, fourth) {
            (2, 3, 4, _) | (2, 4, 3, _) | (1, 1, 3, 4) | (1, 1, 4, 3) => Layout::HeaderTwoLines,
            (2, rows, ..) | (1, 1, rows, _) if rows > ROW && rows.is_multiple_of(ROW) => Layout::HeaderKeyframeALine,
            _ => Layout::Header,
        }
    }

    fn without_header(&self) -> Result<Plan, TextError> {
        let structure = self.structure;
        let found = structure.numbers;
        let by_line = structure
            .every_line
            .filter(|every| every.is_multiple_of(ROW) && structure.lines > 0)
            .map(|every| every / ROW)
            .filter(|nodes| self.counts.contains(nodes));
        let by_count = self.counts.iter().copied().find(|nodes| found.is_multiple_of(nodes * ROW));
        let nodes = by_line.or(by_count).unwrap_or(self.counts[0]);
        let layout = match structure {
            Structure { splits_rows: true, .. } => Layout::Pairs,
            Structure { ends_rows: true, has_commas: true, .. } => Layout::Endless,
            _ if structure.marks.ends > 0 => Layout::End,
            _ => Layout::Rows,
        };
        let mut plan = self.new_plan(layout, 0, nodes, found / (nodes * ROW));
        if !found.is_multiple_of(nodes * ROW) {
            if !self.salvage {
                let at = structure.irregular_line.map_or(structure.end, |line| line.at);
                let hint = structure.hint(self.bytes);
                return Err(self.error(at, TextProblem::Incomplete { found, nodes, width: ROW, hint }));
            }
            plan.find(Certainty::Warning, "salvaged: the last keyframe is not whole and is left out");
        }
        let keyframes = texts::count_keyframes(plan.keyframes);
        if nodes == self.counts[0] {
            plan.find(
                Certainty::Likely,
                format!("no header: with {nodes} nodes, as the scene has, the rows make {keyframes}"),
            );
        } else if by_line.is_some() {
            plan.find(Certainty::Likely, format!("no header: each line has {nodes} nodes, which makes {keyframes}"));
        } else {
            plan.find(
                Certainty::Warning,
                format!("no header: the rows make whole keyframes only with {nodes} nodes: {keyframes}"),
            );
        }
        Ok(plan)
    }
}
