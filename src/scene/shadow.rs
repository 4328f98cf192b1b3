//! Shadow maps (Williams 1978, Casting Curved Shadows on Curved Surfaces): the distance from the lamp to the first
//! surface, in each direction.
//!
//! A sun has one map, parallel to its light. A lamp has the six sides of a cube around itself; only those are drawn
//! through which bodies may be seen. A map depends on bodies and light only, so it is kept while the camera moves.

use super::cut::{Cut, Left};
use super::fill::{Fill, PIXELS, Vertex, some_of};
use super::four_pixels::{LANES, four_of};
use super::raster::Corner;
use super::visibility::level_of;
use super::{Camera, Instance, Lamp, Scene};
use crate::order::greater;
use crate::solid::Surface;
use glam::Vec3;
use wide::f32x4;

/// The half side of the map, in radii of the bounding ball.
const MARGIN: f32 = 1.02;
/// Points are compared this many texels off their surface, because the map may show a coarser or finer level of it. The
/// distance is doubled if all bodies are coarse.
const OFF: f32 = 0.5;
/// The least cosine between a surface and the direction to the lamp; smaller ones are clamped.
const GRAZING: f32 = 1e-3;
/// The angle of view of a side of the cube, in degrees: a little more than 90, so that the filter's samples stay on
/// it.
const SIDE_LENS: f64 = 91.0;

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
struct ShadowMap {
    side: usize,
    way: ShadowProjection,
    /// The work of filling texels, in triangles.
    filled: usize,
    /// For each texel how near the first surface is; greater is nearer to the lamp. The lowest number where there is
    /// none.
    near: Vec<f32>,
}

/// The projection of a map.
#[derive(Clone, Copy)]
enum ShadowProjection {
    /// Parallel: the middle of the map, unit vectors across, up and to the lamp, and texels for each unit.
    Along {
        middle: Vec3,
        axes: [Vec3; 3],
        scale: f32,
        /// Rasterises into the map's pixels; nothing is clipped.
        fill: Fill,
    },
    /// Perspective, from a point.
    From(Fill),
}

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
        Self::along(ways(scene.ball(), lamp, side), side, is_coarse)
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
        let Some((number, map)) = maps.find(|(_, map)| map.is_towards(point)) else {
            return ShadowSample::BESIDE;
        };
        let levels = if self.is_coarse { 2.0 } else { 1.0 };
        let off = OFF * levels * map.texel(point) + slack;
        let spot = map.spot(point + normal * off, normal);
        spot.map_or(ShadowSample::BESIDE, |spot| ShadowSample {
            map: number,
            ..spot
        })
    }

    /// The distance from a point to the body that the lamp's light meets first on its way there; `None` if there is no
    /// body.
    pub fn blocker(&self, point: Vec3) -> Option<f32> {
        let map = self.maps.iter().find(|map| map.is_towards(point))?;
        map.blocker(point)
    }

    /// The visible share of the lamp at a place, 0..1.
    #[inline(always)]
    pub fn visible(&self, spot: &ShadowSample) -> f32 {
        let map = self.maps.get(spot.map);
        map.map_or(1.0, |map| map.visible(spot))
    }
}

/// A place on a map.
#[derive(Clone, Copy)]
pub(super) struct ShadowSample {
    /// The index of the map; if there is no such map, all of the lamp is visible.
    map: usize,
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

/// The projections that a lamp needs to light a ball.
fn ways((middle, radius): (Vec3, f32), lamp: Lamp, side: usize) -> Vec<ShadowProjection> {
    match lamp {
        Lamp::Sun(to) => {
            let axes = [to, to.any_orthonormal_vector()];
            vec![ShadowProjection::along(middle, radius * MARGIN, axes, side)]
        }
        Lamp::Bulb { at, .. } => {
            let sides = [
                (0.0, 0.0),
                (90.0, 0.0),
                (180.0, 0.0),
                (270.0, 0.0),
                (0.0, 90.0),
                (0.0, -90.0),
            ];
            let views = sides.into_iter().map(|(angle, height)| {
                let camera = Camera {
                    angle,
                    height,
                    lens: SIDE_LENS,
                    ..Camera::default()
                };
                let mut view = camera.view(side, side);
                view.eye = at;
                view.near = (2e-3 * radius).max(f32::MIN_POSITIVE);
                view
            });
            let seen = views.filter(|view| view.may_see(view.of(middle), radius));
            seen.map(|view| ShadowProjection::From(Fill::new(view)))
                .collect()
        }
    }
}

impl ShadowProjection {
    /// Parallel to `to`, with rows along `across`, for all within `half` of the middle.
    fn along(middle: Vec3, half: f32, [to, across]: [Vec3; 2], side: usize) -> Self {
        Self::Along {
            middle,
            axes: [across, to.cross(across), to],
            scale: 0.5 * side as f32 / half.max(f32::MIN_POSITIVE),
            fill: Fill::new(Camera::default().view(side, side)),
        }
    }
}

impl ShadowMap {
    fn new(way: ShadowProjection, side: usize) -> Self {
        Self {
            side,
            way,
            filled: 0,
            near: Vec::with_capacity(side * side + LANES - 1),
        }
    }

    /// The instance that comes at a place of the order of drawing. Most generators list bodies from the ground up, so those
    /// near a lamp come first, and hide many others.
    fn in_turn(&self, place: usize, scene: &Scene) -> usize {
        let is_from_below =
            matches!(self.way, ShadowProjection::Along { axes: [.., to], .. } if to.y < 0.0);
        match is_from_below {
            true => place,
            false => scene.instances.len() - 1 - place,
        }
    }

    /// Texels, and a few more for the last group of four.
    fn room(&self) -> usize {
        self.side * self.side + LANES - 1
    }

    /// Makes room for some more texels; returns the work done.
    fn make_room(&mut self, most: usize) -> usize {
        let all = self.room();
        let end = all.min(self.near.len() + most.saturating_mul(ROOM));
        let work = (end - self.near.len()).div_ceil(ROOM);
        self.near.resize(end, f32::MIN);
        work
    }

    /// The size of a texel at a point, in the world.
    fn texel(&self, point: Vec3) -> f32 {
        match &self.way {
            ShadowProjection::Along { scale, .. } => 1.0 / scale,
            ShadowProjection::From(fill) => {
                let view = &fill.view;
                greater(view.of(point).z, view.near) * view.slope
            }
        }
    }

    /// Whether a point lies on the side of the cube that this map shows.
    fn is_towards(&self, point: Vec3) -> bool {
        match &self.way {
            ShadowProjection::Along { .. } => true,
            ShadowProjection::From(fill) => {
                let seen = fill.view.of(point);
                seen.z > fill.view.near && seen.x.abs() <= seen.z && seen.y.abs() <= seen.z
            }
        }
    }

    /// A point in texels, and how near it is to the lamp.
    #[inline(always)]
    fn on_map(&self, p: Vec3) -> [f32; 3] {
        match &self.way {
            ShadowProjection::Along {
                middle,
                axes,
                scale,
                ..
            } => {
                let d = p - *middle;
                let half = 0.5 * self.side as f32;
                [
                    half + d.dot(axes[0]) * scale,
                    half - d.dot(axes[1]) * scale,
                    d.dot(axes[2]),
                ]
            }
            ShadowProjection::From(fill) => fill.view.on_screen(fill.view.of(p)),
        }
    }

    /// For the plane through a point: how much nearer to the lamp it comes for each texel to the right and down.
    fn slopes(&self, p: Vec3, normal: Vec3) -> [f32; 2] {
        match &self.way {
            ShadowProjection::Along { axes, scale, .. } => {
                let [x, y, facing] = axes.map(|axis| normal.dot(axis));
                let part = 1.0 / (scale * greater(facing, GRAZING));
                [-x * part, y * part]
            }
            ShadowProjection::From(fill) => {
                // The inverse depth is linear over a plane, too. With a ray r of depth 1, the normal n and the vector q
                // from the lamp to any point of the plane, it is (n . r) / (n . q).
                let view = &fill.view;
                let way = p - view.eye;
                let facing = greater(-normal.dot(way), GRAZING * way.length());
                let part = 1.0 / (view.focal * greater(facing, f32::MIN_POSITIVE));
                [-normal.dot(view.right) * part, normal.dot(view.up) * part]
            }
        }
    }

    /// The place of a point on this map; `None` beyond its edges.
    #[inline(always)]
    fn spot(&self, p: Vec3, normal: Vec3) -> Option<ShadowSample> {
        let [u, v, near] = self.on_map(p);
        // A box filter of three by three texels; texels at its edges count by their covered part.
        let (u, v) = (u - 1.5, v - 1.5);
        let end = (self.side - 3) as f32;
        if !(u >= 0.0 && v >= 0.0 && u < end && v < end) {
            return None;
        }
        let (i, j) = (u as i32, v as i32);
        Some(ShadowSample {
            map: 0,
            texel: j as usize * self.side + i as usize,
            part: [u - i as f32, v - j as f32],
            near,
            slopes: self.slopes(p, normal),
        })
    }

    #[inline(always)]
    fn visible(&self, spot: &ShadowSample) -> f32 {
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

    fn blocker(&self, p: Vec3) -> Option<f32> {
        let [u, v, near] = self.on_map(p);
        let end = self.side as f32;
        if !(u >= 0.0 && v >= 0.0 && u < end && v < end) {
            return None;
        }
        let first = self.near[v as usize * self.side + u as usize];
        let is_blocked = first > near;
        is_blocked.then(|| match &self.way {
            ShadowProjection::Along { .. } => first - near,
            ShadowProjection::From(fill) => (p - fill.view.eye).length() * (1.0 - near / first),
        })
    }

    /// The level of an instance that is fine enough for this map; `None` if it lies beside the map.
    fn surface_of<'a>(
        &self,
        scene: &'a Scene,
        instance: &Instance,
        is_coarse: bool,
    ) -> Option<&'a Surface> {
        let body = &scene.bodies[instance.body as usize];
        let (middle, radius) = scene.ball_of(instance);
        let diameter = match &self.way {
            ShadowProjection::Along { scale, .. } => 2.0 * radius * scale,
            ShadowProjection::From(fill) => {
                let seen = fill.view.of(middle);
                if !fill.view.may_see(seen, radius) {
                    return None;
                }
                fill.view.diameter(seen, radius)
            }
        };
        body.levels
            .get(level_of(diameter, body.levels.len(), is_coarse))
    }

    /// Like [`ShadowMap::draw`], for an instance that is cut: draws the part of each triangle that is left. Both sides
    /// of that part cast a shadow, as light falls on the inside.
    fn draw_cut(
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
        let (ShadowProjection::Along { fill, .. } | ShadowProjection::From(fill)) = &self.way;
        let (end, drawn) = some_of(&surface.triangles, next, most, |_, triangle| {
            let corners = triangle.map(|v| instance.place.of(surface.positions[v as usize]));
            let rest = cut.rest_of(corners);
            let corners = rest.corners.map(|p| match &self.way {
                ShadowProjection::Along { .. } => Vertex::on_screen(Corner::new(self.on_map(p))),
                ShadowProjection::From(fill) => fill.vertex(p),
            });
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
        let [u, v, near] = self.on_map(middle);
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
    fn draw(
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
            match &self.way {
                ShadowProjection::Along { .. } => {
                    corners.extend(points.map(|p| Vertex::on_screen(Corner::new(self.on_map(p)))));
                }
                ShadowProjection::From(fill) => corners.extend(points.map(|p| fill.vertex(p))),
            }
            work = surface.positions.len() / 4;
        }
        let (ShadowProjection::Along { fill, .. } | ShadowProjection::From(fill)) = &self.way;
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

#[cfg(test)]
mod tests;
