//! One shadow map: bodies are drawn into it, and points are compared with it.

use super::super::cut::Cut;
use super::super::fill::{Vertex, some_of};
use super::super::four_pixels::{LANES, four_of};
use super::super::visibility::level_of;
use super::super::{Instance, Scene};
use super::projection::ShadowProjection;
use crate::order::greater;
use crate::solid::Surface;
use glam::Vec3;
use wide::f32x4;

/// Balls are enlarged by this factor and by this part of a texel before they are compared with a map, as corners are
/// rounded.
const LARGER: f32 = 1.001;
const SLACK: f32 = 0.05;
/// Balls over more texels are not compared.
const MOST_TEXELS: usize = 256;

/// Making room for this many texels is about the work of one triangle.
const ROOM: usize = 64;

/// One square map.
#[derive(Clone)]
pub(super) struct ShadowMap {
    pub side: usize,
    pub way: ShadowProjection,
    /// The work of filling texels, in triangles.
    pub filled: usize,
    /// For each texel how near the first surface is; greater is nearer to the lamp. The lowest number where there is
    /// none.
    pub near: Vec<f32>,
}

/// A place on a map.
#[derive(Clone, Copy)]
pub(in crate::scene) struct ShadowSample {
    /// The index of the map; if there is no such map, all of the lamp is visible.
    pub(super) map: usize,
    /// The first of four by four texels.
    texel: usize,
    /// The position within that texel, 0..1.
    part: [f32; 2],
    /// How near the place is to the lamp, and by how much that grows for a texel to the right and down.
    near: f32,
    slopes: [f32; 2],
}

impl ShadowSample {
    /// A place on no map.
    pub const BESIDE: Self = Self {
        map: usize::MAX,
        texel: 0,
        part: [0.0; 2],
        near: 0.0,
        slopes: [0.0; 2],
    };
}

impl ShadowMap {
    pub fn new(way: ShadowProjection, side: usize) -> Self {
        Self {
            side,
            way,
            filled: 0,
            near: Vec::with_capacity(side * side + LANES - 1),
        }
    }

    /// The instance that comes at a place of the order of drawing. Most generators list bodies from the ground up, so those
    /// near a lamp come first, and hide many others.
    pub fn in_turn(&self, place: usize, scene: &Scene) -> usize {
        match self.way.is_from_below() {
            true => place,
            false => scene.instances.len() - 1 - place,
        }
    }

    /// Texels, and a few more for the last group of four.
    pub fn room(&self) -> usize {
        self.side * self.side + LANES - 1
    }

    /// Makes room for some more texels; returns the work done.
    pub fn make_room(&mut self, most: usize) -> usize {
        let all = self.room();
        let end = all.min(self.near.len() + most.saturating_mul(ROOM));
        let work = (end - self.near.len()).div_ceil(ROOM);
        self.near.resize(end, f32::MIN);
        work
    }

    /// The place of a point on this map, which has this number; `None` beyond its edges.
    #[inline(always)]
    pub fn spot(&self, number: usize, p: Vec3, normal: Vec3) -> Option<ShadowSample> {
        let [u, v, near] = self.way.on_map(p, self.side);
        // A box filter of three by three texels; texels at its edges count by their covered part.
        let (u, v) = (u - 1.5, v - 1.5);
        let end = (self.side - 3) as f32;
        if !(u >= 0.0 && v >= 0.0 && u < end && v < end) {
            return None;
        }
        let (i, j) = (u as i32, v as i32);
        Some(ShadowSample {
            map: number,
            texel: j as usize * self.side + i as usize,
            part: [u - i as f32, v - j as f32],
            near,
            slopes: self.way.slopes(p, normal),
        })
    }

    #[inline(always)]
    pub fn visible(&self, spot: &ShadowSample) -> f32 {
        let [tu, tv] = spot.part;
        let across = f32x4::new([1.0 - tu, 1.0, 1.0, tu]);
        let down = [1.0 - tv, 1.0, 1.0, tv];
        // Each texel is compared with the surface's plane there. So the surface does not shadow itself, and shadows
        // end where they should.
        let [right, below] = spot.slopes;
        let rights = (f32x4::new([-1.0, 0.0, 1.0, 2.0]) - f32x4::splat(tu)) * f32x4::splat(right);
        let mut lit = f32x4::ZERO;
        for (row, weight) in down.into_iter().enumerate() {
            let Some(texels) = self.near[spot.texel + row * self.side..].first_chunk() else {
                break;
            };
            let start = spot.near + below * (row as f32 - 1.0 - tv);
            let is_lit = f32x4::from(*texels).simd_le(f32x4::splat(start) + rights);
            lit += is_lit & (across * f32x4::splat(weight));
        }
        let [a, b, c, d] = lit.to_array();
        ((a + b) + (c + d)) * (1.0 / 9.0)
    }

    pub fn blocker(&self, p: Vec3) -> Option<f32> {
        let [u, v, near] = self.way.on_map(p, self.side);
        let end = self.side as f32;
        if !(u >= 0.0 && v >= 0.0 && u < end && v < end) {
            return None;
        }
        let first = self.near[v as usize * self.side + u as usize];
        let is_blocked = first > near;
        is_blocked.then(|| self.way.distance(p, near, first))
    }

    /// The level of an instance that is fine enough for this map; `None` if it lies beside the map.
    fn surface_of<'a>(
        &self,
        scene: &'a Scene,
        instance: &Instance,
        is_coarse: bool,
    ) -> Option<&'a Surface> {
        let body = &scene.bodies[instance.body as usize];
        let diameter = self.way.diameter(scene.ball_of(instance))?;
        body.levels
            .get(level_of(diameter, body.levels.len(), is_coarse))
    }

    /// Like [`ShadowMap::draw`], for an instance that is cut: draws the part of each triangle that is left. Both sides
    /// of that part cast a shadow, as light falls on the inside.
    pub fn draw_cut(
        &mut self,
        scene: &Scene,
        cut: &Cut,
        [place, next]: [usize; 2],
        most: usize,
        is_coarse: bool,
    ) -> (usize, Option<usize>) {
        let instance = &scene.instances[place];
        let Some(surface) = self.surface_of(scene, instance, is_coarse) else {
            return (1, None);
        };
        let mut near = std::mem::take(&mut self.near);
        let fill = self.way.fill();
        let (end, drawn) = some_of(&surface.triangles, next, most, |_, triangle| {
            let corners = triangle.map(|v| instance.place.of(surface.positions[v as usize]));
            let rest = cut.rest_of(corners);
            let corners = rest.corners.map(|p| self.way.vertex(p, self.side));
            let mut work = 1;
            for k in 2..rest.count {
                let [a, b, c] = [corners[0], corners[k - 1], corners[k]];
                for sides in [[a, b, c], [a, c, b]] {
                    work += fill.triangle(sides, |four| {
                        if let Some(near) = four_of(&mut near, four.at) {
                            four.wins(near).near(near);
                        }
                    });
                }
            }
            work
        });
        self.near = near;
        (drawn, (end < surface.triangles.len()).then_some(end))
    }

    /// Whether a body within a ball certainly changes no texel: the ball covers the middle of no texel, or each texel
    /// that it covers shows something nearer.
    fn would_stay(&self, (middle, radius): (Vec3, f32)) -> bool {
        let ShadowProjection::Along { scale, .. } = self.way else {
            return false;
        };
        let [u, v, near] = self.way.on_map(middle, self.side);
        let reach = radius * scale * LARGER + SLACK;
        let nearest = near + reach / scale;
        let texel = |at: f32| greater(at, 0.0) as usize;
        let texels = |at: f32| {
            let end = texel((at + reach + 0.5).floor());
            texel((at - reach - 0.5).ceil())..end.min(self.side)
        };
        let (columns, rows) = (texels(u), texels(v));
        columns.len() * rows.len() <= MOST_TEXELS
            && rows.into_iter().all(|row| {
                let row = &self.near[row * self.side..][..self.side];
                row[columns.clone()].iter().all(|&there| there >= nearest)
            })
    }

    /// Draws an instance from one of its triangles on; returns the work done, and the next triangle if there is one.
    pub fn draw(
        &mut self,
        scene: &Scene,
        [place, next]: [usize; 2],
        most: usize,
        is_coarse: bool,
        corners: &mut Vec<Vertex>,
    ) -> (usize, Option<usize>) {
        let instance = &scene.instances[place];
        let Some(surface) = self.surface_of(scene, instance, is_coarse) else {
            return (1, None);
        };
        let mut work = 0;
        // Only coarse maps leave out hidden bodies: other maps count how often their texels are filled, also by these.
        if next == 0 && is_coarse && self.would_stay(scene.ball_of(instance)) {
            return (1, None);
        }
        if next == 0 {
            let points = surface.positions.iter().map(|&p| instance.place.of(p));
            corners.clear();
            corners.extend(points.map(|p| self.way.vertex(p, self.side)));
            work = surface.positions.len() / 4;
        }
        let fill = self.way.fill();
        let near = &mut self.near[..];
        let most = most.saturating_sub(work).max(1);
        let (end, drawn) = some_of(&surface.triangles, next, most, |_, triangle| {
            let corners = triangle.map(|v| corners[v as usize]);
            fill.triangle(corners, |four| {
                if let Some(near) = four_of(near, four.at) {
                    four.wins(near).near(near);
                }
            })
        });
        self.filled += drawn - (end - next);
        (work + drawn, (end < surface.triangles.len()).then_some(end))
    }
}
