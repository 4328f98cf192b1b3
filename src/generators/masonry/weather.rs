//! Moss and damp on walls and roofs, by the shared effects of the weather (`crate::material`).

use super::colours::{MORTAR_ROW, MOSS_ROW};
use super::site::BuildingSite;
use super::trodden::{Trodden, trodden};
use crate::building::labels::SILL;
use crate::field::smoothstep_f32;
use crate::material::{Effects, LEVEL, MOSS, Place, Sample, WeatherParams};
use crate::order::{greater, lesser};
use crate::scene::Surfel;
use glam::Vec3;

/// How hollow a place counts for moss: everywhere, and more where it faces up, lies low, faces north (-z), or is a
/// joint.
const HOLLOW: [f32; 5] = [0.1, 0.46, 0.42, 0.14, 0.1];
/// At this height the share of low places is halved (metres).
const LOW: f32 = 0.22;
/// The strength of the noise of patches.
const PATCHY: f32 = 1.8;
/// The most by which a block's own number changes how hollow it counts.
const OWN: f32 = 0.07;
/// The strength of wet for the effects of damp, and the wetness that counts as level ground.
const SOAKED: [f32; 2] = [0.5, 0.55];
/// The height to which slight damp rises, and by how much higher full damp does (metres).
const RISES: [f32; 2] = [0.1, 0.75];
/// How far water runs down from sills, how far beside them (metres), and how dark it makes the wall.
const RUNS: [f32; 3] = [1.0, 0.1, 0.3];
/// How much paler treads are where they are worn most, and how much that changes with the noise of patches.
const WORN: [f32; 2] = [0.12, 0.06];
/// Treads are worn in full if moss and damp together have this strength.
const AGED: f64 = 0.2;

/// The weather of a building.
pub(super) struct Weather {
    params: WeatherParams,
    moss: Effects,
    damp: Effects,
    /// The height of the ground (metres in the scene's axes).
    ground: f32,
    /// The bounding boxes of sills.
    sills: Vec<[Vec3; 2]>,
    /// Faces on which people walk.
    trodden: Vec<Trodden>,
    /// How worn these are, 0..1.
    worn: f32,
}

/// Noise at a place, with a standard deviation of about 1.
pub(super) struct Noise {
    /// Noise over several blocks.
    pub patches: f32,
    /// Noise over some centimetres.
    pub fine: f32,
    /// Noise in upright stripes.
    pub stripes: f32,
    /// A random number of the block, from -1 to 1.
    pub own: f32,
}

impl Weather {
    /// The weather of a building in its scene.
    pub fn new(params: WeatherParams, site: &BuildingSite) -> Self {
        let effects = |moss: f64, wet: f64| {
            let params = WeatherParams {
                moss,
                wet,
                ..WeatherParams::default()
            };
            Effects::new(params, [0.0, 1.0], [0.0; 3])
        };
        let scale = site.fit.scale as f32;
        let building = &site.building;
        let place = |p| site.fit.place(p) / scale;
        let heights = building.vertices().iter().map(|v| place(v.position).y);
        let sills = building.faces().iter().filter(|face| face.has_label(SILL));
        let boxes = sills.map(|face| {
            let polygons = face.polygons.iter().map(|&id| building.polygon(id));
            let places = polygons.flat_map(|polygon| &polygon.vertices);
            let places = places.map(|&v| place(building.vertex(v).position));
            places.fold([Vec3::MAX, Vec3::MIN], |[low, high], p| {
                [low.min(p), high.max(p)]
            })
        });
        Self {
            moss: effects(params.moss, 0.0),
            damp: effects(
                0.0,
                if params.wet > 0.0 {
                    f64::from(SOAKED[0])
                } else {
                    0.0
                },
            ),
            ground: heights.fold(f32::MAX, lesser),
            sills: boxes.collect(),
            trodden: trodden(building, place),
            worn: lesser((params.moss + params.wet) / AGED, 1.0) as f32,
            params,
        }
    }

    /// A number that changes with the weather.
    pub fn mark(&self) -> u64 {
        self.params.moss.to_bits() ^ self.params.wet.to_bits().rotate_left(32)
    }

    /// Adds damp, wear and moss to a surface at a place (metres in the scene's axes). Returns how smooth feet have worn
    /// it, 0..1.
    pub fn apply(&self, surfel: &mut Surfel, at: Vec3, noise: &Noise) -> f32 {
        let height = greater(at.y - self.ground, 0.0);
        if self.params.wet > 0.0 {
            let rises = RISES[0] + RISES[1] * self.params.wet as f32;
            let soaked = 1.1 * (1.0 - height / rises);
            let level = LEVEL + 2.0 * (soaked - SOAKED[1]);
            self.affect(&self.damp, surfel, level + 0.2 * noise.own, noise);
            let dark = RUNS[2] * self.runs(at, noise);
            surfel.colour = surfel.colour.map(|v| v * (1.0 - dark));
        }
        let mut trodden = self.trodden.iter();
        if let Some(share) = trodden.find_map(|face| face.share(at, surfel.normal)) {
            // No moss grows under feet.
            let worn = self.worn * share;
            let paler = worn * (WORN[0] + WORN[1] * noise.patches);
            surfel.colour = surfel.colour.map(|v| lesser(v * (1.0 + paler), 255.0));
            return worn;
        }
        if self.params.moss > 0.0 {
            let [all, up, low, north, joint] = HOLLOW;
            let near = height / LOW;
            let is_joint = f32::from(u8::from(surfel.material == MORTAR_ROW));
            let hollow = all
                + up * greater(surfel.normal.y, 0.0)
                + low / (1.0 + near * near)
                + north * greater(-surfel.normal.z, 0.0)
                + joint * is_joint
                + OWN * noise.own;
            self.affect(&self.moss, surfel, hollow, noise);
        }
        0.0
    }

    fn affect(&self, effects: &Effects, surfel: &mut Surfel, hollow: f32, noise: &Noise) {
        let place = Place {
            is_stone: true,
            hollow,
            near: 0.0,
            trodden: 0.0,
            inside: -1.0,
            broad: PATCHY * noise.patches,
            grains: noise.fine,
            patches: noise.patches,
        };
        let mut sample = Sample {
            height: 0.0,
            colour: surfel.colour,
            material: 0,
            soaks: false,
        };
        effects.apply(&place, &mut sample);
        surfel.colour = sample.colour;
        if sample.material == MOSS {
            surfel.material = MOSS_ROW;
        }
    }

    /// How much water has run over a place below a sill, 0..1.
    fn runs(&self, at: Vec3, noise: &Noise) -> f32 {
        let [down, beside, _] = RUNS;
        let below = self.sills.iter().map(|[low, high]| {
            let (off, end) = (low.y - at.y, Vec3::splat(beside));
            let (from, to) = (*low - end, *high + end);
            let is_there = (from.x..to.x).contains(&at.x) && (from.z..to.z).contains(&at.z);
            if is_there && (0.0..down).contains(&off) {
                1.0 - off / down
            } else {
                0.0
            }
        });
        let most = below.fold(0.0, greater);
        let wet = lesser(1.5 * self.params.wet as f32, 1.0);
        wet * most * smoothstep_f32(0.35 + 0.45 * noise.stripes)
    }
}
