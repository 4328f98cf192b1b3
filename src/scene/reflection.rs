//! The light that surfaces send to the eye, for four pixels at once and without tables.

use super::Lamp;
use super::four_lanes::{FourVectors, all, power, share};
use super::tile::{Vectors, get};
use crate::light::{GAP, LAMP, SKY, SMOOTH, STEEP, ShadeParams};
use crate::material::Material;
use crate::order::{greater, lesser};
use wide::f32x4;

/// The light that the floor reflects, linear, on a face that looks straight down.
const BOUNCE: [f32; 3] = [0.47, 0.43, 0.37];
/// The share of it that comes from bodies beside, and the share that does not depend on the lamp's strength.
const BESIDE: f32 = 0.3;
const STEADY: f32 = 0.3;
/// The strength of a rim light from behind, relative to the sky's light, on a face seen from its edge.
const RIM: f32 = 0.7;

/// The visible shares, 0..1, of the lights at a point.
#[derive(Clone, Copy)]
pub(super) struct Reaching {
    /// The lamp's share.
    pub lamp: f32,
    /// The sky's share past bodies near the point.
    pub sky: f32,
    /// The sky's share over the floor below the point.
    pub floor: f32,
}

impl Reaching {
    /// Nothing is hidden.
    pub const ALL: Self = Self {
        lamp: 1.0,
        sky: 1.0,
        floor: 1.0,
    };

    /// The shares at a pixel of a tile; `lists` has one list for each of them.
    #[inline(always)]
    pub fn at(lists: &Vectors, k: usize) -> Self {
        let [lamp, sky, floor] = get(lists, k).to_array();
        Self { lamp, sky, floor }
    }
}

/// A material with the factors of the recipe: ambient, diffuse and specular share, and exponent; then mirror, room,
/// metal and thin.
pub(super) type SurfaceFinish = [f32; FINISH];
/// The numbers of a finish.
pub(super) const FINISH: usize = 8;

/// The share that a surface mirrors at normal incidence.
const STRAIGHT: f32 = 0.03;
/// The surroundings that are mirrored, linear: the sky at the horizon and straight up, and the floor.
const MIRRORED: [[f32; 3]; 3] = [[0.42, 0.44, 0.47], [1.0, 1.04, 1.1], [0.34, 0.32, 0.28]];
/// The dark line at the horizon: its loss of light, and the inverse of half its width.
const HORIZON: [f32; 2] = [0.75, 7.0];
/// The direction of a room's large window (x and z, a unit vector).
const WINDOW: [f32; 2] = [-0.8, 0.6];
/// The light of a room's walls, how much it grows towards the window, and what the windows and the ceiling add.
const DIM: f32 = 0.46;
const SIDE: f32 = 0.22;
const LARGE: f32 = 2.6;
const SMALL: f32 = 1.0;
const CEILING: f32 = 0.7;
/// How much the direction of a room's parts changes in a unit of the scene.
const NEAR: f32 = 0.5;

/// The finish of a material.
pub(super) fn finish_of(material: &Material, params: &ShadeParams) -> SurfaceFinish {
    let exponent = greater(material.shininess * params.shininess as f32, 0.1);
    [
        material.ambient * params.ambient as f32,
        material.diffuse * params.diffuse as f32,
        material.specular * params.specular as f32,
        exponent,
        lesser(material.mirror * params.specular as f32, 1.0),
        material.room,
        material.metal,
        material.thin,
    ]
}

/// Points of surfaces at four pixels, ready to be lit.
pub(super) struct LitPoints {
    pub positions: FourVectors,
    pub normals: FourVectors,
    /// Unit normals without the fine relief.
    pub smooth: FourVectors,
    /// Unit vectors to the eye.
    pub to_eye: FourVectors,
    /// Visible shares of the lamp, of the sky, and of the sky over the floor; see [`Reaching`].
    pub reaching: FourVectors,
    /// Red, green, blue, 0..255 (sRGB).
    pub colours: FourVectors,
    pub finish: [f32x4; FINISH],
}

/// The share of the sky with the recipe's strength of occlusion.
#[inline(always)]
pub(super) fn open_to(params: &ShadeParams, open: f32) -> f32 {
    1.0 - params.occlusion as f32 * (1.0 - open)
}

/// The share of the lamp with the recipe's strength of shadows.
#[inline(always)]
pub(super) fn seen_of(params: &ShadeParams, seen: f32, open: f32) -> f32 {
    (1.0 - params.shadow as f32 * (1.0 - seen)) * (1.0 - GAP * (1.0 - open))
}

impl LitPoints {
    /// The light to the eye, linear.
    #[inline(always)]
    pub fn light(&self, lamp: &Lamp, params: &ShadeParams) -> FourVectors {
        let [ambient, diffuse, .., metal, thin] = self.finish;
        let (to, strength) = lamp.towards(self.positions);
        let (one, zero) = (f32x4::ONE, f32x4::ZERO);
        let towards = self.normals.dot(to);
        let facing = towards.fast_max(zero);
        let open = one - all(params.occlusion as f32) * (one - self.reaching.y);
        // A surface that faces away from the lamp has no light of it in any case, if it is not thin.
        let seen = one - all(params.shadow as f32) * (one - self.reaching.x);
        let arrives = seen * (one - all(GAP) * (one - open)) * strength;
        let ahead = share(self.normals.dot(self.to_eye));
        let fill = self.fill(open, one - ahead, strength) * ambient;
        let lamp = FourVectors::all(LAMP);
        let through = thin * (-towards).fast_max(zero) * self.reaching.x * strength;
        let scattered = fill + lamp * (diffuse * (facing * arrives + through));
        let albedo = linear(self.colours);
        let white = FourVectors::all([1.0; 3]);
        let tint = white + (albedo - white) * metal;
        let gleam = self.gleam(to);
        // With the lamp behind the surface there is no mirrored light.
        let shine = facing.simd_gt(zero) & (gleam.shine * arrives);
        let straight =
            FourVectors::all([STRAIGHT; 3]) + (albedo - FourVectors::all([STRAIGHT; 3])) * metal;
        let share = (straight + (white - straight) * gleam.edge) * (gleam.mirror * open);
        albedo.times(scattered)
            + lamp.times(tint) * shine
            + share.times(self.surroundings(gleam.along.y) * self.room(gleam.along))
    }

    /// How the points mirror the lamp and their surroundings. `to` is the unit vector to the lamp.
    #[inline(always)]
    fn gleam(&self, to: FourVectors) -> Gleam {
        let [_, _, specular, exponent, mirror, room, ..] = self.finish;
        let one = f32x4::ONE;
        // As in pictures of height fields, a film fills the relief where the highlight is narrow. Bare metal has no
        // film.
        let fine = all(SMOOTH) / (all(SMOOTH) + exponent);
        let fine = fine + (one - fine) * room;
        let relief = self.normals - self.smooth;
        let normals = self.smooth + relief * fine;
        let normals = normals * (one / normals.dot(normals).sqrt().fast_max(all(1e-3)));
        // The relief that is left out widens the highlight (Toksvig 2005, Mipmapping Normal Maps), and dims it.
        let rough = relief.dot(relief) * (one - fine) * (one - fine);
        let wider = one / (one + all(0.25) * exponent * rough);
        let ahead = normals.dot(self.to_eye);
        let twice = ahead + ahead;
        let mirrored = share(twice * normals.dot(to) - to.dot(self.to_eye));
        let edge = one - share(ahead);
        let square = edge * edge;
        Gleam {
            shine: specular * wider * power(mirrored, exponent * wider),
            edge: square * square * edge,
            mirror: mirror * wider,
            along: normals * twice - self.to_eye,
        }
    }

    /// The factor by which a room changes the light of the surroundings in a direction: it is dim, and it has a large
    /// window with a bar, a small one across, and a lit ceiling. Exactly 1 where nothing mirrors a room.
    #[inline(always)]
    fn room(&self, along: FourVectors) -> f32x4 {
        let [.., room, _, _] = self.finish;
        if !room.simd_gt(f32x4::ZERO).any() {
            return f32x4::ONE;
        }
        // The windows are near: what a place mirrors depends on where it is.
        let along = along + self.positions * all(NEAR);
        let [x, z] = WINDOW.map(all);
        let ahead = along.x * x + along.z * z;
        let across = along.x * z - along.z * x;
        let above = |least: f32, steep: f32, v: f32x4| smooth(share((v - all(least)) * all(steep)));
        let height = above(0.02, 8.0, along.y) * above(-0.82, 8.0, -along.y);
        let bar = f32x4::ONE - all(0.8) * share(all(1.5) - all(16.0) * across.abs());
        let large = above(0.25, 6.0, ahead) * height * bar;
        let small = above(0.55, 6.0, -ahead) * height;
        let ceiling = above(0.86, 12.0, along.y);
        let light = all(DIM)
            + all(SIDE) * ahead
            + all(LARGE) * large
            + all(SMALL) * small
            + all(CEILING) * ceiling;
        f32x4::ONE + room * (light.fast_max(all(0.08)) - f32x4::ONE)
    }

    /// The light of the surroundings in a direction with this y: a sky that is bright above, a dark line, and the floor.
    #[inline(always)]
    fn surroundings(&self, up: f32x4) -> FourVectors {
        let [low, high, floor] = MIRRORED.map(FourVectors::all);
        let one = f32x4::ONE;
        let sky = low + (high - low) * share(up);
        let floor = floor * (all(0.3) + all(0.7) * self.reaching.z);
        let is_sky = share(all(0.5) + up * all(12.0));
        let [loss, narrow] = HORIZON.map(all);
        let line = share(one - (up * narrow).abs()) * loss;
        (floor + (sky - floor) * is_sky) * (one - line)
    }

    /// The light that arrives from all but the lamp: from the sky, from the floor, and from behind. `edge` is 1 for a
    /// surface seen from its edge.
    #[inline(always)]
    fn fill(&self, open: f32x4, edge: f32x4, strength: f32x4) -> FourVectors {
        let (one, half, up) = (f32x4::ONE, all(0.5), self.normals.y);
        // The smaller one counts: `above` for surfaces that face up, `below` for those that face down.
        let above = all(STEEP) + all(1.0 - STEEP) * up;
        let below = all(STEEP) + all(STEEP) * up;
        let sky = above.fast_min(below) + all(RIM) * edge * edge * edge * (half + half * up);
        let floor = all(BESIDE) + all(1.0 - BESIDE) * self.reaching.z;
        let floor = floor * (all(STEADY) + all(1.0 - STEADY) * strength.fast_min(one));
        let bounce = (half - half * up) * floor;
        FourVectors::all(SKY) * (open * sky) + FourVectors::all(BOUNCE) * (open * bounce)
    }
}

/// The mirroring of four points.
struct Gleam {
    /// The mirrored share of the lamp.
    shine: f32x4,
    /// 1 at grazing angles, nearly 0 at others (Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering).
    edge: f32x4,
    /// How much of the surroundings is mirrored.
    mirror: f32x4,
    /// The direction that is mirrored to the eye.
    along: FourVectors,
}

/// 3 v² - 2 v³ for v in 0..1.
#[inline(always)]
fn smooth(v: f32x4) -> f32x4 {
    v * v * (all(3.0) - v - v)
}

/// Linear light of colours on the screen (0..255), with an error of about 0.001 of white.
#[inline(always)]
fn linear(colours: FourVectors) -> FourVectors {
    let v = colours * all(1.0 / 255.0);
    let high = FourVectors::all([0.682_171_1; 3]) + v * all(0.305_306);
    v.times(FourVectors::all([0.012_522_9; 3]) + v.times(high))
}
