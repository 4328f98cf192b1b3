//! The round piece of ground that a building stands on: grass, gravel or paving.

use super::colours::{GRASS_ROW, SOIL_ROW};
use super::disc::{Disc, THICK};
use super::params::GroundParams;
use super::parts::add_plain;
use super::site::BuildingSite;
use crate::building::{Building, Face, FaceId};
use crate::masonry::plan::region;
use crate::masonry::region::Region;
use crate::random::{Purpose, Random};
use crate::scene::{Body, Instance, Paint, Place, Scene};
use crate::solid::Surface;
use glam::{DVec3, Vec2, Vec3};
use std::f64::consts::TAU;

/// The width of the ground's rounded rim (metres).
const RIM: f64 = 0.05;
/// No grass grows closer than this to an underside of the building. Undersides that begin higher than `HIGH` do not
/// count (metres).
const COVERED: f64 = 0.5;
const HIGH: f64 = 0.6;
/// Corners around the ground.
const AROUND: u32 = 128;
/// Tufts of grass on a square metre, and the most tufts in all.
const TUFTS: (f64, usize) = (210.0, 7000);
/// Tufts in a slice of the work.
const SLICE: usize = 100;
/// Blades in a tuft, their height, their width and how far they lean (metres).
const BLADES: u32 = 6;
const BLADE: [f64; 3] = [0.075, 0.011, 0.04];
/// The number of different tufts.
const KINDS: u64 = 5;
/// The size of pebbles, and the length and width of flags (metres).
const PEBBLE: f32 = 0.045;
const FLAG: [f32; 2] = [0.6, 0.4];
/// The colours of blades.
const GREENS: [[u8; 3]; 4] = [
    [124, 136, 66],
    [106, 126, 58],
    [138, 144, 78],
    [98, 116, 60],
];

/// The colour of the ground with this word; `None` for the floor of a studio.
fn colour(word: &str) -> Option<[u8; 3]> {
    match word {
        "grass" => Some([100, 108, 56]),
        "gravel" => Some([168, 158, 140]),
        "paving" => Some([142, 138, 130]),
        _ => None,
    }
}

/// The ground below a building in the making: grass is added in slices.
pub(crate) struct GroundWork {
    scene: Scene,
    disc: Disc,
    /// The faces on which the building stands, with their regions.
    feet: Vec<(FaceId, Region)>,
    random: Random,
    /// The number of tufts that are still to be added.
    left: usize,
    /// The index of the first body of a tuft.
    first: u32,
}

impl GroundWork {
    /// The ground without grass.
    pub(super) fn new(site: &BuildingSite, params: &GroundParams) -> Self {
        let mut scene = Scene::default();
        let disc = Disc::new(&site.building);
        if let Some(tint) = colour(params.word) {
            add_plain(&mut scene, disc.surface(site), (0, tint, SOIL_ROW));
        }
        let first = scene.bodies.len() as u32;
        let (mut left, mut feet) = (0, Vec::new());
        if params.word == "grass" {
            let kinds = (0..KINDS).map(|kind| Body::new(vec![tuft(params.seed, kind)], GRASS_ROW));
            scene.bodies.extend(kinds);
            let area = 0.5 * TAU * disc.radius * disc.radius;
            left = ((TUFTS.0 * area) as usize).min(TUFTS.1);
            feet = self::feet(&site.building, disc.middle.y + HIGH);
        }
        Self {
            scene,
            disc,
            feet,
            random: Random::new(params.seed, Purpose::Scatter, 0),
            left,
            first,
        }
    }

    /// Adds some tufts of grass. Returns the scene of the ground when all are there.
    pub(super) fn advance(&mut self, site: &BuildingSite) -> Option<Scene> {
        let count = self.left.min(SLICE);
        for _ in 0..count {
            self.add_tuft(site);
        }
        self.left -= count;
        (self.left == 0).then(|| std::mem::take(&mut self.scene))
    }

    fn add_tuft(&mut self, site: &BuildingSite) {
        let random = &mut self.random;
        let away = (self.disc.radius - 0.5 * RIM) * random.unit().sqrt();
        let [(sin, cos), (turn, straight)] =
            [random.unit(), random.unit()].map(|v| libm::sincos(TAU * v));
        let p = self.disc.middle + away * DVec3::new(cos, 0.0, sin);
        let size = site.fit.scale * (0.6 + 0.6 * random.unit());
        let kind = random.below(KINDS as usize) as u32;
        let tint = GREENS[random.below(GREENS.len())];
        let covers = |(face, region): &(FaceId, Region)| {
            let face = site.building.face(*face);
            let place = face.surface.project(p);
            let [low, high] = face.bounds();
            let at = place.truncate();
            let is_near = place.z.abs() < COVERED && at.cmpge(low).all() && at.cmple(high).all();
            is_near && region.contains(at)
        };
        if self.feet.iter().any(covers) {
            return;
        }
        let axes = [
            DVec3::new(straight, 0.0, -turn),
            DVec3::Y,
            DVec3::new(turn, 0.0, straight),
        ];
        self.scene.instances.push(Instance {
            body: self.first + kind,
            place: Place {
                axes: axes.map(|axis| (axis * size).as_vec3()),
                origin: site.fit.place(p),
            },
            id: 0,
            paint: Some(Paint {
                tint,
                material: GRASS_ROW,
            }),
        });
    }
}

impl Disc {
    /// A disc with a rounded rim.
    fn surface(&self, site: &BuildingSite) -> Surface {
        let rings = [
            (-RIM, 0.0),
            (-0.3 * RIM, -0.2 * RIM),
            (0.0, -RIM),
            (0.0, -THICK),
        ];
        let mut surface = Surface::default();
        let mut add = |p: DVec3, normal: DVec3| {
            surface.positions.push(site.fit.place(p));
            surface.normals.push(normal.as_vec3());
            surface.colours.push([255; 3]);
        };
        add(self.middle, DVec3::Y);
        for (k, (out, y)) in rings.into_iter().enumerate() {
            for j in 0..AROUND {
                let (sin, cos) = libm::sincos(TAU * f64::from(j) / f64::from(AROUND));
                let way = DVec3::new(cos, 0.0, -sin);
                let normal = way
                    .lerp(DVec3::Y, [1.0, 0.6, 0.1, 0.0][k])
                    .normalize_or(way);
                add(
                    self.middle + way * (self.radius + out) + DVec3::Y * y,
                    normal,
                );
            }
        }
        let next = |j: u32| (j + 1) % AROUND;
        surface.triangles = (0..AROUND).map(|j| [0, 1 + j, 1 + next(j)]).collect();
        for ring in 0..rings.len() as u32 - 1 {
            let at = |k: u32, j: u32| 1 + k * AROUND + j;
            for j in 0..AROUND {
                let [a, b, c, d] = [
                    at(ring, j),
                    at(ring, next(j)),
                    at(ring + 1, next(j)),
                    at(ring + 1, j),
                ];
                surface.triangles.extend([[a, d, c], [a, c, b]]);
            }
        }
        surface
    }
}

/// The faces on which a building stands, with their regions: faces that look down and begin below the height `high`
/// (metres). So heads of windows are left out.
fn feet(building: &Building, high: f64) -> Vec<(FaceId, Region)> {
    let begins_below = |face: &Face| {
        let polygons = face.polygons.iter().map(|&id| building.polygon(id));
        let mut places = polygons.flat_map(|polygon| &polygon.vertices);
        places.any(|&v| building.vertex(v).position.y < high)
    };
    let stands = |id: &FaceId| {
        let face = building.face(*id);
        let [low, high] = face.bounds();
        let middle = low.midpoint(high);
        face.surface.frame(middle.x, middle.y).normal.y < -0.9 && begins_below(face)
    };
    let faces = building.face_ids().filter(stands);
    faces.map(|id| (id, region(building.face(id)))).collect()
}

/// Some blades of grass that lean away from each other, as thin pyramids (metres).
fn tuft(seed: u64, kind: u64) -> Surface {
    let mut random = Random::new(seed, Purpose::Scatter, 1 + kind);
    let mut surface = Surface::default();
    for k in 0..BLADES {
        let angle = TAU * (f64::from(k) + random.unit()) / f64::from(BLADES);
        let (sin, cos) = libm::sincos(angle);
        let (way, side) = (DVec3::new(cos, 0.0, sin), DVec3::new(-sin, 0.0, cos));
        let [tall, wide, lean] = BLADE.map(|size| size * (0.55 + 0.8 * random.unit()));
        let foot = way * (0.035 * random.unit()) - DVec3::Y * 0.004;
        let tip = foot + DVec3::Y * tall + way * lean;
        let base = [side * wide * 0.5, way * wide * 0.6, side * wide * -0.5].map(|off| foot + off);
        let first = surface.positions.len() as u32;
        for (p, shade) in base.into_iter().map(|p| (p, 150)).chain([(tip, 255)]) {
            surface.positions.push(p.as_vec3());
            surface
                .normals
                .push((DVec3::Y + way * 0.45).normalize().as_vec3());
            surface.colours.push([shade; 3]);
        }
        let sides = [[0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 2, 1]];
        surface
            .triangles
            .extend(sides.map(|side| side.map(|v: u32| first + v)));
    }
    surface
}

/// The colour factor of the ground at a place (metres), with broad and fine noise. `sharp` falls from 1 to 0 as pixels
/// become too wide to show pebbles.
pub(super) fn relief(word: &str, at: Vec3, [broad, fine]: [f32; 2], sharp: f32) -> f32 {
    match word {
        "gravel" => 1.0 + 0.03 * broad + 0.04 * fine + sharp * (pebbles(at) - 1.0),
        "paving" => flags(at) * (1.0 + 0.03 * broad + 0.05 * fine),
        _ => 1.0 + 0.08 * broad + 0.10 * fine,
    }
}

/// A random number from 0 to 1 for a cell of a grid. Each `salt` gives another one.
fn cell_number([x, y]: [i32; 2], salt: u32) -> f32 {
    let mut mixed =
        (x as u32).wrapping_mul(0x9E37_79B1) ^ (y as u32).wrapping_mul(0x85EB_CA77) ^ salt;
    mixed = (mixed ^ (mixed >> 15)).wrapping_mul(0x2C1B_3C6D);
    mixed = (mixed ^ (mixed >> 12)).wrapping_mul(0x297A_2D39);
    ((mixed ^ (mixed >> 15)) >> 16) as f32 / 65_536.0
}

/// Pebbles: cells about points of a jittered grid, dark between them (Worley 1996, A Cellular Texture Basis Function).
fn pebbles(at: Vec3) -> f32 {
    let p = Vec2::new(at.x, at.z) / PEBBLE;
    let base = p.floor();
    let (mut nearest, mut next, mut tone) = (f32::MAX, f32::MAX, 0.0);
    for k in 0..9 {
        let cell = base + Vec2::new((k % 3) as f32 - 1.0, (k / 3) as f32 - 1.0);
        let key = [cell.x as i32, cell.y as i32];
        let point = cell + Vec2::new(cell_number(key, 1), cell_number(key, 2));
        let away = point.distance(p);
        if away < nearest {
            (next, nearest, tone) = (nearest, away, cell_number(key, 3));
        } else if away < next {
            next = away;
        }
    }
    let gap = ((next - nearest) / 0.3).clamp(0.0, 1.0);
    (0.72 + 0.5 * tone) * (0.55 + 0.45 * gap)
}

/// Flags in running bond: the tone of each, and dark joints.
fn flags(at: Vec3) -> f32 {
    let [wide, deep] = FLAG;
    let row = (at.z / deep).floor();
    let along = at.x / wide + 0.5 * row;
    let edge = |part: f32, size: f32| {
        let part = part - part.floor();
        part.min(1.0 - part) * size
    };
    if edge(along, wide).min(edge(at.z / deep, deep)) < 0.006 {
        return 0.55;
    }
    0.88 + 0.24 * cell_number([along.floor() as i32, row as i32], 4)
}
