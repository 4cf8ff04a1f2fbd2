//! Converts rows to poses, and infers which four numbers are the quaternion.

use glam::{Mat3, Quat, Vec3};

use super::Options;
use super::error::{TextError, TextProblem};
use super::joints::match_joints;
use super::layout::{FieldOrder, Layout};
use super::lexer::numbers;
use super::plan::Plan;
use super::report::Certainty;
use crate::keyframe::Keyframe;
use crate::rbt::Rbt;
use crate::rotation_rules::{Mending, NORMALISED, RECOGNISED};
use crate::scene::SceneGraph;
use crate::words::texts;

/// Numbers per matrix.
const MATRIX: usize = 16;

/// The byte offset of a row, and its numbers.
type Row<const WIDTH: usize> = (usize, [f32; WIDTH]);

/// The rows of all complete keyframes.
fn rows<'a, const WIDTH: usize>(bytes: &'a [u8], plan: &Plan) -> impl Iterator<Item = Row<WIDTH>> + use<'a, WIDTH> {
    let mut numbers = numbers(&bytes[..plan.end], plan.from).skip(plan.skip);
    let lead = plan.lead;
    std::iter::from_fn(move || {
        for _ in 0..lead {
            numbers.next()?;
        }
        let mut row = [0.0; WIDTH];
        let (at, first) = numbers.next()?;
        row[0] = first;
        for number in &mut row[1..] {
            *number = numbers.next()?.1;
        }
        Some((at, row))
    })
    .take(plan.keyframes * plan.nodes)
}

/// All rows of so many numbers, from a byte on.
pub(super) fn of_width(bytes: &[u8], from: usize, width: usize) -> impl Iterator<Item = [f32; MATRIX]> + use<'_> {
    let mut numbers = numbers(bytes, from);
    std::iter::from_fn(move || {
        let mut row = [0.0; MATRIX];
        for number in &mut row[..width] {
            *number = numbers.next()?.1;
        }
        Some(row)
    })
}

/// The translations of keyframe 0, in the order of fields in which its rotations are of unit length; empty without keyframes.
pub(super) fn first_offsets(bytes: &[u8], plan: &Plan) -> Vec<Vec3> {
    if plan.layout == Layout::Matrices {
        return rows::<MATRIX>(bytes, plan)
            .take(plan.nodes)
            .map(|(_, row)| Vec3::new(row[12], row[13], row[14]))
            .collect();
    }
    let order = first_order(bytes, plan);
    rows(bytes, plan).take(plan.nodes).map(|(_, row)| translation(row, order)).collect()
}

fn first_order(bytes: &[u8], plan: &Plan) -> FieldOrder {
    let is_unit = rows::<7>(bytes, plan).take(plan.nodes).all(|(_, row)| (length(&row[3..]) - 1.0).abs() <= NORMALISED);
    if is_unit { FieldOrder::TranslationFirst } else { FieldOrder::QuaternionFirst }
}

/// Whether most nodes keep their translation from keyframe to keyframe, as joints do. Rows that are cut at the wrong places do not.
pub(super) fn offsets_persist(bytes: &[u8], plan: &Plan) -> bool {
    let order = first_order(bytes, plan);
    let first = first_offsets(bytes, plan);
    let (mut kept, mut all) = (0, 0);
    for (index, (_, row)) in rows(bytes, plan).enumerate().skip(plan.nodes) {
        all += 1;
        kept += usize::from(translation(row, order).distance(first[index % plan.nodes]) < 1e-3);
    }
    10 * kept >= 7 * all
}

fn translation([a, b, c, _, e, f, g]: [f32; 7], order: FieldOrder) -> Vec3 {
    match order {
        FieldOrder::TranslationFirst => Vec3::new(a, b, c),
        FieldOrder::QuaternionFirst => Vec3::new(e, f, g),
    }
}

/// The length of a quaternion.
fn length(four: &[f32]) -> f64 {
    four.iter().map(|&number| f64::from(number).powi(2)).sum::<f64>().sqrt()
}

/// Makes keyframes from the rows, and adds inferences to the plan.
///
/// # Errors
/// Rows that are not rigid body transforms; when salvaging, only if no keyframe is complete.
pub(super) fn keyframes(
    bytes: &[u8],
    plan: &mut Plan,
    scene: &SceneGraph,
    options: &Options,
) -> Result<Vec<Keyframe>, TextError> {
    if plan.layout == Layout::Matrices {
        check_matrices(bytes, plan, options)?;
        build(bytes, plan, scene, options, |matrix| rigid(&matrix).unwrap_or(Rbt::IDENTITY))
    } else {
        let order = field_order(bytes, plan, options)?;
        if (plan.layout, order) == (Layout::Header, FieldOrder::QuaternionFirst) {
            plan.layout = Layout::HeaderQuaternionFirst;
        }
        w_place(bytes, plan, order);
        let is_w_last = plan.is_w_last;
        build(bytes, plan, scene, options, |row| rbt(row, order, is_w_last))
    }
}

fn build<const WIDTH: usize>(
    bytes: &[u8],
    plan: &mut Plan,
    scene: &SceneGraph,
    options: &Options,
    decode: impl Fn([f32; WIDTH]) -> Rbt,
) -> Result<Vec<Keyframe>, TextError> {
    let first: Vec<Vec3> = rows(bytes, plan).take(plan.nodes).map(|(_, row)| decode(row).translation).collect();
    let node_of_row = match_joints(&first, scene, options, plan);
    // The plan counted this many keyframes in the text.
    let mut keyframes: Vec<Keyframe> = Vec::with_capacity(plan.keyframes);
    let mut pose = scene.rest_pose().clone();
    for (row_index, (at, row)) in rows(bytes, plan).enumerate() {
        let row_of_keyframe = row_index % plan.nodes;
        if let Some(node) = node_of_row[row_of_keyframe] {
            let placed = decode(row);
            if !placed.is_in_bounds() {
                let (keyframe, row) = (keyframes.len(), row_of_keyframe);
                salvage(plan, keyframe, TextError::new(bytes, at, TextProblem::TooFar { keyframe, row }), options)?;
                break;
            }
            pose.set(node, placed);
        }
        if row_of_keyframe + 1 == plan.nodes {
            // Poses that do not change share their storage.
            let same = keyframes.last().map(|last| &last.pose).filter(|&last| *last == pose);
            keyframes.push(Keyframe::new(same.unwrap_or(&pose).clone()));
        }
    }
    Ok(keyframes)
}

fn rbt(row: [f32; 7], order: FieldOrder, is_w_last: bool) -> Rbt {
    let mut four = quaternion(&row, order);
    if is_w_last {
        four.rotate_right(1);
    }
    let [w, x, y, z] = four;
    Rbt::new(translation(row, order), near_unit(Quat::from_xyzw(x, y, z, w)))
}

/// The four numbers of the quaternion as they stand.
fn quaternion([a, b, c, d, e, f, g]: &[f32; 7], order: FieldOrder) -> [f32; 4] {
    match order {
        FieldOrder::TranslationFirst => [*d, *e, *f, *g],
        FieldOrder::QuaternionFirst => [*a, *b, *c, *d],
    }
}

/// Finds out whether w is the last number of the quaternions, and says it: most nodes of keyframe 0 are not rotated.
fn w_place(bytes: &[u8], plan: &mut Plan, order: FieldOrder) {
    if plan.is_w_last {
        plan.find(Certainty::Sure, "order: w is the last number of the quaternion, as the header names the columns");
        return;
    }
    let mut first_or_last = [0, 0];
    for (_, row) in rows::<7>(bytes, plan).take(plan.nodes) {
        let [first, .., last] = quaternion(&row, order).map(f32::abs);
        first_or_last[0] += usize::from(first > 0.999);
        first_or_last[1] += usize::from(last > 0.999);
    }
    let [first, last] = first_or_last;
    if plan.named_order.is_none() && 2 * last > plan.nodes && last > first {
        plan.is_w_last = true;
        plan.find(
            Certainty::Warning,
            format!(
                "order: the last number of the quaternion is 1 in {last} of {} rows of keyframe 0: taken as w",
                plan.nodes
            ),
        );
    }
}

/// The rotation, normalised if it is not of unit length. The sign is kept.
fn near_unit(rotation: Quat) -> Quat {
    let exact = rotation.as_dquat();
    match Mending::of_length(exact.length()) {
        Mending::Keep => rotation,
        // Rotations that are too far off were refused before.
        Mending::Normalise | Mending::Refuse => exact.normalize().as_quat(),
    }
}

/// A row whose four numbers are not a unit quaternion.
#[derive(Clone, Copy)]
struct NotUnit {
    row: usize,
    at: usize,
    length: f64,
}

/// The first row of each order whose quaternion is not unit.
fn first_not_unit(bytes: &[u8], plan: &Plan, tolerance: f64) -> [Option<NotUnit>; 2] {
    let mut found = [None; 2];
    for (row, (at, numbers)) in rows::<7>(bytes, plan).enumerate() {
        for (four, first) in [&numbers[3..], &numbers[..4]].into_iter().zip(&mut found) {
            let length = length(four);
            if first.is_none() && (length - 1.0).abs() > tolerance {
                *first = Some(NotUnit { row, at, length });
            }
        }
        if found.iter().all(Option::is_some) {
            break;
        }
    }
    found
}

fn field_order(bytes: &[u8], plan: &mut Plan, options: &Options) -> Result<FieldOrder, TextError> {
    let named = plan.named_order;
    let tolerance = if options.order.is_some() { NORMALISED } else { RECOGNISED };
    let not_unit = first_not_unit(bytes, plan, tolerance);
    let is_possible = not_unit.map(|row| row.is_none());
    let rows = texts::count_rows(plan.keyframes * plan.nodes);
    let order = match (options.order, is_possible) {
        (Some(order), _) => order,
        (None, [true, true]) => named.unwrap_or(FieldOrder::TranslationFirst),
        (None, [true, false]) => FieldOrder::TranslationFirst,
        (None, [false, true]) => FieldOrder::QuaternionFirst,
        // The order that is valid for more rows.
        (None, [false, false]) => {
            let until = not_unit.map(|row| row.map_or(0, |row| row.row));
            if until[1] > until[0] { FieldOrder::QuaternionFirst } else { FieldOrder::TranslationFirst }
        }
    };
    if let Some(NotUnit { row, at, length }) = not_unit[order as usize] {
        let (keyframe, row) = (row / plan.nodes, row % plan.nodes);
        let is_last = order == FieldOrder::TranslationFirst;
        let hint = options.order.is_none().then(|| texts::TEXT_HINT_NEITHER_ORDER.into());
        #[expect(clippy::cast_possible_truncation, reason = "it is for a message")]
        let length = length as f32;
        let error = TextError::new(bytes, at, TextProblem::NotUnit { keyframe, row, is_last, length, hint });
        salvage(plan, keyframe, error, options)?;
    }
    let words = order.words();
    if options.order.is_some() {
        plan.find(Certainty::Sure, format!("order: {words}, as --order says"));
    } else if plan.keyframes == 0 {
    } else if is_possible == [true, true] {
        match named {
            Some(_) => plan.find(Certainty::Sure, format!("order: {words}, as the header names the columns")),
            None => plan.find(
                Certainty::Warning,
                format!(
                    "order: either four numbers are unit in all {rows}: taken as {words}; --order decides otherwise"
                ),
            ),
        }
    } else {
        plan.find(Certainty::Sure, format!("order: {words}: only those four numbers are unit in all {rows}"));
        if named.is_some_and(|named| named != order) {
            plan.find(Certainty::Warning, "order: the header names the columns the other way round");
        }
    }
    Ok(order)
}

/// Removes the keyframes from the broken one on, if salvaging is on and any keyframe is left.
fn salvage(plan: &mut Plan, broken: usize, error: TextError, options: &Options) -> Result<(), TextError> {
    if !options.salvage || broken == 0 {
        return Err(error);
    }
    plan.keyframes = broken;
    plan.find(Certainty::Warning, format!("salvaged: keyframe {broken} and those after it are left out: {error}"));
    Ok(())
}

fn check_matrices(bytes: &[u8], plan: &mut Plan, options: &Options) -> Result<(), TextError> {
    let broken = rows::<16>(bytes, plan).enumerate().find(|(_, (_, matrix))| rigid(matrix).is_none());
    let Some((row_index, (at, _))) = broken else { return Ok(()) };
    let (keyframe, row) = (row_index / plan.nodes, row_index % plan.nodes);
    let error = TextError::new(bytes, at, TextProblem::NotRigid { keyframe, row });
    salvage(plan, keyframe, error, options)
}

/// The transform of a column-major matrix, if it is rigid to within the tolerance.
fn rigid(matrix: &[f32; 16]) -> Option<Rbt> {
    let near = |number: f64, expected: f64| (number - expected).abs() <= RECOGNISED;
    let bottom = [3, 7, 11, 15].map(|index| f64::from(matrix[index]));
    if !bottom.into_iter().zip([0.0, 0.0, 0.0, 1.0]).all(|(number, expected)| near(number, expected)) {
        return None;
    }
    let column = |index: usize| Vec3::new(matrix[index], matrix[index + 1], matrix[index + 2]);
    let [x, y, z] = [0, 4, 8].map(column);
    let exact = [x, y, z].map(|column: Vec3| column.as_dvec3());
    let is_unit = exact.iter().all(|column| near(column.length(), 1.0));
    let is_orthogonal = [(0, 1), (1, 2), (2, 0)].iter().all(|&(a, b)| near(exact[a].dot(exact[b]), 0.0));
    if !is_unit || !is_orthogonal || exact[0].cross(exact[1]).dot(exact[2]) < 0.0 {
        return None;
    }
    let rotation = Quat::from_mat3(&Mat3::from_cols(x, y, z)).as_dquat().normalize().as_quat();
    Some(Rbt::new(column(12), rotation))
}
