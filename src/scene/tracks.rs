//! The tracks of a node: timed keys, at most one track for each channel.

use glam::{Affine3A, Quat, Vec3, Vec4};

use super::channel::Channel;
use crate::timed::{KeyError, Track};

/// The timed keys of a node, by channel. A channel without keys has its default value.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tracks([Option<Track<Vec4>>; Channel::ALL.len()]);

impl Tracks {
    /// The track of a channel, if it has keys. The channel defines the meaning of the numbers: [`super::KeyValue`].
    #[must_use]
    pub fn get(&self, channel: Channel) -> Option<&Track<Vec4>> {
        self.0[channel as usize].as_ref()
    }

    /// The same tracks with one channel replaced, or removed.
    #[must_use]
    pub fn with(&self, channel: Channel, track: Option<Track<Vec4>>) -> Self {
        let mut changed = self.clone();
        changed.0[channel as usize] = track;
        changed
    }

    /// Sets the keys of a channel from (seconds, numbers) pairs in any order.
    ///
    /// # Errors
    /// [`KeyError`] for no pairs, a time that is not finite, or two at one time.
    pub(super) fn set(
        &mut self,
        channel: Channel,
        pairs: impl IntoIterator<Item = (f64, Vec4)>,
    ) -> Result<(), KeyError> {
        self.0[channel as usize] = Some(Track::with_interpolation(pairs, channel.interpolate())?);
        Ok(())
    }

    /// The numbers of a channel at a time in seconds, if it has keys.
    pub(super) fn numbers_at(&self, channel: Channel, seconds: f64) -> Option<Vec4> {
        self.get(channel).map(|track| track.value_at(seconds))
    }

    /// The affine `T · R · S` of a control node at a time in seconds: `parent_from_node`. Channels without keys are those of the identity.
    #[must_use]
    pub fn parent_from_node(&self, seconds: f64) -> Affine3A {
        let translation = self.numbers_at(Channel::Translation, seconds).map_or(Vec3::ZERO, Vec4::truncate);
        let rotation = self.numbers_at(Channel::Rotation, seconds).map_or(Quat::IDENTITY, Quat::from_vec4);
        let scale = self.numbers_at(Channel::Scale, seconds).map_or(Vec3::ONE, Vec4::truncate);
        Affine3A::from_scale_rotation_translation(scale, rotation, translation)
    }

    /// The largest component of all scales; 1 without keys of the scale.
    pub(super) fn largest_scale(&self) -> f64 {
        let scales =
            self.get(Channel::Scale).map(|track| track.keys().map(|(_, scale)| scale.truncate().max_element()));
        scales.and_then(|scales| scales.reduce(f32::max)).unwrap_or(1.0).into()
    }

    /// The time of the last key of all, in seconds; `None` without keys.
    #[must_use]
    pub fn last_second(&self) -> Option<f64> {
        self.0.iter().flatten().map(Track::last_second).reduce(f64::max)
    }
}
