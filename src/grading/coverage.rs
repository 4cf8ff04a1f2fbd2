//! Whether samples are there for every node in every interval between keyframes.

use super::cells::number;
use super::right::SAME_TIME;
use crate::diagnosis::Samples;
use crate::pose::RbtIndex;
use crate::scene::SceneGraph;
use crate::text::counted;

/// How well samples cover an animation.
#[derive(Clone, Debug, PartialEq)]
pub struct Coverage {
    /// The mean over nodes and intervals of the samples that are there, of those that are asked: 0 to 1.
    pub share: f64,
    /// The first place with too few.
    gap: Option<Gap>,
}

#[derive(Clone, Debug, PartialEq)]
struct Gap {
    node: RbtIndex,
    /// The interval by the key time at which it begins; `None` if the node is never shown.
    interval: Option<usize>,
    found: usize,
    asked: usize,
}

impl Coverage {
    /// The coverage by samples of an animation with so many nodes and intervals, where so many samples are `asked` in each. A sample at a
    /// whole key time counts for the interval that begins there; one at the end for the last.
    #[must_use]
    pub fn of(samples: &Samples, nodes: usize, intervals: usize, asked: usize) -> Self {
        if asked == 0 || nodes == 0 {
            return Self { share: 1.0, gap: None };
        }
        let rows =
            samples.rows.iter().filter(|row| row.key_time < intervals as f64 + SAME_TIME.max(row.key_time_error));
        let mut shown: Vec<(usize, u64)> = rows.map(|row| (row.node.get(), row.key_time.to_bits())).collect();
        shown.sort_unstable();
        shown.dedup();
        let mut counts = vec![0_usize; nodes * intervals];
        for (node, bits) in shown {
            let interval = ((f64::from_bits(bits) + SAME_TIME) as usize).min(intervals - 1);
            counts[node * intervals + interval] += 1;
        }
        let found: usize = counts.iter().map(|count| (*count).min(asked)).sum();
        let gap = counts.iter().position(|count| *count < asked).map(|first| {
            let node = first / intervals;
            let is_missing = counts[node * intervals..(node + 1) * intervals].iter().all(|count| *count == 0);
            let interval = (!is_missing).then_some(first % intervals);
            Gap { node: RbtIndex::new(node), interval, found: counts[first], asked }
        });
        Self { share: found as f64 / (counts.len() * asked) as f64, gap }
    }

    /// What is missing: a sentence.
    #[must_use]
    pub fn sentence(&self, scene: &SceneGraph) -> Option<String> {
        let Gap { node, interval, found, asked } = self.gap.as_ref()?;
        let path = scene.rbt_paths().nth(node.get()).unwrap_or_default();
        let what = match interval {
            None => format!("{path} has no samples"),
            Some(start) => format!(
                "{path} has {} from key time {start} to {}, and {asked} are asked",
                counted(*found, "sample"),
                start + 1
            ),
        };
        // Rounded down: a gap is never said to cost nothing.
        let percent = number((self.share * 1000.0 + 1e-9).floor() / 10.0);
        Some(format!("Samples are missing: {what}; {percent} % of what is asked is there."))
    }
}
