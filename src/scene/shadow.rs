//! Shadow maps (Williams 1978, Casting Curved Shadows on Curved Surfaces): how near to the lamp the first surface
//! is, in each direction. A sun has one map, parallel to its light; a lamp has the six sides of a cube around
//! itself, of which those are drawn that bodies may be seen through. A map depends on bodies and light only:
//! while the camera moves it is kept.

use super::clip::Planes;
use super::raster::{Corner, Grid};
use super::sight::level_of;
use super::{Camera, Lamp, Scene, View};
use crate::solid::Surface;
use glam::Vec3;

/// The map ends so many parts of the ball's radius beyond it.
const MARGIN: f32 = 1.02;
/// Points are compared so many texels off their surface, along its normal where light grazes it: taps that
/// reach a texel and a half to the sides, and corners farther, do not meet the surface itself.
const OFF: f32 = 2.2;
/// The same towards the lamp, whatever the angle.
const LEAST_OFF: f32 = 0.6;
/// Half the angle that a side of the cube looks through: a little more than an eighth of a turn, for the taps.
const SIDE_LENS: f64 = 91.0;

/// One square map.
struct Map {
    side: usize,
    way: Way,
    /// Greater is nearer to the lamp; the lowest number where nothing is.
    near: Vec<f32>,
}

/// How a map's texels lie to the world.
#[derive(Clone, Copy)]
enum Way {
    /// Parallel: the middle of the map, vectors across, up and to the lamp, and texels for each unit.
    Along {
        middle: Vec3,
        axes: [Vec3; 3],
        scale: f32,
    },
    /// From a place.
    From(View),
}

/// Shadow maps, in the making until [`Shadows::advance`] says so.
pub(super) struct Shadows {
    lamp: Lamp,
    maps: Vec<Map>,
    is_coarse: bool,
    /// The map and the instance that come next.
    at: [usize; 2],
    corners: Vec<Corner>,
}

impl Shadows {
    /// Maps of so many texels along a side. Coarse ones are of coarser bodies, too.
    pub fn new(scene: &Scene, lamp: Lamp, side: usize, is_coarse: bool) -> Self {
        let ball = scene.ball();
        let maps = ways(ball, lamp, side);
        Self {
            lamp,
            maps: maps.into_iter().map(|way| Map::new(way, side)).collect(),
            is_coarse,
            at: [0, 0],
            corners: Vec::new(),
        }
    }

    /// Goes on for about the work of so many triangles; true when all maps are there.
    pub fn advance(&mut self, scene: &Scene, amount: usize) -> bool {
        let mut left = amount as i64;
        while left > 0 {
            let [map, place] = self.at;
            let Some(map) = self.maps.get_mut(map) else {
                return true;
            };
            if place == scene.instances.len() {
                self.at = [self.at[0] + 1, 0];
                continue;
            }
            left -= map.draw(scene, place, self.is_coarse, &mut self.corners) as i64;
            self.at[1] += 1;
        }
        false
    }

    /// How much of the lamp is seen from a point of a surface, 0..1. `normal` is that of the surface, `to_lamp` the unit
    /// vector to the lamp.
    pub fn visible(&self, point: Vec3, normal: Vec3, to_lamp: Vec3) -> f32 {
        let cosine = normal.dot(to_lamp);
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        match self.lamp {
            Lamp::Sun(_) => self.maps.first().map_or(1.0, |map| {
                let texel = map.texel(point);
                let off = normal * (OFF * sine * texel) + to_lamp * (LEAST_OFF * texel);
                map.visible(point + off)
            }),
            Lamp::Bulb { .. } => {
                let near = |map: &Map| map.is_towards(point);
                let map = self.maps.iter().find(|map| near(map));
                map.map_or(1.0, |map| {
                    let texel = map.texel(point);
                    let off = normal * (OFF * sine * texel) + to_lamp * (LEAST_OFF * texel);
                    map.visible(point + off)
                })
            }
        }
    }
}

/// The maps that a lamp needs to light a ball.
fn ways((middle, radius): (Vec3, f32), lamp: Lamp, side: usize) -> Vec<Way> {
    match lamp {
        Lamp::Sun(to) => {
            let across = to.any_orthonormal_vector();
            vec![Way::Along {
                middle,
                axes: [across, to.cross(across), to],
                scale: 0.5 * side as f32 / (radius * MARGIN).max(f32::MIN_POSITIVE),
            }]
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
            seen.map(Way::From).collect()
        }
    }
}

impl Map {
    fn new(way: Way, side: usize) -> Self {
        Self {
            side,
            way,
            near: vec![f32::MIN; side * side],
        }
    }

    /// How large a texel is at a point, in the world.
    fn texel(&self, point: Vec3) -> f32 {
        match &self.way {
            Way::Along { scale, .. } => 1.0 / scale,
            Way::From(view) => view.of(point).z.max(view.near) / view.focal,
        }
    }

    /// Does a point lie on the side of the cube that this map looks through?
    fn is_towards(&self, point: Vec3) -> bool {
        match &self.way {
            Way::Along { .. } => true,
            Way::From(view) => {
                let seen = view.of(point);
                seen.z > view.near && seen.x.abs() <= seen.z && seen.y.abs() <= seen.z
            }
        }
    }

    /// A point in texels, with how near it is to the lamp.
    #[inline(always)]
    fn on_map(&self, p: Vec3) -> Corner {
        match &self.way {
            Way::Along {
                middle,
                axes,
                scale,
            } => {
                let d = p - *middle;
                let half = 0.5 * self.side as f32;
                [
                    half + d.dot(axes[0]) * scale,
                    half - d.dot(axes[1]) * scale,
                    d.dot(axes[2]),
                ]
            }
            Way::From(view) => view.on_screen(view.of(p)),
        }
    }

    fn visible(&self, p: Vec3) -> f32 {
        let [u, v, near] = self.on_map(p);
        // Three by three texels, each weighted by how much of it lies under a square of that size.
        let (u, v) = (u - 1.5, v - 1.5);
        let (fu, fv) = (u.floor(), v.floor());
        let last = self.side as i32 - 4;
        let (i, j) = (fu as i32, fv as i32);
        if i < 0 || j < 0 || i > last || j > last {
            return 1.0;
        }
        let (tu, tv) = (u - fu, v - fv);
        let across = [1.0 - tu, 1.0, 1.0, tu];
        let down = [1.0 - tv, 1.0, 1.0, tv];
        let mut sum = 0.0;
        for (row, weight) in down.into_iter().enumerate() {
            let first = (j as usize + row) * self.side + i as usize;
            let texels = &self.near[first..][..4];
            let mut lit = 0.0;
            for k in 0..4 {
                lit += if texels[k] > near { 0.0 } else { across[k] };
            }
            sum += weight * lit;
        }
        sum / 9.0
    }

    /// Draws an instance; answers with the work that it was.
    fn draw(&mut self, scene: &Scene, place: usize, coarse: bool, kept: &mut Vec<Corner>) -> usize {
        let instance = &scene.instances[place];
        let body = &scene.bodies[instance.body as usize];
        let (middle, radius) = scene.ball_of(instance);
        let diameter = match &self.way {
            Way::Along { scale, .. } => 2.0 * radius * scale,
            Way::From(view) => {
                let seen = view.of(middle);
                if !view.may_see(seen, radius) {
                    return 1;
                }
                view.diameter(seen, radius)
            }
        };
        let level = level_of(diameter, body.levels.len(), coarse);
        let Some(surface) = body.levels.get(level) else {
            return 1;
        };
        match self.way {
            Way::Along { .. } => {
                kept.clear();
                let corners = surface.positions.iter();
                kept.extend(corners.map(|&p| self.on_map(instance.place.of(p))));
                self.fill(surface, kept);
            }
            Way::From(view) => {
                let seen = surface.positions.iter();
                let seen: Vec<Vec3> = seen.map(|&p| view.of(instance.place.of(p))).collect();
                self.fill_from(&view, surface, &seen);
            }
        }
        surface.triangles.len()
    }

    fn fill(&mut self, surface: &Surface, corners: &[Corner]) {
        let grid = self.grid();
        let near = &mut self.near;
        for triangle in &surface.triangles {
            let corners = triangle.map(|v| corners[v as usize]);
            grid.triangle(corners, |at, here| {
                if here > near[at] {
                    near[at] = here;
                }
            });
        }
    }

    fn fill_from(&mut self, view: &View, surface: &Surface, seen: &[Vec3]) {
        let (grid, planes) = (self.grid(), Planes::new(view));
        let near = &mut self.near;
        for triangle in &surface.triangles {
            let corners = triangle.map(|v| seen[v as usize]);
            let [a, b, c] = corners.map(|p| planes.beyond(p));
            if a & b & c != 0 {
                continue;
            }
            let cut = planes.cut(corners, a | b | c);
            let screen = |k: usize| view.on_screen(cut.corners[k]);
            for k in 2..cut.count {
                grid.triangle([screen(0), screen(k - 1), screen(k)], |at, here| {
                    if here > near[at] {
                        near[at] = here;
                    }
                });
            }
        }
    }

    fn grid(&self) -> Grid {
        Grid {
            width: self.side,
            height: self.side,
        }
    }
}
