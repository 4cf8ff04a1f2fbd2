//! Graded items as people read them: what is said of several in a row is said once.

use super::item::{Evidence, Item, ItemKind};

/// Items in a row of which there is the same to say.
#[derive(Clone, Debug, PartialEq)]
pub struct Row<'a> {
    kinds: Vec<ItemKind>,
    /// The points given.
    pub points: f64,
    /// The maximum of points.
    pub out_of: f64,
    /// Whether points are missing.
    pub has_lost: bool,
    /// What the verdicts rest on, where they rest on more than the keyframes.
    pub evidence: Option<Evidence>,
    /// Why: sentences.
    pub reason: &'a str,
}

/// The rows of items: a new one begins where another reason is given, or where points are missing of one and not of the other.
#[must_use]
pub fn rows(items: &[Item]) -> Vec<Row<'_>> {
    let mut rows: Vec<Row> = Vec::new();
    for item in items {
        match rows.last_mut() {
            Some(row) if row.says_the_same_of(item) => {
                row.kinds.push(item.kind);
                row.points += item.points;
                row.out_of += item.out_of;
            }
            _ => rows.push(Row {
                kinds: vec![item.kind],
                points: item.points,
                out_of: item.out_of,
                has_lost: item.has_lost(),
                evidence: item.evidence,
                reason: &item.reason,
            }),
        }
    }
    rows
}

impl Row<'_> {
    fn says_the_same_of(&self, item: &Item) -> bool {
        self.reason == item.reason && self.has_lost == item.has_lost() && self.evidence == item.evidence
    }

    /// The names of the items for people: `keyframe count, keyframes 0 to 7`.
    #[must_use]
    pub fn title(&self) -> String {
        self.named(ItemKind::title)
    }

    /// The names of the items in tables for programs: `keyframe_count, keyframes 0 to 7`.
    #[must_use]
    pub fn ids(&self) -> String {
        self.named(ItemKind::id)
    }

    fn named(&self, name: fn(ItemKind) -> String) -> String {
        let mut names = Vec::new();
        let mut kinds = self.kinds.iter().peekable();
        while let Some(kind) = kinds.next() {
            let ItemKind::Keyframe(first) = *kind else {
                names.push(name(*kind));
                continue;
            };
            let mut last = first;
            while kinds.next_if_eq(&&ItemKind::Keyframe(last + 1)).is_some() {
                last += 1;
            }
            names.push(if last == first { name(*kind) } else { format!("keyframes {first} to {last}") });
        }
        names.join(", ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interpolation::Interpolation;

    #[test]
    fn items_of_which_there_is_the_same_to_say_are_one_row() {
        let item = |kind, points, reason: &str| Item {
            kind,
            points,
            out_of: 2.0,
            reason: reason.to_owned(),
            evidence: None,
            is_by_hand: false,
        };
        let playback = ItemKind::Playback(Interpolation::CatmullRom);
        let items = [
            item(ItemKind::KeyframeCount, 2.0, "right"),
            item(ItemKind::Keyframe(0), 2.0, "as there"),
            item(ItemKind::Keyframe(1), 2.0, "as there"),
            item(ItemKind::Keyframe(2), 0.0, "off"),
            item(ItemKind::Keyframe(3), 2.0, "as there"),
            item(playback, 2.0, "right"),
        ];
        let of_items = rows(&items);
        let titles: Vec<String> = of_items.iter().map(Row::title).collect();
        assert_eq!(titles, ["keyframe count", "keyframes 0 to 1", "keyframe 2", "keyframe 3", "Catmull-Rom playback"]);
        assert_eq!((of_items[1].points, of_items[1].out_of), (4.0, 4.0));

        let unread = [ItemKind::KeyframeCount, ItemKind::Keyframe(0), ItemKind::Keyframe(1), playback];
        let unread = unread.map(|kind| item(kind, 0.0, "unreadable"));
        let [row] = &rows(&unread)[..] else { panic!("{unread:?}") };
        assert_eq!(row.title(), "keyframe count, keyframes 0 to 1, Catmull-Rom playback");
        assert_eq!(row.ids(), "keyframe_count, keyframes 0 to 1, catmull_rom_playback");
        assert_eq!((row.points, row.out_of), (0.0, 8.0));
    }
}
