//! Shadow maps (Williams 1978, Casting Curved Shadows on Curved Surfaces): the distance from the lamp to the first
//! surface, in each direction.
//!
//! A sun has one map, parallel to its light. A lamp has the six sides of a cube around itself; only those are drawn
//! through which bodies may be seen. A map depends on bodies and light only, so it is kept while the camera moves.

mod map;
mod projection;

pub(super) use map::ShadowSample;

use super::cut::{Cut, Left};
use super::fill::{PIXELS, Vertex};
use super::{Lamp, Scene};
use glam::Vec3;
use map::ShadowMap;
use projection::ShadowProjection;

/// Points are compared this many texels off their surface, because the map may show a coarser or finer level of it. The
/// distance is doubled if all bodies are coarse.
const OFF: f32 = 0.5;

/// The shadow maps of a scene; complete when [`ShadowMaps::advance`] has returned true.
#[derive(Clone)]
pub(super) struct ShadowMaps {
    maps: Vec<ShadowMap>,
    is_coarse: bool,
    /// The plane that cuts away bodies.
    pub cut: Option<Cut>,
    /// The next map, place in its order of drawing, and triangle.
    at: [usize; 3],
    /// The corners of the current instance.
    corners: Vec<Vertex>,
}

impl ShadowMaps {
    /// Maps with `side` texels along a side. Coarse ones also show coarser bodies.
    pub fn new(scene: &Scene, lamp: Lamp, side: usize, is_coarse: bool) -> Self {
        let projections = ShadowProjection::of_lamp(scene.ball(), lamp, side);
        Self::along(projections, side, is_coarse)
    }

    /// Maps from straight below and from straight above that cover `half` around the middle. Columns of both run along
    /// x, rows of the first against z, and rows of the second along it.
    pub fn upright((middle, half): (Vec3, f32), side: usize) -> Self {
        let map = |up: f32| ShadowProjection::along(middle, half, [Vec3::Y * up, Vec3::X], side);
        Self::along(vec![map(-1.0), map(1.0)], side, true)
    }

    fn along(maps: Vec<ShadowProjection>, side: usize, is_coarse: bool) -> Self {
        Self {
            maps: maps
                .into_iter()
                .map(|way| ShadowMap::new(way, side))
                .collect(),
            is_coarse,
            cut: None,
            at: [0; 3],
            corners: Vec::new(),
        }
    }

    /// How many times all texels of all maps have been filled, those of tiny triangles left out.
    pub fn layers(&self) -> usize {
        let filled: usize = self.maps.iter().map(|map| map.filled).sum();
        let texels: usize = self.maps.iter().map(|map| map.side * map.side).sum();
        filled / (texels / PIXELS).max(1)
    }

    /// For each texel of [`ShadowMaps::upright`] how near the first surface is, from the middle; the lowest number where
    /// there is none.
    pub fn nears(&self) -> [&[f32]; 2] {
        [0, 1].map(|k| &self.maps[k].near[..])
    }

    /// Does the work of about `amount` triangles; true when all maps are complete.
    pub fn advance(&mut self, scene: &Scene, amount: usize) -> bool {
        let mut left = amount;
        while left > 0 {
            let [map, place, next] = self.at;
            let Some(map) = self.maps.get_mut(map) else {
                return true;
            };
            if map.near.len() < map.room() {
                left = left.saturating_sub(map.make_room(left));
                continue;
            }
            if place == scene.instances.len() {
                self.at = [self.at[0] + 1, 0, 0];
                continue;
            }
            let number = map.in_turn(place, scene);
            let instance = &scene.instances[number];
            let part = self
                .cut
                .map_or(Left::All, |cut| cut.left_of(scene.ball_of(instance)));
            let (work, next) = match (part, &self.cut) {
                (Left::None, _) => (1, None),
                (Left::Some, Some(cut)) => {
                    map.draw_cut(scene, cut, [number, next], left, self.is_coarse)
                }
                _ => map.draw(
                    scene,
                    [number, next],
                    left,
                    self.is_coarse,
                    &mut self.corners,
                ),
            };
            left = left.saturating_sub(work);
            match next {
                Some(next) => self.at[2] = next,
                None => self.at = [self.at[0], place + 1, 0],
            }
        }
        false
    }

    /// The place in the maps that tells how much of the lamp is visible from a point. `normal` is that of the surface,
    /// which must face the lamp. `slack` is how far the point may lie off the body's own surface, in the world, in
    /// addition to the tolerance of the map.
    pub fn spot(&self, point: Vec3, normal: Vec3, slack: f32) -> ShadowSample {
        let mut maps = self.maps.iter().enumerate();
        let Some((number, map)) = maps.find(|(_, map)| map.way.is_towards(point)) else {
            return ShadowSample::BESIDE;
        };
        let levels = if self.is_coarse { 2.0 } else { 1.0 };
        let off = OFF * levels * map.way.texel(point) + slack;
        let spot = map.spot(number, point + normal * off, normal);
        spot.unwrap_or(ShadowSample::BESIDE)
    }

    /// The distance from a point to the body that the lamp's light meets first on its way there; `None` if there is no
    /// body.
    pub fn blocker(&self, point: Vec3) -> Option<f32> {
        let map = self.maps.iter().find(|map| map.way.is_towards(point))?;
        map.blocker(point)
    }

    /// The visible share of the lamp at a place, 0..1.
    #[inline(always)]
    pub fn visible(&self, spot: &ShadowSample) -> f32 {
        let map = self.maps.get(spot.map);
        map.map_or(1.0, |map| map.visible(spot))
    }
}

#[cfg(test)]
mod tests;
