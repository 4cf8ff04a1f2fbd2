//! Finds the numbers before the first row: `N M`, `N` alone, or more of them, such as frames per second.

use super::counts::Counts;
use super::marks::MOST_HEADER;
use super::structure::{FIRST_LINES, Structure};

/// Numbers before the first row that agree with what follows.
#[derive(Clone, Debug)]
pub(super) struct Header {
    /// How many numbers stand before the rows.
    pub(super) skip: usize,
    /// The number of keyframes.
    pub(super) keyframes: usize,
    /// The number of nodes per keyframe.
    pub(super) nodes: usize,
    /// Whether the header says the number of keyframes.
    pub(super) says_keyframes: bool,
    /// Whether the header says the number of nodes.
    pub(super) says_nodes: bool,
    /// The numbers that say something else.
    pub(super) unused: Vec<f32>,
}

/// The number, if it can be a count.
fn whole(number: f32) -> Option<usize> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is whole and not negative")]
    (number.fract() == 0.0 && (0.0..1e9).contains(&number)).then_some(number as usize)
}

/// The first two numbers, if they can be counts.
pub(super) fn first_two(structure: &Structure) -> Option<(usize, usize)> {
    Some((whole(*structure.first.first()?)?, whole(*structure.first.get(1)?)?))
}

/// How many numbers a header may have, the most likely first.
fn lengths(structure: &Structure) -> Vec<usize> {
    let single = structure.first_lines.iter().take_while(|&&numbers| numbers == 1).count();
    let single = if single == FIRST_LINES { 2 } else { single };
    let mut lengths = vec![2, structure.named.lead, structure.other.lead, structure.first_lines[0], single];
    lengths.retain(|length| (1..=MOST_HEADER).contains(length) && *length <= structure.numbers);
    lengths
}

/// The header that the numbers of rows of this width agree with.
pub(super) fn find(structure: &Structure, width: usize, counts: &Counts) -> Option<Header> {
    lengths(structure).into_iter().find_map(|skip| of_length(structure, skip, width, counts))
}

fn of_length(structure: &Structure, skip: usize, width: usize, counts: &Counts) -> Option<Header> {
    let numbers = &structure.first[..skip];
    let body = structure.numbers - skip;
    let makes = |keyframes: usize, nodes: usize| {
        keyframes.checked_mul(nodes).and_then(|rows| rows.checked_mul(width)) == Some(body)
    };
    let values: Vec<(usize, usize)> =
        numbers.iter().enumerate().filter_map(|(place, &number)| Some((place, whole(number)?))).collect();
    let header = |keyframes: usize, nodes: usize, places: [Option<usize>; 2]| Header {
        skip,
        keyframes,
        nodes,
        says_keyframes: places[0].is_some(),
        says_nodes: places[1].is_some(),
        unused: (0..skip).filter(|place| !places.contains(&Some(*place))).map(|place| numbers[place]).collect(),
    };
    if let [(0, 0), (1, nodes)] = values.as_slice()
        && body == 0
        && (*nodes == 0 || counts.accept(*nodes))
    {
        return Some(header(0, *nodes, [Some(0), Some(1)]));
    }
    let pairs = values.iter().flat_map(|&first| values.iter().map(move |&second| (first, second)));
    let pair = pairs
        .filter(|((first, _), (second, _))| first != second)
        .find(|((_, keyframes), (_, nodes))| *keyframes > 0 && counts.accept(*nodes) && makes(*keyframes, *nodes));
    if let Some(((first, keyframes), (second, nodes))) = pair {
        return Some(header(keyframes, nodes, [Some(first), Some(second)]));
    }
    let has_count = values.iter().any(|(_, value)| counts.accept(*value));
    if body == 0 || skip == 2 || skip > 2 && has_count {
        return None;
    }
    let of_keyframes = values.iter().find_map(|&(place, keyframes)| {
        let nodes = counts.all().find(|&nodes| makes(keyframes, nodes))?;
        Some(header(keyframes, nodes, [Some(place), None]))
    });
    of_keyframes.or_else(|| {
        let &(place, nodes) =
            values.iter().find(|(_, nodes)| counts.accept(*nodes) && body.is_multiple_of(nodes * width))?;
        Some(header(body / (nodes * width), nodes, [None, Some(place)]))
    })
}
