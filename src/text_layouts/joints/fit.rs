//! Finds which rows of a keyframe are the scene's nodes: lights and meshes of later assignments may stand anywhere, and robots may have no
//! heads.

use glam::Vec3;

use super::robot::{Found, Robot, heads, robots};
use crate::pose::RbtIndex;
use crate::scene::SceneGraph;

/// The most rows that are not the scene's.
const MOST_MORE: usize = 4;
/// Offsets that differ by less are equal.
const SAME: f32 = 1e-3;

/// Which row is which node.
pub(in crate::text_layouts) struct Fit<'a> {
    /// The nodes right under the root, with their joints.
    pub(super) robots: Vec<Robot<'a>>,
    /// The row of each of them.
    pub(super) rows: Vec<usize>,
    /// How the joints of each match the rows after it.
    pub(super) found: Vec<Found>,
    /// The nodes that have no row.
    pub(in crate::text_layouts) without_row: Vec<RbtIndex>,
    /// Whether the offsets confirm it.
    pub(super) is_confirmed: bool,
}

/// The fit that the offsets of keyframe 0 confirm; `None` if there is none.
pub(in crate::text_layouts) fn fit<'a>(offsets: &[Vec3], scene: &'a SceneGraph) -> Option<Fit<'a>> {
    [vec![], heads(scene)].into_iter().find_map(|without_row| {
        let more =
            offsets.len().checked_sub(scene.rbt_count() - without_row.len()).filter(|&more| more <= MOST_MORE)?;
        let robots = robots(scene, &without_row);
        let mut search = Search { offsets, scene, robots: &robots, rows: Vec::new(), best: None };
        search.go_on(0, more);
        let (_, rows) = search.best?;
        // Without heads and with other rows, a head of another offset could be taken as the robot itself.
        let is_at_rest = |(robot, &row): (&Robot<'_>, &usize)| {
            robot.joints.is_empty() || offsets[row].distance(scene.rest_pose().get(robot.root).translation) < SAME
        };
        if !without_row.is_empty() && more > 0 && !robots.iter().zip(&rows).all(is_at_rest) {
            return None;
        }
        let found = found(&robots, &rows, offsets);
        Some(Fit { robots, rows, found, without_row, is_confirmed: true })
    })
}

/// The rows in the scene's order, however the offsets are. There are as many as the scene has nodes, or more.
pub(super) fn in_order<'a>(offsets: &[Vec3], scene: &'a SceneGraph) -> Fit<'a> {
    let robots = robots(scene, &[]);
    let rows: Vec<usize> = robots.iter().map(|robot| robot.root.get()).collect();
    let found = found(&robots, &rows, offsets);
    Fit { robots, rows, found, without_row: Vec::new(), is_confirmed: false }
}

fn found(robots: &[Robot<'_>], rows: &[usize], offsets: &[Vec3]) -> Vec<Found> {
    robots.iter().zip(rows).map(|(robot, row)| robot.find(&offsets[row + 1..])).collect()
}

/// How well a choice of rows fits, smaller is better: how the worst robot matches, how many nodes without joints are not at rest, and how
/// many rows are left out between such nodes.
type Misfit = (usize, usize, usize);

/// Tries which rows to leave out. Those at the end are left out first.
struct Search<'a> {
    offsets: &'a [Vec3],
    scene: &'a SceneGraph,
    robots: &'a [Robot<'a>],
    rows: Vec<usize>,
    best: Option<(Misfit, Vec<usize>)>,
}

impl Search<'_> {
    /// Chooses the rows of the nodes that are left, with at most `more` rows left out.
    fn go_on(&mut self, row: usize, more: usize) {
        let Some(robot) = self.robots.get(self.rows.len()) else {
            if let Some(misfit) = self.misfit()
                && self.best.as_ref().is_none_or(|(best, _)| misfit < *best)
            {
                self.best = Some((misfit, self.rows.clone()));
            }
            return;
        };
        for skipped in 0..=more {
            let own = row + skipped;
            if !matches!(robot.find(&self.offsets[own + 1..]), Found::Nothing) {
                self.rows.push(own);
                self.go_on(own + 1 + robot.joints.len(), more - skipped);
                self.rows.pop();
            }
        }
    }

    fn misfit(&self) -> Option<Misfit> {
        let mut misfit = (0, 0, 0);
        let mut next = 0;
        for (robot, &row) in self.robots.iter().zip(&self.rows) {
            if robot.joints.is_empty() {
                let rest = self.scene.rest_pose().get(robot.root).translation;
                misfit.1 += usize::from(self.offsets[row].distance(rest) > SAME);
                misfit.2 += if next == 0 { 0 } else { row - next };
            } else {
                misfit.0 = misfit.0.max(robot.find(self.offsets.get(row + 1..)?).rank());
            }
            next = row + 1 + robot.joints.len();
        }
        Some(misfit)
    }
}
