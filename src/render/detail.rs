//! Level of detail: chooses, for each kind of shape, the coarsest mesh whose silhouette has no visible error.

use glam::Vec3;

use crate::frame::{DrawItem, View};
use crate::render::light::SunBox;
use crate::render::mesh::{LEVELS, LEVELS_OF_KIND};
use crate::scene::MeshKind;

/// Allowed error of a silhouette, in distances between samples.
const WRONG_SAMPLES: f32 = 0.4;
/// Allowed error of a shadow's border, in texels of the shadow map: filtering blurs it by as much.
const WRONG_TEXELS: f32 = 1.0;

/// Who sees the shapes, and how large errors appear.
#[derive(Clone, Copy, Debug)]
enum Seen {
    /// Full detail, independent of the distance.
    Finest,
    /// Seen from `in_world`. A silhouette error of 1 unit at distance 1 covers `per_unit` of the allowed error.
    ByEye { in_world: Vec3, per_unit: f32 },
    /// Seen by the sun. An error of 1 unit covers `per_unit` of the allowed error at any distance.
    BySun { per_unit: f32 },
}

/// Chooses the mesh of each item.
#[derive(Clone, Copy, Debug)]
pub struct Detail(Seen);

impl Detail {
    /// The finest mesh of everything.
    pub const FINEST: Self = Self(Seen::Finest);

    /// For a picture `height_px` high with `samples_across` samples along a pixel's side.
    pub fn of_picture(view: &View, height_px: u32, samples_across: f32) -> Self {
        let pixels = 0.5 * height_px as f32 / (0.5 * view.vertical_fov).tan();
        Self(Seen::ByEye {
            in_world: view.world_from_eye.translation.into(),
            per_unit: pixels * samples_across / WRONG_SAMPLES,
        })
    }

    /// For the shadow map.
    pub fn of_sun_map(sun: &SunBox) -> Self {
        Self(Seen::BySun { per_unit: 1.0 / (sun.texel * WRONG_TEXELS) })
    }

    /// The largest angle in radians, seen from the eye, by which a coarse mesh may reach beyond the true shape.
    pub fn widest_error(self) -> f32 {
        match self.0 {
            // A small margin against rounding.
            Seen::ByEye { per_unit, .. } => 1.01 / per_unit,
            Seen::Finest | Seen::BySun { .. } => 0.0,
        }
    }

    /// The index in [`LEVELS`] of the mesh for an item of a unit mesh.
    pub fn mesh(self, item: &DrawItem, kind: MeshKind) -> usize {
        let (finest, coarsest) = LEVELS_OF_KIND[kind as usize];
        let axes = item.world_from_shape.matrix3;
        let scale = || axes.x_axis.length().max(axes.y_axis.length()).max(axes.z_axis.length());
        let (per_unit, scale, distance) = match self.0 {
            Seen::Finest => return finest,
            Seen::BySun { per_unit } => (per_unit, scale(), 1.0),
            Seen::ByEye { in_world, per_unit } => {
                // The distance is that of the nearest corner.
                let scale = scale();
                let distance = Vec3::from(item.world_from_shape.translation).distance(in_world);
                (per_unit, scale, (distance - scale * item.half_extents.length()).max(0.0))
            }
        };
        let radius = match kind {
            MeshKind::Cylinder | MeshKind::Cone => item.half_extents.x.max(item.half_extents.z),
            MeshKind::Box | MeshKind::Sphere | MeshKind::Capsule | MeshKind::Plane => item.rounding,
        };
        let wrong = scale * radius * per_unit;
        (finest..=coarsest).rev().find(|&index| LEVELS[index].flattening * wrong <= distance).unwrap_or(finest)
    }
}

#[cfg(test)]
mod tests {
    use glam::{Affine3A, Mat4};

    use super::*;

    fn ball(radius: f32, away: f32) -> DrawItem {
        DrawItem {
            mesh: MeshKind::Sphere.into(),
            world_from_shape: Affine3A::from_translation(Vec3::NEG_Z * away),
            half_extents: Vec3::splat(radius),
            rounding: radius,
            colour: Vec3::ONE,
            outlined: false,
            is_hidden: false,
            roughness: 0.6,
            metalness: 0.0,
            node: 0,
        }
    }

    #[test]
    fn the_nearer_the_finer_and_never_visibly_wrong() {
        let view = View {
            eye_from_world: Affine3A::IDENTITY,
            world_from_eye: Affine3A::IDENTITY,
            clip_from_eye: Mat4::IDENTITY,
            vertical_fov: 1.0,
            aspect: 1.0,
        };
        for samples_across in [1.0, 2.0] {
            let detail = Detail::of_picture(&view, 480, samples_across);
            let mut before = usize::MAX;
            for step in (1..200).rev() {
                let away = 0.5 * step as f32;
                let item = ball(0.2, away);
                let index = detail.mesh(&item, MeshKind::Sphere);
                assert!(index <= before, "coarser when nearer, at {away}");
                before = index;
                let level = LEVELS[index];
                assert_eq!(level.kind, MeshKind::Sphere);
                let radius_px = 240.0 / 0.5_f32.tan() * 0.2 / away;
                let is_finest = index == Detail::FINEST.mesh(&item, MeshKind::Sphere);
                assert!(is_finest || level.flattening * radius_px * samples_across <= WRONG_SAMPLES, "at {away}");
                // The largest distance by which the mesh may extend beyond the ball, seen from the eye.
                let nearest = away - item.half_extents.length();
                assert!(is_finest || level.flattening * 0.2 <= detail.widest_error() * nearest, "at {away}");
            }
            assert_eq!(
                detail.mesh(&ball(0.2, 0.1), MeshKind::Sphere),
                Detail::FINEST.mesh(&ball(0.2, 0.1), MeshKind::Sphere),
                "around the eye"
            );
            assert_ne!(before, detail.mesh(&ball(0.2, 100.0), MeshKind::Sphere), "far off");
        }
    }

    #[test]
    fn the_suns_map_does_not_depend_on_where_the_eye_is() {
        let sun = SunBox { map_from_world: Mat4::IDENTITY, texel: 0.01, size_texels: [64; 2] };
        let detail = Detail::of_sun_map(&sun);
        assert_eq!(detail.mesh(&ball(0.2, 1.0), MeshKind::Sphere), detail.mesh(&ball(0.2, 50.0), MeshKind::Sphere));
        assert!(detail.mesh(&ball(2.0, 1.0), MeshKind::Sphere) < detail.mesh(&ball(0.02, 1.0), MeshKind::Sphere));
    }

    #[test]
    fn each_kind_has_its_levels() {
        for kind in MeshKind::ALL {
            let (first, last) = LEVELS_OF_KIND[kind as usize];
            assert!((first..=last).all(|index| LEVELS[index].kind == kind), "{kind:?}");
        }
    }
}
