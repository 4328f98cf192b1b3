//! Colour, material and relief of stones on a surface and of the ground, at vertices and at pixels.
//!
//! A stone looks as in the plane: colours, grain and relief come from its face, in the coordinates of the flat stone. A
//! place of the surface is mapped back to these coordinates. So there are no seams, and no pattern is stretched. The
//! ground shows the bed of pavements from three sides, weighted by the directions in which the surface faces.

use super::UnfoldedCell;
use crate::cells::Cell;
use crate::field::smoothstep_f32;
use crate::heightfield::{Bed, Surfaces, TextureParams, between};
use crate::material::{
    Coat, Effects, GROUND_ROW, LEVEL, Palette, Place, Sample, StoneTexture, WeatherParams, floor,
    palette,
};
use crate::order::{greater, lesser};
use crate::solid::StoneKind;
use glam::Vec3;

/// The mean height around a place, as a part of the joints' depth: for stones, and for skin.
const AROUND: [f32; 2] = [0.72, 0.55];
/// The factor from curvature (times size) to hollowness.
const HOLLOW: f32 = 0.5;
/// How much level places are trodden, from 0 to 1.
const TRODDEN: f32 = 0.75;
/// The offset of the broad noise against that of the ground, in picture units.
const BROAD_OFF: [f32; 2] = [211.0, 97.0];
/// Puddles lie only where the y of the normal is at least this.
const LEVEL_GROUND: f32 = 0.985;
/// A distance to the boundary, in sizes, so far beyond it that no water stays.
const RUNS_OFF: f32 = -9.0;
/// Below this height, as a part of the joints' depth, a stone counts as wall.
const WALLS: f32 = 0.75;
/// The distance over which slopes of the relief are measured, in picture units.
const STEP: f32 = 0.7;

/// The properties that all stones share.
pub(super) struct Look {
    pub texture: TextureParams,
    weather: WeatherParams,
    pub palette: &'static Palette,
    pub surfaces: Surfaces,
    bed: Bed,
    /// The mean colour of the bed.
    soil: [f32; 3],
    pub level: f32,
    pub depth: f32,
    deviation: f32,
    /// The mean height around a place.
    wide: f32,
}

/// The properties of one stone: its face, and the map back into its plane.
#[derive(Clone, Debug)]
pub(super) struct Own {
    pub face: StoneTexture,
    /// Its centre, in the model.
    pub at: Vec3,
    axes: [Vec3; 3],
    /// Picture units in a unit of the model.
    unit: f32,
    shape: [f32; 3],
    anchor: f32,
    rise: f32,
    /// How much hollower the surface is here than a plane.
    hollow: f32,
}

impl Own {
    pub fn new(flat: &UnfoldedCell, face: StoneTexture) -> Self {
        let bend = &flat.bend;
        let curved = (bend.shape[0] + bend.shape[2]) * 0.5 * flat.cell.size;
        Self {
            face,
            at: flat.at.as_vec3(),
            axes: flat.axes.map(|axis| axis.as_vec3()),
            unit: flat.unit as f32,
            shape: bend.shape.map(|v| v as f32),
            anchor: bend.anchor as f32,
            rise: bend.rise as f32,
            hollow: (-HOLLOW * curved as f32).clamp(-0.25, 0.4),
        }
    }

    /// Maps a place of the bent stone back into the flat stone. `from` is the place relative to the cell's centre, in
    /// the model's axes and units.
    fn laid_flat(&self, from: Vec3) -> Vec3 {
        let from = from * self.unit;
        let [x, y, z] = self.axes.map(|axis| axis.dot(from));
        let away = (x * x + y * y).sqrt();
        let [xx, xy, yy] = self.shape;
        let square = greater(away * away, 1e-12);
        let curved = (xx * x * x + 2.0 * xy * x * y + yy * y * y) / square;
        let (along, height) = match (curved * (away + z.abs())).abs() < 0.05 {
            // For small angles the circle is nearly a parabola.
            true => (away / (1.0 + curved * z), z + 0.5 * curved * away * away),
            false => {
                let (radius, side) = (1.0 / curved.abs(), curved.signum());
                let out = radius + side * z;
                let far = (away * away + out * out).sqrt();
                (libm::atan2f(away, out) * radius, side * (far - radius))
            }
        };
        let stretch = if away > 1e-6 { along / away } else { 1.0 };
        Vec3::new(x * stretch, y * stretch, height / self.rise + self.anchor)
    }
}

/// Colour, material and height at a place.
pub(super) struct Seen {
    pub colour: [f32; 3],
    pub material: u8,
    /// The height above the base level.
    pub height: f32,
}

impl Look {
    pub fn new(texture: TextureParams, weather: WeatherParams, surfaces: Surfaces) -> Self {
        let (level, depth) = (texture.level() as f32, texture.depth() as f32);
        let mut bed = texture.bed();
        bed.hold(0..BED);
        let around = match texture.stone.kind {
            StoneKind::Skin => AROUND[1],
            _ => AROUND[0],
        };
        Self {
            palette: palette(texture.palette),
            surfaces,
            bed,
            soil: [0.0; 3],
            level,
            depth,
            deviation: texture.relief(),
            wide: level + around * depth,
            texture,
            weather,
        }
    }

    /// Makes about `rows` rows of the bed; true when it is complete.
    pub fn advance(&mut self, rows: usize) -> bool {
        if !self.bed.advance(rows) {
            return false;
        }
        let places = (0..64 * 64).map(|k| [8 * (k % 64), 8 * (k / 64)]);
        let mut sum = [0.0; 3];
        for [x, y] in places {
            let colour = self.bed.colour(x, y);
            sum = std::array::from_fn(|k| sum[k] + colour[k]);
        }
        self.soil = sum.map(|v| v / (64.0 * 64.0));
        true
    }

    /// The face of the stone of a flat cell.
    pub fn face(&self, cell: &Cell, coat: Coat) -> StoneTexture {
        self.texture.face(cell, coat)
    }

    /// The colour of the ground from far away.
    pub fn ground_colour(&self) -> [u8; 3] {
        bytes(self.soil)
    }

    /// A place of the flat stone, not yet worn. `up` is the y of the normal there.
    pub fn bare(&self, own: &Own, p: Vec3, up: f32) -> Seen {
        self.stone(own, p, p.z, up)
    }

    /// A place of the flat stone, with the height that it had before wear.
    fn stone(&self, own: &Own, p: Vec3, height: f32, up: f32) -> Seen {
        let noise = self.surfaces.noise();
        let dust = self.bed.colour(floor(p.x) + 57, floor(p.y) + 31);
        let stand = (height - self.level) / self.depth;
        // Walls are unrolled outwards into the plane; else grain would run down them in streaks.
        let top = self.level + WALLS * self.depth;
        let away = greater((p.x * p.x + p.y * p.y).sqrt(), 1e-3);
        let out = 1.0 + greater(top - height, 0.0) / away;
        let at = [p.x * out - 0.5, p.y * out - 0.5];
        let rough = between(at[0], at[1], |at| own.face.relief(noise, at));
        let colour = own
            .face
            .colour(self.palette, noise, at, rough, (stand, dust));
        let sample = Sample {
            height,
            colour,
            material: own.face.material,
            soaks: false,
        };
        let from = Vec3::from(own.face.own_offset());
        self.weathered(sample, [p.x + from.x, p.y + from.y], [own.hollow, up], true)
    }

    /// Applies the weather to a place; `at` is where the weather's noise is read.
    fn weathered(
        &self,
        mut sample: Sample,
        at: [f32; 2],
        [hollow, up]: [f32; 2],
        is_stone: bool,
    ) -> Seen {
        if self.has_weather() {
            let settles = 0.3 + 0.7 * smoothstep_f32((up + 0.25) / 0.95);
            let strength = |v: f64| v * f64::from(settles);
            let here = WeatherParams {
                wear: self.weather.wear,
                moss: strength(self.weather.moss),
                dirt: strength(self.weather.dirt),
                wet: self.weather.wet,
            };
            let effects = Effects::new(here, [self.level, self.depth], self.bed.dirt());
            let noise = |k: usize, x: f32, y: f32| {
                between(x, y, |[x, y]| match k {
                    0 => self.bed.broad(x, y),
                    _ => self.bed.grains(x, y),
                })
            };
            let wide = LEVEL + (self.wide - sample.height) / self.depth;
            let place = Place {
                is_stone,
                hollow: (wide + hollow).clamp(0.0, 1.0),
                near: sample.height,
                trodden: self.trodden(up),
                inside: if up > LEVEL_GROUND { TRODDEN } else { RUNS_OFF },
                broad: noise(0, at[0] + BROAD_OFF[0], at[1] + BROAD_OFF[1]),
                grains: noise(1, at[0], at[1]),
                patches: noise(0, at[1], at[0]),
            };
            effects.apply(&place, &mut sample);
        }
        Seen {
            colour: sample.colour,
            material: sample.material,
            height: sample.height,
        }
    }

    fn has_weather(&self) -> bool {
        let WeatherParams {
            wear,
            moss,
            dirt,
            wet,
        } = self.weather;
        [wear, moss, dirt, wet] != [0.0; 4]
    }

    /// How much a place is trodden: more where it faces up.
    fn trodden(&self, up: f32) -> f32 {
        TRODDEN * smoothstep_f32((up - 0.2) / 0.6)
    }

    /// Colour and material of a stone at a place, and the slope of its relief there as a vector in the model. `from`
    /// is the place relative to the stone's centre, in the model's axes.
    pub fn of_stone(&self, own: &Own, from: Vec3, normal: Vec3) -> (Seen, Vec3) {
        let p = own.laid_flat(from);
        let up = 0.5 * (own.axes[2].y + normal.y);
        let worn = lesser(self.weather.wear as f32 * self.trodden(own.axes[2].y), 1.0);
        let stand = (p.z - self.level) / self.depth;
        let before = match worn > 0.0 {
            true => self.level + self.depth * stand / lesser(Effects::ceiling(worn), 1.0),
            false => p.z,
        };
        let seen = self.stone(own, p, before, up);
        let (noise, deviation) = (self.surfaces.noise(), self.deviation * (1.0 - worn));
        let mut rise = Vec3::ZERO;
        if deviation > 0.0 {
            let raised = |x: f32, y: f32| between(x, y, |at| own.face.relief(noise, at));
            let (x, y) = (p.x - 0.5, p.y - 0.5);
            let here = raised(x, y);
            let [across, down] = [raised(x + STEP, y), raised(x, y + STEP)];
            let slopes = [across - here, down - here].map(|v| v * deviation / STEP);
            rise = own.axes[0] * slopes[0] + own.axes[1] * slopes[1];
        }
        (seen, rise)
    }

    /// The weight of the relief: 0 on walls, 1 on tops.
    pub fn is_top(own: &Own, normal: Vec3) -> f32 {
        ((normal.dot(own.axes[2]) - 0.25) / 0.35).clamp(0.0, 1.0)
    }

    /// Colour and material of the ground at a place, in picture units, and the slope of its relief there.
    pub fn of_ground(&self, at: Vec3, normal: Vec3) -> (Seen, Vec3) {
        let weights = normal * normal * normal * normal;
        let weights = weights / greater(weights.x + weights.y + weights.z, 1e-6);
        let sides = [
            (weights.x, [at.z, at.y], [Vec3::Z, Vec3::Y]),
            (weights.y, [at.x, at.z], [Vec3::X, Vec3::Z]),
            (weights.z, [at.x, at.y], [Vec3::X, Vec3::Y]),
        ];
        let (mut colour, mut rise, mut height) = ([0.0; 3], Vec3::ZERO, 0.0);
        let mut place = [0.0; 2];
        let mut most = 0.0;
        for (weight, [x, y], [across, down]) in sides {
            if weight < 0.02 {
                continue;
            }
            let tone = |k: usize| between(x, y, |[x, y]| self.bed.colour(x, y)[k]);
            colour = std::array::from_fn(|k| colour[k] + weight * tone(k));
            let raised = |x: f32, y: f32| between(x, y, |[x, y]| self.bed.height(x, y));
            let here = raised(x, y);
            height += weight * here;
            let slopes = [raised(x + STEP, y) - here, raised(x, y + STEP) - here];
            rise += (across * slopes[0] + down * slopes[1]) * (weight / STEP);
            if weight > most {
                (most, place) = (weight, [x, y]);
            }
        }
        let sample = Sample {
            height,
            colour,
            material: GROUND_ROW,
            soaks: true,
        };
        (self.weathered(sample, place, [0.0, normal.y], false), rise)
    }
}

/// Rows and columns of the bed.
const BED: usize = 512;

pub(super) fn bytes(colour: [f32; 3]) -> [u8; 3] {
    colour.map(|v| (v.clamp(0.0, 255.0) + 0.5) as u8)
}
