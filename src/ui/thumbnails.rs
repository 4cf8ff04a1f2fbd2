//! Small pictures of keyframes' poses: asked for where they are in sight, made by the window one at a time when it is idle, and kept
//! while they are of use. There are never more than a bounded number of them, however long the list is.

use std::collections::HashMap;

use egui::epaint::RectShape;
use egui::{
    Color32, ColorImage, Context, Painter, Rect, Sense, TextureHandle, TextureId, TextureOptions, Ui, pos2, vec2,
};

use super::theme::{CORNER, Tokens};
use crate::pose::Pose;

/// Width and height of a picture in pixels.
pub const THUMBNAIL_PX: [usize; 2] = [128, 96];
/// The most that are kept, 48 KiB each: far more than are ever in sight.
const MOST: usize = 128;

/// A picture that is there.
struct Thumbnail {
    /// Held, so that no other pose takes its identity.
    pose: Pose,
    texture: TextureHandle,
    /// When it was last in sight.
    seen: u64,
}

/// The pictures, and the poses in sight that have none.
#[derive(Default)]
pub struct Thumbnails {
    pictures: HashMap<usize, Thumbnail>,
    /// What was last shown of each keyframe, by its index, and when: it stays until the picture of its new pose is there.
    last: HashMap<usize, (TextureHandle, u64)>,
    wanted: Vec<Pose>,
    frame: u64,
}

impl std::fmt::Debug for Thumbnails {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "Thumbnails({} there, {} wanted)", self.pictures.len(), self.wanted.len())
    }
}

impl Thumbnails {
    /// Begins a frame: nothing is wanted until it is in sight, and pictures of poses that are held nowhere else are dropped.
    pub fn begin(&mut self) {
        self.wanted.clear();
        self.frame += 1;
        self.last.retain(|_, (_, seen)| *seen + 1 >= self.frame);
        self.pictures.retain(|_, picture| picture.pose.is_held_elsewhere());
    }

    /// The picture of a pose in sight; where there is none, it is wanted.
    pub fn find(&mut self, pose: &Pose) -> Option<TextureId> {
        if let Some(picture) = self.pictures.get_mut(&pose.storage()) {
            picture.seen = self.frame;
            return Some(picture.texture.id());
        }
        if !self.wanted.iter().any(|wanted| wanted.shares_with(pose)) {
            self.wanted.push(pose.clone());
        }
        None
    }

    /// A pose in sight whose picture is wanted.
    pub fn wanted(&self) -> Option<&Pose> {
        self.wanted.first()
    }

    /// Takes in a picture. Where there are too many, the one goes that was out of sight for the longest.
    pub fn put(&mut self, context: &Context, pose: Pose, rgba: &[u8]) {
        self.wanted.retain(|wanted| !wanted.shares_with(&pose));
        if self.pictures.len() >= MOST
            && let Some(&oldest) = self.pictures.iter().min_by_key(|(_, picture)| picture.seen).map(|(key, _)| key)
        {
            self.pictures.remove(&oldest);
        }
        let image = ColorImage::from_rgba_unmultiplied(THUMBNAIL_PX, rgba);
        let texture = context.load_texture("keyframe", image, TextureOptions::LINEAR);
        self.pictures.insert(pose.storage(), Thumbnail { pose, texture, seen: self.frame });
    }

    /// The picture of a keyframe's pose; until that is there, what was last shown of the keyframe with this index.
    fn find_or_last(&mut self, index: usize, pose: &Pose) -> Option<TextureId> {
        if self.find(pose).is_some()
            && let Some(picture) = self.pictures.get(&pose.storage())
        {
            self.last.insert(index, (picture.texture.clone(), self.frame));
        }
        let (texture, seen) = self.last.get_mut(&index)?;
        *seen = self.frame;
        Some(texture.id())
    }

    /// Draws the picture of a keyframe's pose, or the ground that waits for it.
    pub fn paint(&mut self, painter: &Painter, rect: Rect, (index, pose): (usize, &Pose), tokens: &Tokens) {
        paint(painter, rect, self.find_or_last(index, pose), tokens);
    }

    /// Draws the picture of a pose that is no keyframe's, or the ground that waits for it.
    pub fn paint_alone(&mut self, painter: &Painter, rect: Rect, pose: &Pose, tokens: &Tokens) {
        paint(painter, rect, self.find(pose), tokens);
    }

    /// Shows the picture of a keyframe's pose in a tooltip, in its own size.
    pub fn show_large(&mut self, ui: &mut Ui, keyframe: (usize, &Pose)) {
        let [width, height] = THUMBNAIL_PX;
        #[expect(clippy::cast_precision_loss, reason = "it is a small picture")]
        let (rect, _) = ui.allocate_exact_size(vec2(width as f32, height as f32), Sense::hover());
        self.paint(ui.painter(), rect, keyframe, Tokens::of(ui));
    }
}

fn paint(painter: &Painter, rect: Rect, texture: Option<TextureId>, tokens: &Tokens) {
    match texture {
        None => _ = painter.rect_filled(rect, CORNER, tokens.raised),
        Some(texture) => {
            let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
            painter.add(RectShape::filled(rect, CORNER, Color32::WHITE).with_texture(texture, whole));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rbt::Rbt;

    fn pose() -> Pose {
        Pose::new(vec![Rbt::IDENTITY])
    }

    fn put(thumbnails: &mut Thumbnails, context: &Context, pose: &Pose) {
        thumbnails.put(context, pose.clone(), &vec![0; THUMBNAIL_PX[0] * THUMBNAIL_PX[1] * 4]);
    }

    #[test]
    fn a_pose_in_sight_is_wanted_until_its_picture_is_there() {
        let (context, mut thumbnails, pose) = (Context::default(), Thumbnails::default(), pose());
        thumbnails.begin();
        assert_eq!(thumbnails.wanted(), None);
        assert_eq!((thumbnails.find(&pose), thumbnails.find(&pose)), (None, None));
        assert_eq!(thumbnails.wanted.len(), 1, "once");
        put(&mut thumbnails, &context, &pose);
        assert_eq!(thumbnails.wanted(), None);
        thumbnails.begin();
        assert!(thumbnails.find(&pose).is_some());
        assert!(thumbnails.find(&pose.clone()).is_some(), "a copy shares it");
        assert_eq!(thumbnails.wanted(), None);
        thumbnails.begin();
        assert_eq!(thumbnails.find(&Pose::new(pose.to_vec())), None, "another one does not");
    }

    #[test]
    fn the_old_picture_stays_until_the_new_one_is_there() {
        let (context, mut thumbnails) = (Context::default(), Thumbnails::default());
        let (before, after) = (pose(), pose());
        thumbnails.begin();
        assert_eq!(thumbnails.find_or_last(3, &before), None);
        put(&mut thumbnails, &context, &before);
        let old = thumbnails.find_or_last(3, &before);
        assert!(old.is_some());
        drop(before);
        for _ in 0..3 {
            thumbnails.begin();
            assert_eq!(thumbnails.find_or_last(3, &after), old);
            assert_eq!(thumbnails.find_or_last(4, &after), None, "another keyframe had none");
        }
        assert_eq!(thumbnails.wanted(), Some(&after));
        put(&mut thumbnails, &context, &after);
        thumbnails.begin();
        let new = thumbnails.find_or_last(3, &after);
        assert!(new.is_some() && new != old);
        thumbnails.begin();
        thumbnails.begin();
        assert!(thumbnails.last.is_empty(), "what is out of sight is forgotten");
    }

    #[test]
    fn what_nobody_holds_is_dropped_and_there_are_never_too_many() {
        let (context, mut thumbnails) = (Context::default(), Thumbnails::default());
        let poses: Vec<Pose> = (0..2 * MOST).map(|_| pose()).collect();
        for pose in &poses {
            thumbnails.begin();
            thumbnails.find(&poses[0]);
            thumbnails.find(pose);
            put(&mut thumbnails, &context, pose);
            assert!(thumbnails.pictures.len() <= MOST);
        }
        thumbnails.begin();
        assert!(thumbnails.find(&poses[0]).is_some(), "what is in sight stays");
        assert!(thumbnails.find(&poses[1]).is_none(), "what was out of sight for the longest went");
        drop(poses);
        thumbnails.begin();
        assert_eq!(thumbnails.pictures.len(), 0);
    }
}
