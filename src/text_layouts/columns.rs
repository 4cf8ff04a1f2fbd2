//! Tables: rows with numbers of keyframe and row before the seven, such as `frame_num,rbt_ind,tx,ty,tz,rw,rx,ry,rz`, with names or without.

use super::Options;
use super::counts::Counts;
use super::error::{TextError, TextProblem};
use super::layout::{FieldOrder, Layout};
use super::lexer::{Lexer, Token, not_a_number};
use super::marks::{MOST_HEADER, names};
use super::plan::{Plan, ROW};
use super::report::Certainty;
use super::structure::Structure;
use crate::text::counted;
use crate::words::{Argument, texts};

/// The header, as it is written.
pub(super) const HEADER: &str = "frame_num,rbt_ind,tx,ty,tz,rw,rx,ry,rz";
/// The first column of that header. Its numbers follow one another.
const KEYFRAME_NAME: &str = "frame_num";
/// The most columns before the seven.
const MOST_LEAD: usize = 3;

/// What a column before the seven counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    /// The keyframe, or its time: equal in all rows of a keyframe, larger in the next.
    Keyframe,
    /// The row within the keyframe.
    Node,
    /// All rows of the text.
    Running,
}

/// The columns of a table.
#[derive(Clone, Debug)]
pub(super) struct Columns {
    /// The role and the name of each column before the seven.
    lead: Vec<(Role, String)>,
    /// The byte offset of the first row.
    from: usize,
    has_names: bool,
    order: Option<(FieldOrder, bool)>,
}

/// The names of columns before the first number.
fn first_names(bytes: &[u8], structure: &Structure) -> Option<Vec<String>> {
    let (at, text) = structure.first_other_mark(bytes)?;
    if structure.numbers > 0 && at > structure.first_at { None } else { names(text) }
}

/// Whether a table holds samples of playback instead of keyframes.
pub(super) fn are_samples(bytes: &[u8], structure: &Structure) -> bool {
    first_names(bytes, structure).is_some_and(|names| names.iter().any(|name| name == "key_time"))
}

/// The order of fields that names of columns tell, and whether w is the last of the four.
pub(super) fn named_order(bytes: &[u8], structure: &Structure) -> Option<(FieldOrder, bool)> {
    order_of(&first_names(bytes, structure)?)
}

fn order_of(names: &[String]) -> Option<(FieldOrder, bool)> {
    let seven = names.get(names.len().checked_sub(ROW)?..)?;
    let letters: String =
        seven.iter().filter_map(|name| name.chars().rfind(|c| matches!(c, 'w' | 'x' | 'y' | 'z'))).collect();
    let first = |place: usize| seven[place].chars().next();
    match letters.as_str() {
        "wxyzxyz" => Some((FieldOrder::QuaternionFirst, false)),
        "xyzxyzw" => Some((FieldOrder::TranslationFirst, true)),
        // w belongs to the three whose names begin as its own does.
        "xyzwxyz" if first(3) == first(0) && first(3) != first(4) => Some((FieldOrder::QuaternionFirst, true)),
        "xyzwxyz" => Some((FieldOrder::TranslationFirst, false)),
        _ => None,
    }
}

impl Columns {
    /// The columns, if names say that there are more than seven, or if all lines have so many numbers, and the first ones count rows or
    /// keyframes.
    pub(super) fn find(bytes: &[u8], structure: &Structure) -> Option<Self> {
        let names = first_names(bytes, structure);
        let has_names = names.is_some();
        let has_header = (1..=MOST_HEADER).contains(&structure.first_lines[0]) && structure.lines > 1;
        let in_line = structure.every_line[usize::from(has_header)];
        let in_line = if has_names { names.as_ref().map(Vec::len) } else { in_line };
        let lead = in_line?.checked_sub(ROW).filter(|lead| (1..=MOST_LEAD).contains(lead))?;
        let from = structure.first_lines_at[usize::from(has_header)];
        let is_known = names.as_ref().is_some_and(|names| names[0] == KEYFRAME_NAME && lead == 2);
        let counted = if is_known { None } else { roles(bytes, from, lead) };
        let roles = counted.or_else(|| has_names.then(|| default_roles(lead)))?;
        let names = names.filter(|names| names[..lead].iter().any(|name| !name.is_empty()));
        let name = |place: usize, role: Role| match (&names, role) {
            (Some(names), _) if !names[place].is_empty() => names[place].clone(),
            (_, Role::Keyframe) => "keyframe number".to_owned(),
            (_, Role::Node | Role::Running) => "row number".to_owned(),
        };
        let lead = roles.into_iter().enumerate().map(|(place, role)| (role, name(place, role))).collect();
        Some(Self { lead, from, has_names, order: named_order(bytes, structure) })
    }

    fn width(&self) -> usize {
        self.lead.len() + ROW
    }
}

/// Keyframe, then row.
fn default_roles(lead: usize) -> Vec<Role> {
    [Role::Running, Role::Keyframe, Role::Node][MOST_LEAD - lead..].to_vec()
}

/// What each column counts, by the first rows; `None` if one counts nothing.
fn roles(bytes: &[u8], from: usize, lead: usize) -> Option<Vec<Role>> {
    let mut rows = super::rows::of_width(bytes, from, lead + ROW).fuse();
    let (first, second) = (rows.next()?, rows.next()?);
    let mut roles: Vec<Role> = first[..lead]
        .iter()
        .zip(&second)
        .map(|(&first, &second)| match second - first {
            0.0 => Some(Role::Keyframe),
            1.0 if first == 0.0 || first == 1.0 => Some(Role::Running),
            _ => None,
        })
        .collect::<Option<_>>()?;
    // A column that begins again counts the rows of a keyframe. Numbers and times of keyframes do not become smaller.
    let mut before = second;
    for row in rows {
        for (column, role) in roles.iter_mut().enumerate() {
            match role {
                Role::Running if row[column] == first[column] => *role = Role::Node,
                Role::Keyframe if row[column] < before[column] => return None,
                _ => {}
            }
        }
        before = row;
    }
    let is_counted = roles.iter().any(|&role| role != Role::Keyframe);
    (is_counted || lead == 1).then_some(roles)
}

/// The plan of the rows.
///
/// # Errors
/// The first error; when salvaging, only if no keyframe is complete.
pub(super) fn plan(bytes: &[u8], columns: &Columns, counts: &Counts, options: &Options) -> Result<Plan, TextError> {
    let mut counter = Counter::new(columns, counts);
    let mut row = Row::default();
    let mut end = bytes.len();
    let mut outcome = Ok(());
    for piece in Lexer::new(bytes, columns.from) {
        outcome = match piece.token {
            Token::Number(value) if value.is_finite() => row.push(bytes, piece.at, value, columns),
            Token::Separator(_) if row.columns > 0 => Ok(()),
            Token::Mark(_) => Ok(()),
            Token::LineEnd => row.finish(bytes, piece.at, &mut counter),
            _ => Err(not_a_number(bytes, piece, texts::TEXT_EXPECTED_NUMBER)),
        };
        if outcome.is_err() {
            end = piece.at;
            break;
        }
    }
    if outcome.is_ok() {
        outcome = row.finish(bytes, bytes.len(), &mut counter).and_then(|()| counter.finish(bytes));
    }
    let (nodes, keyframes) = (counter.nodes.unwrap_or(counts.own()), counter.whole_keyframes());
    let mut plan = Plan {
        layout: Layout::Csv,
        from: columns.from,
        end,
        skip: 0,
        lead: columns.lead.len(),
        nodes,
        keyframes,
        named_order: columns.order.map(|(order, _)| order),
        is_w_last: columns.order.is_some_and(|(_, is_w_last)| is_w_last),
        findings: Vec::new(),
    };
    plan.find(Certainty::Sure, columns.finding(nodes));
    match outcome {
        Err(problem) if !options.salvage || keyframes == 0 => Err(problem),
        Err(problem) => {
            plan.find(Certainty::Warning, format!("salvaged: the rest is not read from here: {problem}"));
            Ok(plan)
        }
        Ok(()) => Ok(plan),
    }
}

impl Columns {
    /// What counts the nodes.
    fn finding(&self, nodes: usize) -> String {
        let counts = self.lead.iter().find(|(role, _)| *role == Role::Node).or(self.lead.first());
        let name = counts.map_or("", |(_, name)| name);
        if self.has_names {
            format!("layout: CSV by its header; {name} counts {nodes} nodes")
        } else {
            let columns = counted(self.lead.len(), "column");
            format!("layout: CSV without a header, with {columns} before the seven numbers; {nodes} nodes")
        }
    }
}

/// A row as far as it was read.
#[derive(Default)]
struct Row {
    at: usize,
    columns: usize,
    index: [f32; MOST_LEAD],
    index_at: [usize; MOST_LEAD],
}

impl Row {
    fn push(&mut self, bytes: &[u8], at: usize, value: f32, columns: &Columns) -> Result<(), TextError> {
        let width = columns.width();
        if self.columns == 0 {
            self.at = at;
        }
        if self.columns == width {
            let (found, expected) = (value.into(), texts::text_found_end_of_line(width).into());
            return Err(TextError::new(bytes, at, TextProblem::Unexpected { found, expected }));
        }
        if let Some(index) = self.index.get_mut(self.columns) {
            (*index, self.index_at[self.columns]) = (value, at);
        }
        self.columns += 1;
        Ok(())
    }

    fn finish(&mut self, bytes: &[u8], at: usize, counter: &mut Counter<'_>) -> Result<(), TextError> {
        let row = std::mem::take(self);
        let width = counter.columns.width();
        if row.columns == 0 {
            return Ok(());
        }
        if row.columns == width {
            return counter.row(bytes, &row);
        }
        let found = texts::text_found_end_of_line(row.columns).into();
        let expected = texts::text_expected_numbers(width).into();
        Err(TextError::new(bytes, at, TextProblem::Unexpected { found, expected }))
    }
}

/// Counts keyframes and nodes by the columns before the seven.
struct Counter<'a> {
    columns: &'a Columns,
    counts: &'a Counts,
    nodes: Option<usize>,
    keyframes: usize,
    in_keyframe: usize,
    rows: usize,
    /// The values of the columns in the first row of the text, and of the keyframe.
    first: [f32; MOST_LEAD],
    here: [f32; MOST_LEAD],
    row_at: usize,
}

impl<'a> Counter<'a> {
    fn new(columns: &'a Columns, counts: &'a Counts) -> Self {
        Self {
            columns,
            counts,
            nodes: None,
            keyframes: 0,
            in_keyframe: 0,
            rows: 0,
            first: [0.0; MOST_LEAD],
            here: [0.0; MOST_LEAD],
            row_at: 0,
        }
    }

    /// Whether a row is the first of another keyframe.
    fn begins(&self, row: &Row) -> bool {
        let roles = || self.columns.lead.iter().map(|(role, _)| *role).enumerate();
        if let Some((column, _)) = roles().find(|(_, role)| *role == Role::Keyframe) {
            return row.index[column] != self.here[column];
        }
        match roles().find(|(_, role)| *role == Role::Node) {
            Some((column, _)) => row.index[column] == self.first[column],
            None => self.in_keyframe == self.counts.own(),
        }
    }

    fn row(&mut self, bytes: &[u8], row: &Row) -> Result<(), TextError> {
        let unexpected = |column: usize, expected: Argument| {
            let found = format!("{} {}", self.columns.lead[column].1, row.index[column]).into();
            TextError::new(bytes, row.index_at[column], TextProblem::Unexpected { found, expected })
        };
        if self.rows == 0 {
            for (column, (role, name)) in self.columns.lead.iter().enumerate() {
                let value = row.index[column];
                let is_count = *role != Role::Keyframe || name == KEYFRAME_NAME;
                if is_count && value.fract() != 0.0 {
                    return Err(unexpected(column, texts::TEXT_EXPECTED_WHOLE_NUMBER.into()));
                }
            }
            (self.first, self.here) = (row.index, row.index);
        } else if self.begins(row) {
            let nodes = self.in_keyframe;
            if nodes != self.nodes.unwrap_or(nodes) {
                let counting = |(role, _): &&(Role, String)| *role == Role::Node;
                let name = self.columns.lead.iter().find(counting).map_or("row number", |(_, name)| name.as_str());
                return Err(unexpected(0, texts::text_expected_row(name, nodes, self.keyframes).into()));
            }
            self.check_keyframe_columns(row, &unexpected)?;
            self.whole(bytes)?;
            (self.here, self.in_keyframe) = (row.index, 0);
        }
        self.check_row_columns(row, &unexpected)?;
        self.in_keyframe += 1;
        self.rows += 1;
        self.row_at = row.at;
        Ok(())
    }

    /// The numbers of keyframes follow one another; times grow.
    fn check_keyframe_columns(
        &self,
        row: &Row,
        unexpected: &dyn Fn(usize, Argument) -> TextError,
    ) -> Result<(), TextError> {
        for (column, (role, name)) in self.columns.lead.iter().enumerate() {
            let (found, before) = (row.index[column], self.here[column]);
            let is_good = if name == KEYFRAME_NAME { found == before + 1.0 } else { found > before };
            if *role == Role::Keyframe && !is_good {
                return Err(unexpected(column, (before + 1.0).into()));
            }
        }
        Ok(())
    }

    fn check_row_columns(&self, row: &Row, unexpected: &dyn Fn(usize, Argument) -> TextError) -> Result<(), TextError> {
        let is_full = self.nodes == Some(self.in_keyframe);
        for (column, (role, _)) in self.columns.lead.iter().enumerate() {
            #[expect(clippy::cast_precision_loss, reason = "texts have far fewer than 2^24 rows")]
            let expected = match role {
                Role::Keyframe => self.here[column],
                Role::Node => self.first[column] + self.in_keyframe as f32,
                Role::Running => self.first[column] + self.rows as f32,
            };
            if row.index[column] != expected || *role == Role::Node && is_full {
                let expected = if is_full { texts::TEXT_EXPECTED_NEXT_FRAME.into() } else { expected.into() };
                return Err(unexpected(column, expected));
            }
        }
        Ok(())
    }

    /// The first keyframe defines the number of nodes.
    fn whole(&mut self, bytes: &[u8]) -> Result<(), TextError> {
        let found = self.in_keyframe;
        if !self.counts.accept(found) {
            let expected = self.counts.in_words();
            return Err(TextError::new(bytes, self.row_at, TextProblem::NodeCount { found, expected }));
        }
        self.nodes = Some(found);
        self.keyframes += 1;
        Ok(())
    }

    fn finish(&mut self, bytes: &[u8]) -> Result<(), TextError> {
        if self.in_keyframe == 0 {
            return Ok(());
        }
        match self.nodes {
            Some(nodes) if nodes != self.in_keyframe => {
                let found = (self.keyframes * nodes + self.in_keyframe) * ROW;
                let problem = TextProblem::Incomplete { found, nodes, width: ROW, hint: None };
                Err(TextError::new(bytes, bytes.len(), problem))
            }
            _ => self.whole(bytes).inspect(|()| self.in_keyframe = 0),
        }
    }

    /// The number of complete keyframes, including the one being read if it is complete.
    fn whole_keyframes(&self) -> usize {
        self.keyframes + usize::from(self.nodes.is_some_and(|nodes| nodes == self.in_keyframe))
    }
}
