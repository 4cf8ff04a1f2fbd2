//! Infers how the numbers of a text form keyframes: the layout, the header, and the number of nodes per keyframe.

use super::Options;
use super::columns::{self, Columns};
use super::counts::Counts;
use super::error::{TextError, TextProblem, in_rows};
use super::header::{self, Header};
use super::joints;
use super::layout::{FieldOrder, Layout};
use super::marks::MOST_HEADER;
use super::report::{Certainty, Finding};
use super::rows;
use super::structure::{Structure, structure as structure_of};
use crate::rotation_rules::RECOGNISED;
use crate::scene::SceneGraph;
use crate::text::listed;
use crate::words::texts;

/// Numbers per row: a translation and a quaternion.
pub(super) const ROW: usize = 7;
/// Numbers per matrix.
const MATRIX: usize = 16;
/// The inferred structure of a text.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    /// The layout that the text is in.
    pub(super) layout: Layout,
    /// The byte offset of the first line with numbers to be read.
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
    /// The order of the numbers that the names of columns tell.
    pub(super) named_order: Option<FieldOrder>,
    /// Whether w is the last number of the quaternion.
    pub(super) is_w_last: bool,
    /// The inferences so far.
    pub(super) findings: Vec<Finding>,
}

impl Plan {
    pub(super) fn find(&mut self, certainty: Certainty, text: impl Into<String>) {
        self.findings.push(Finding { certainty, text: text.into() });
    }
}

/// What is known of a text before its plan.
pub(super) struct Planner<'a> {
    pub(super) bytes: &'a [u8],
    scene: &'a SceneGraph,
    pub(super) structure: &'a Structure,
    pub(super) counts: Counts,
    pub(super) options: &'a Options,
}

/// The plan of a text.
///
/// # Errors
/// The first error.
pub(super) fn plan(bytes: &[u8], scene: &SceneGraph, options: &Options) -> Result<Plan, TextError> {
    let mut structure = structure_of(bytes);
    if let Some(error) =
        structure.problem.clone().filter(|error| matches!(error.problem, TextProblem::DecimalComma { .. }))
    {
        return Err(error);
    }
    let odd = structure.odd_mark(bytes);
    if columns::are_samples(bytes, &structure)
        && let Some(error) = structure.unexpected_mark(bytes)
    {
        return Err(error);
    }
    let counts = Counts::new(scene, options);
    if let Some(columns) = Columns::find(bytes, &structure) {
        let plan = columns::plan(bytes, &columns, &counts, options);
        let plan = plan.and_then(|plan| confirmed(bytes, plan, &structure, &counts, scene));
        return plan.map_err(|error| odd.map_or(error, |(_, odd)| odd));
    }
    if let (true, Some((at, error))) = (options.salvage, &odd) {
        structure = structure_of(&bytes[..*at]);
        structure.problem.get_or_insert_with(|| error.clone());
    }
    if let Some(problem) = structure.problem.clone().filter(|_| !options.salvage || structure.numbers == 0) {
        return Err(problem);
    }
    if structure.numbers == 0 {
        return Err(odd.map_or_else(|| TextError::new(bytes, 0, TextProblem::Empty), |(_, error)| error));
    }
    let planner = Planner { bytes, scene, structure: &structure, counts, options };
    let plan = if let Some(plan) = planner.matrices() {
        plan
    } else if structure.named.divide() {
        planner.marked(&structure.named)
    } else if planner.are_divided_by_other_marks() {
        planner.marked(&structure.other)
    } else {
        planner.unmarked()
    };
    let plan = plan.and_then(|plan| confirmed(bytes, plan, &structure, &planner.counts, scene));
    let mut plan = plan.map_err(|error| odd.map_or(error, |(_, odd)| odd))?;
    if let Some(problem) = &structure.problem {
        plan.find(Certainty::Warning, format!("salvaged: the rest is not read from here: {problem}"));
    }
    Ok(plan)
}

/// The plan, if its number of nodes needs no offsets to confirm it, or they do.
fn confirmed(
    bytes: &[u8],
    plan: Plan,
    structure: &Structure,
    counts: &Counts,
    scene: &SceneGraph,
) -> Result<Plan, TextError> {
    if !counts.needs_offsets(plan.nodes) || joints::fit(&rows::first_offsets(bytes, &plan), scene).is_some() {
        return Ok(plan);
    }
    let problem = TextProblem::NodeCount { found: plan.nodes, expected: counts.in_words() };
    Err(TextError::new(bytes, structure.first_at, problem))
}

impl Planner<'_> {
    pub(super) fn error(&self, at: usize, problem: TextProblem) -> TextError {
        TextError::new(self.bytes, at, problem)
    }

    pub(super) fn new_plan(&self, layout: Layout, skip: usize, nodes: usize, keyframes: usize) -> Plan {
        Plan {
            layout,
            from: 0,
            end: self.structure.end,
            skip,
            lead: 0,
            nodes,
            keyframes,
            named_order: columns::named_order(self.bytes, self.structure).map(|(order, _)| order),
            is_w_last: columns::named_order(self.bytes, self.structure).is_some_and(|(_, is_w_last)| is_w_last),
            findings: Vec::new(),
        }
    }

    pub(super) fn node_count(&self, at: usize, found: usize) -> TextError {
        self.error(at, TextProblem::NodeCount { found, expected: self.counts.in_words() })
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
        if !is_affine || ![0, 4, 8].into_iter().all(is_unit) || structure.named.divide() {
            return None;
        }
        let nodes =
            self.nodes_by_line(MATRIX).or_else(|| self.nodes_by_whole_line(MATRIX)).unwrap_or(self.counts.own());
        let found = structure.numbers;
        let mut plan = self.new_plan(Layout::Matrices, 0, nodes, found / (nodes * MATRIX));
        if !found.is_multiple_of(nodes * MATRIX) {
            if let Err(error) = self.incomplete(nodes, MATRIX) {
                return Some(Err(error));
            }
            plan.find(Certainty::Warning, "salvaged: the last keyframe is not whole and is left out");
        }
        plan.find(Certainty::Sure, "layout: matrices in column order: the first has the bottom row 0 0 0 1");
        Some(Ok(plan))
    }

    /// The number of nodes that each line has.
    fn nodes_by_line(&self, width: usize) -> Option<usize> {
        self.nodes_of(self.structure.every_line[0], width)
    }

    /// The number of nodes that each line has but the last, within which the text ends.
    fn nodes_by_whole_line(&self, width: usize) -> Option<usize> {
        self.nodes_of(self.structure.every_whole_line, width)
    }

    fn nodes_of(&self, numbers: Option<usize>, width: usize) -> Option<usize> {
        let nodes = numbers.filter(|numbers| numbers.is_multiple_of(width))? / width;
        self.counts.accept(nodes).then_some(nodes)
    }

    /// The error of numbers that do not make whole keyframes, unless they are salvaged.
    fn incomplete(&self, nodes: usize, width: usize) -> Result<(), TextError> {
        if self.options.salvage {
            return Ok(());
        }
        let structure = self.structure;
        let at = structure.irregular_line.map_or(structure.end, |line| line.at);
        let (found, hint) = (structure.numbers, structure.hint(self.bytes));
        Err(self.error(at, TextProblem::Incomplete { found, nodes, width, hint }))
    }

    pub(super) fn header_disagrees(&self, plan: &mut Plan, keyframes: usize, nodes: usize) -> Result<(), TextError> {
        let found = self.structure.numbers - plan.skip;
        if !self.options.salvage {
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
        if let Some(header) = header::find(structure, ROW, &self.counts) {
            return Ok(self.with_header(header));
        }
        if let Some((keyframes, nodes)) = header::first_two(structure) {
            if keyframes.checked_mul(nodes).and_then(|rows| rows.checked_mul(ROW)) == Some(found - 2) {
                return Err(self.node_count(structure.first_at, nodes));
            }
            let [first_line, second_line, third_line, _] = structure.first_lines;
            let has_more = (3..=MOST_HEADER).contains(&first_line) && structure.every_line[1] > Some(first_line);
            let stands_apart = first_line == 2 || (first_line, second_line) == (1, 1) && third_line > 1 || has_more;
            let is_plausible =
                self.counts.accept(nodes) && keyframes > 0 && !found.is_multiple_of(self.counts.own() * ROW);
            if stands_apart || is_plausible {
                if !self.counts.accept(nodes) && self.options.salvage {
                    return Err(self.node_count(structure.first_at, nodes));
                }
                let skip = if has_more { first_line } else { 2 };
                let whole = (found - skip) / (nodes * ROW).max(1);
                let mut plan = self.new_plan(self.header_layout(2), skip, nodes, whole);
                self.header_disagrees(&mut plan, keyframes, nodes)?;
                return Ok(plan);
            }
        }
        self.without_header()
    }

    fn with_header(&self, header: Header) -> Plan {
        let Header { skip, keyframes, nodes, says_keyframes, says_nodes, .. } = header;
        let mut plan = self.new_plan(self.header_layout(skip), skip, nodes, keyframes);
        let count = texts::count_keyframes(keyframes);
        match (says_keyframes, says_nodes) {
            (true, true) => {
                plan.find(Certainty::Sure, format!("header: {count} of {nodes} nodes, as many numbers as follow"));
            }
            (true, false) => {
                plan.find(
                    Certainty::Likely,
                    format!("header: {count}; the numbers that follow make {nodes} nodes each"),
                );
            }
            (false, _) => {
                plan.find(Certainty::Likely, format!("header: {nodes} nodes; the numbers that follow make {count}"));
            }
        }
        unused(&mut plan, &header.unused);
        plan
    }

    fn header_layout(&self, skip: usize) -> Layout {
        let [first, second, third, fourth] = self.structure.first_lines;
        if self.structure.named.ends > 0 {
            return Layout::End;
        }
        let (next, after) = match first {
            1 if skip == 2 => (third, fourth),
            _ => (second, third),
        };
        match (next, after) {
            _ if first != skip && (first, skip) != (1, 2) => Layout::Header,
            (3, 4) | (4, 3) => Layout::HeaderTwoLines,
            (rows, _) if rows > ROW && rows.is_multiple_of(ROW) => Layout::HeaderKeyframeALine,
            _ => Layout::Header,
        }
    }

    fn without_header(&self) -> Result<Plan, TextError> {
        let structure = self.structure;
        let found = structure.numbers;
        let layout = match structure {
            Structure { splits_rows: true, .. } => Layout::Pairs,
            Structure { ends_rows: true, has_commas: true, .. } => Layout::Endless,
            _ if structure.named.ends > 0 => Layout::End,
            _ => Layout::Rows,
        };
        let plan = |nodes: usize| self.new_plan(layout, 0, nodes, found / (nodes * ROW));
        let by_line = self.nodes_by_line(ROW);
        let whole = || self.counts.all().filter(|nodes| found.is_multiple_of(nodes * ROW));
        let persists = |&nodes: &usize| rows::offsets_persist(self.bytes, &plan(nodes));
        let fits = |&nodes: &usize| self.fits_joints(&plan(nodes));
        // Joints may be moved in an animation, but then the scene's own number must fit.
        let own = || whole().find(|nodes| *nodes == self.counts.own() && fits(nodes));
        let by_count = whole().find(|nodes| fits(nodes) && persists(nodes)).or_else(own);
        let mut likely = whole().filter(|&nodes| !self.counts.needs_offsets(nodes));
        let persistent = || likely.find(persists);
        let guessed = by_line.or(by_count).or_else(persistent);
        let Some(nodes) = guessed else {
            return self.not_guessed(plan);
        };
        let mut plan = plan(nodes);
        if by_line.is_some() || by_count.is_some() || nodes == self.counts.own() {
            self.find_nodes(&mut plan, by_line.is_some());
        } else {
            let keyframes = texts::count_keyframes(plan.keyframes);
            plan.find(
                Certainty::Warning,
                format!("no header: the rows make whole keyframes only with {nodes} nodes: {keyframes}"),
            );
        }
        Ok(plan)
    }

    /// Says why the keyframes of a text without a header have so many nodes: their lines, the scene or the offsets say so.
    fn find_nodes(&self, plan: &mut Plan, is_by_line: bool) {
        let (nodes, keyframes) = (plan.nodes, texts::count_keyframes(plan.keyframes));
        let why = if nodes == self.counts.own() {
            format!("no header: with {nodes} nodes, as the scene has, the rows make {keyframes}")
        } else if is_by_line {
            format!("no header: each line has {nodes} nodes, which makes {keyframes}")
        } else {
            format!("no header: {nodes} nodes, as the offsets of keyframe 0 show, make {keyframes}")
        };
        plan.find(Certainty::Likely, why);
    }

    /// Whether the offsets of keyframe 0 fit the scene. A list of joints decides without them.
    fn fits_joints(&self, plan: &Plan) -> bool {
        let fit = || joints::fit(&rows::first_offsets(self.bytes, plan), self.scene);
        let needs_offsets = self.counts.needs_offsets(plan.nodes);
        self.options.joints.is_some() || fit().is_some_and(|fit| fit.without_row.is_empty() != needs_offsets)
    }

    /// The end of guesses without a header: the rows make no whole keyframes, or only some that look like none.
    fn not_guessed(&self, plan: impl Fn(usize) -> Plan) -> Result<Plan, TextError> {
        let found = self.structure.numbers;
        let own = self.counts.own();
        let is_whole = |nodes: &usize| found.is_multiple_of(nodes * ROW) && !self.counts.needs_offsets(*nodes);
        let looks_right = |nodes: &usize| {
            let plan = plan(*nodes);
            plan.keyframes > 0 && self.fits_joints(&plan) && rows::offsets_persist(self.bytes, &plan)
        };
        let by_line = self.nodes_by_whole_line(ROW);
        let cut = by_line.or_else(|| self.counts.all().find(looks_right));
        if let Some(nodes) = self.counts.all().find(is_whole).filter(|_| cut.is_none()) {
            let problem = TextProblem::Guessed { nodes, expected: self.counts.in_words() };
            return Err(self.error(self.structure.first_at, problem));
        }
        let nodes = cut.unwrap_or(own);
        self.incomplete(nodes, ROW)?;
        let mut plan = plan(nodes);
        plan.find(Certainty::Warning, "salvaged: the last keyframe is not whole and is left out");
        self.find_nodes(&mut plan, by_line.is_some());
        Ok(plan)
    }
}

/// Notes the numbers of a header that say something else.
pub(super) fn unused(plan: &mut Plan, numbers: &[f32]) {
    if !numbers.is_empty() {
        let verb = if numbers.len() == 1 { "is" } else { "are" };
        let numbers: Vec<String> = numbers.iter().map(ToString::to_string).collect();
        let numbers = listed(&numbers, "and");
        plan.find(Certainty::Note, format!("header: {numbers} {verb} not used"));
    }
}
