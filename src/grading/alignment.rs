//! Which keyframe of a submission each of the reference's keyframes is compared with.

use super::off::Off;
use super::rubric::Credit;
use crate::keyframe::KeyframeList;

/// The most pairs that are compared; longer lists are compared index by index.
const MOST_PAIRS: usize = 250_000;

/// For each of the reference's keyframes the index of a keyframe of the submission, if there is one.
///
/// Index by index; or, where keyframes are aligned, in the order of both lists so that the fewest points are lost, then so that the most
/// keyframes are compared, then so that indices differ the least.
#[must_use]
pub fn alignment(reference: &KeyframeList, found: &KeyframeList, credit: &Credit) -> Vec<Option<usize>> {
    let (rows, columns) = (reference.len(), found.len());
    if !credit.align_keyframes || rows * columns > MOST_PAIRS {
        return (0..rows).map(|index| (index < columns).then_some(index)).collect();
    }
    let share = |row: usize, column: usize| {
        let (right, found) = (&reference.as_slice()[row].pose, &found.as_slice()[column].pose);
        let shares = found.iter().zip(right.iter()).map(|(found, right)| Off::between(found, right).share(credit));
        shares.fold(1.0, f64::min)
    };
    // What the rest of both lists can earn: millionths of shares, compared keyframes, and less for indices that differ.
    let mut rest = vec![vec![(0_u64, 0_usize, 0_isize); columns + 1]; rows + 1];
    let pair = |rest: &[Vec<(u64, usize, isize)>], row: usize, column: usize, share: f64| {
        let (shares, pairs, near) = rest[row + 1][column + 1];
        (shares + (share * 1e6).round() as u64, pairs + 1, near - row.abs_diff(column) as isize)
    };
    let mut shares = vec![vec![0.0; columns]; rows];
    for row in (0..rows).rev() {
        for column in (0..columns).rev() {
            shares[row][column] = share(row, column);
            let paired = pair(&rest, row, column, shares[row][column]);
            rest[row][column] = paired.max(rest[row + 1][column]).max(rest[row][column + 1]);
        }
    }
    let mut column = 0;
    (0..rows)
        .map(|row| {
            while column < columns {
                if rest[row][column] == pair(&rest, row, column, shares[row][column]) {
                    column += 1;
                    return Some(column - 1);
                }
                if rest[row][column] == rest[row + 1][column] {
                    return None;
                }
                column += 1;
            }
            None
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::animation_diff::Tolerances;
    use crate::grading::rubric::Band;
    use crate::keyframe::Keyframe;
    use crate::pose::Pose;
    use crate::rbt::Rbt;
    use glam::Vec3;

    fn list(places: &[f32]) -> KeyframeList {
        let keyframe = |x: &f32| Keyframe::new(Pose::new(vec![Rbt::from_translation(Vec3::X * *x)]));
        KeyframeList::new(places.iter().map(keyframe).collect())
    }

    fn aligned(found: &[f32]) -> Vec<Option<usize>> {
        let near = Band { tolerances: Tolerances { translation: 0.1, rotation_degrees: 1.0 }, share: 0.5 };
        let credit = Credit::new(Tolerances::default(), vec![near]);
        let credit = Credit { align_keyframes: true, ..credit };
        alignment(&list(&[0.0, 1.0, 2.0, 3.0]), &list(found), &credit)
    }

    #[test]
    fn keyframes_are_aligned_with_the_fewest_losses() {
        let all = |range: std::ops::Range<usize>| range.map(Some).collect::<Vec<_>>();
        assert_eq!(aligned(&[0.0, 1.0, 2.0, 3.0]), all(0..4));
        assert_eq!(aligned(&[0.0, 2.0, 3.0]), [Some(0), None, Some(1), Some(2)]);
        assert_eq!(aligned(&[0.0, 1.0, 7.0, 2.0, 3.0]), [Some(0), Some(1), Some(3), Some(4)]);
        assert_eq!(aligned(&[0.0, 9.0, 2.0, 3.0]), all(0..4), "a wrong one is compared");
        assert_eq!(aligned(&[0.05, 1.0, 2.0, 3.0]), all(0..4));
        assert_eq!(aligned(&[]), [None; 4]);
        assert_eq!(aligned(&[9.0]), [Some(0), None, None, None]);
        assert_eq!(aligned(&[9.0, 9.0, 9.0, 9.0, 9.0]), all(0..4));
    }
}
