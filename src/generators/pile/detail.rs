//! Colour and relief of bodies at pixels. They lie in the space of each body, so they move with it.

use super::materials::row;
use crate::component::{Finish, Texture};
use crate::material::{GrainStrength, NearGrain, NoiseTile, from_three_sides};
use crate::order::{greater, lesser};
use crate::scene::{Detail, Place, Surfel};
use glam::{Vec2, Vec3};
use std::rc::Rc;

/// Picture units in a unit of a component. A component is 2 units long, so it measures about 48 picture units, as a
/// large stone does.
const UNIT: f32 = 24.0;
/// The noise tile: its random stream, the binary logarithm of its side, its levels, and its fractal dimension.
const NOISE: (u64, u32, u32, f64) = (23, 7, 4, 1.5);
/// The colour factors of dry and of wet bodies, by how much the colours of wet ones are stronger, and the width of the
/// water's edge in the scene.
const DRIED: f32 = 1.14;
const SOAKED: f32 = 0.5;
const STRONGER: f32 = 0.35;
const EDGE: f32 = 0.02;
/// The strength of grain on brushed metal, and on wood and peel.
const METAL_GRAIN: GrainStrength = GrainStrength {
    speckle: 0.03,
    height: 0.05,
};
const SKIN_GRAIN: GrainStrength = GrainStrength {
    speckle: 0.03,
    height: 0.12,
};

/// How far the faces of metal parts are domed, as those of forged and polished ones are: the tilt of the normal at the
/// distance of half a component. A flat face would mirror one tone.
const DOMED: f32 = 0.12;

/// The id of a wooden box in the scene.
pub(super) const BOX_ID: u32 = u32::MAX;
/// Units of the wood's texture in a unit of the scene.
const BOX_UNITS: f32 = 4.0;

/// The data of a settled body that its detail needs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Own {
    pub place: Place,
    /// The number of its type.
    pub kind: u32,
    /// The offset at which its noise is read.
    pub offset: [f32; 2],
}

/// The noise that all bodies share.
pub(super) struct PileNoise {
    tile: NoiseTile,
    grain: NearGrain,
}

impl PileNoise {
    /// The noise of a seed.
    pub fn new(seed: u64) -> Self {
        let (item, side, levels, dimension) = NOISE;
        Self {
            tile: NoiseTile::new(seed, item, side, levels, dimension),
            grain: NearGrain::new(seed),
        }
    }
}

/// The detail of a pile.
pub(super) struct PileDetail {
    pub noise: Rc<PileNoise>,
    /// The bodies by their ids, which begin at 1; `None` where no body is kept.
    pub owns: Rc<Vec<Option<Own>>>,
    /// The finish of each type.
    pub finishes: Vec<&'static Finish>,
    /// The height up to which bodies are wet, if any are.
    pub water: Option<f32>,
}

/// A place of a body in its own space.
struct Local {
    /// In the component's units.
    at: Vec3,
    normal: Vec3,
    /// The width of a pixel there, in the component's units.
    spread: f32,
    offset: Vec2,
}

impl Detail for PileDetail {
    fn refine(&self, surfel: &mut Surfel, id: u32, spread: f32) {
        if id == BOX_ID {
            self.noise.board(surfel, spread);
            return;
        }
        let own = self.owns.get((id as usize).wrapping_sub(1));
        let Some(own) = own.and_then(Option::as_ref) else {
            return;
        };
        let scale = own.place.scale();
        let unit = own.place.axes.map(|axis| axis / scale);
        let back = |v: Vec3| Vec3::from(unit.map(|axis| axis.dot(v)));
        let local = Local {
            at: back(surfel.position - own.place.origin) / scale,
            normal: back(surfel.normal),
            spread: spread / scale,
            offset: Vec2::from(own.offset),
        };
        let finish = self.finishes[own.kind as usize];
        let texture = finish.texture;
        let is_part = finish.rest != finish.body && finish.is_of_part(surfel.colour);
        if is_part {
            surfel.material = row(own.kind as usize, true, false);
        }
        let light = self.noise.light(texture, &local);
        surfel.colour = surfel.colour.map(|v| lesser(v * light, 255.0));
        let mut normal = local.normal;
        if texture == Texture::Brushed {
            normal += (local.at - normal * normal.dot(local.at)) * DOMED;
            normal = normal.normalize_or_zero();
        }
        self.noise
            .grain(texture, &local, &mut surfel.colour, &mut normal);
        surfel.normal = unit[0] * normal.x + unit[1] * normal.y + unit[2] * normal.z;
        if let Some(water) = self.water {
            self.soak(surfel, (own.kind, is_part), water);
        }
    }

    fn mark(&self) -> Option<u64> {
        self.water.map(|water| u64::from(water.to_bits()))
    }
}

impl PileDetail {
    /// Wets what lies below the water's edge, which is uneven.
    fn soak(&self, surfel: &mut Surfel, (kind, is_part): (u32, bool), water: f32) {
        let at = surfel.position * 40.0;
        let uneven = self
            .noise
            .tile
            .between(at.x + 0.6 * at.y, at.z - 0.6 * at.y);
        let below = (water + EDGE * uneven - surfel.position.y) / EDGE + 0.5;
        let soaked = below.clamp(0.0, 1.0);
        let factor = DRIED + (SOAKED - DRIED) * soaked;
        let grey = surfel.colour.iter().sum::<f32>() / 3.0;
        let stronger = 1.0 + STRONGER * soaked;
        let wet = |v: f32| (grey + (v - grey) * stronger) * factor;
        surfel.colour = surfel.colour.map(|v| wet(v).clamp(0.0, 255.0));
        if soaked > 0.5 {
            surfel.material = row(kind as usize, is_part, true);
        }
    }
}

impl PileNoise {
    /// The wood of a box, whose boards lie along its sides.
    fn board(&self, surfel: &mut Surfel, spread: f32) {
        let turned = |v: Vec3| match surfel.normal.x.abs() > surfel.normal.z.abs() {
            true => Vec3::new(v.z, v.y, v.x),
            false => v,
        };
        let local = Local {
            at: turned(surfel.position) * BOX_UNITS,
            normal: turned(surfel.normal),
            spread: spread * BOX_UNITS,
            offset: Vec2::ZERO,
        };
        let light = self.light(Texture::Wood, &local);
        surfel.colour = surfel.colour.map(|v| lesser(v * light, 255.0));
    }

    /// The factor of a texture on the colour.
    fn light(&self, texture: Texture, local: &Local) -> f32 {
        let p = local.at;
        // Detail with this many waves in a unit fades where pixels are too wide for it.
        let shown = |waves: f32| (2.0 - 4.0 * waves * local.spread).clamp(0.0, 1.0);
        let read = |x: f32, y: f32| {
            let [dx, dy] = local.offset.to_array();
            self.tile.between(x + dx, y + dy).clamp(-2.5, 2.5)
        };
        let noise = |waves: f32| from_three_sides(p * waves, local.normal, read);
        match texture {
            Texture::None => 1.0,
            Texture::Grains { speckle, .. } => {
                let broad = noise(3.0);
                let fine = noise(11.0);
                let fine = 0.6 * fine + 0.4 * fine * fine.abs();
                greater(
                    1.0 + speckle * (0.7 * broad * shown(3.0) + fine * shown(11.0)),
                    0.2,
                )
            }
            Texture::Wood => {
                // Year rings about an axis beside the body, parallel to its length (x).
                let off = Vec2::new(p.y + 0.9, p.z - 0.35);
                let waver = 0.10 * read(2.0 * p.x, 9.0 * off.length());
                let ring = 9.0 * (off.length() + waver);
                let part = ring - ring.floor();
                let late = part * part * shown(9.0);
                let fibre = read(3.0 * p.x, 60.0 * off.y) * shown(30.0);
                1.06 - 0.26 * late + 0.04 * fibre
            }
            Texture::Pores => 1.0 + 0.03 * noise(9.0) * shown(9.0),
            Texture::Brushed => {
                let line = read(2.5 * p.x, 40.0 * p.y + 23.0 * p.z) * shown(30.0);
                1.0 + 0.035 * line
            }
            Texture::Fibres => {
                let around = libm::atan2f(p.z, p.y);
                let line = read(2.0 * p.x, 7.0 * around) * shown(8.0);
                1.0 + 0.03 * line
            }
        }
    }

    /// Adds the finest grain to colour and normal.
    fn grain(&self, texture: Texture, local: &Local, colour: &mut [f32; 3], normal: &mut Vec3) {
        let strength = match texture {
            Texture::None | Texture::Fibres => return,
            Texture::Grains { speckle, height } => GrainStrength { speckle, height },
            Texture::Wood | Texture::Pores => SKIN_GRAIN,
            Texture::Brushed => METAL_GRAIN,
        };
        let away = Vec3::new(local.offset.x, local.offset.y, 0.0);
        let place = (local.at * UNIT + away, *normal);
        if let Some(grain) = self.grain.at(place, local.spread * UNIT, strength) {
            grain.add_to(colour, normal);
        }
    }
}
