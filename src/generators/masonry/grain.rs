//! The grain of blocks and mortar at pixels. Each block reads the noise at another place, so that no two blocks look
//! alike.

use super::colours::{BRICK_ROW, MORTAR_ROW, SOIL_ROW, STONE_ROW, WOOD_ROW};
use super::ground::relief;
use super::weather::{Noise, Weather};
use crate::material::{GrainStrength, NearGrain, NoiseTile, from_three_sides};
use crate::order::{greater, lesser};
use crate::scene::{Detail, Surfel};
use glam::Vec3;

/// The noise tile: its random stream, the binary logarithm of its side, its levels, and its fractal dimension.
const NOISE: (u64, u32, u32, f64) = (29, 7, 4, 1.5);
/// Picture units in a metre, for the finest grain.
const UNITS: f32 = 420.0;
/// The strength of grain: of mortar, of bricks, and of stones.
const STRENGTHS: [GrainStrength; 3] = [
    GrainStrength {
        speckle: 0.05,
        height: 0.10,
    },
    GrainStrength {
        speckle: 0.06,
        height: 0.12,
    },
    GrainStrength {
        speckle: 0.05,
        height: 0.16,
    },
];
/// The share of the grain that feet wear away.
const SMOOTH: f32 = 0.6;
/// The deviation of lightness by noise, for mortar, bricks and stones; and the waves in a metre of broad and of fine
/// noise.
const CLOUDS: [f32; 3] = [0.05, 0.10, 0.09];
const BROAD: f32 = 9.0;
const FINE: f32 = 38.0;
/// Waves in a metre of the ground's pebbles.
const PEBBLES: f32 = 14.0;
/// Waves in a metre of patches of moss, and of stripes of water, which are upright.
const PATCHES: Vec3 = Vec3::splat(1.7);
const STRIPES: Vec3 = Vec3::new(15.0, 0.7, 15.0);

/// The grain of a wall.
pub(super) struct WallGrain {
    tile: NoiseTile,
    grain: NearGrain,
    weather: Weather,
    /// The word of the ground.
    ground: &'static str,
    /// Scene units in a metre.
    scale: f32,
    /// The marks of the blocks, in the order of their ids.
    marks: Vec<u32>,
}

impl WallGrain {
    /// The grain of a wall that is drawn at `scale` units in a metre.
    pub fn new(
        (seed, scale): (u64, f64),
        weather: Weather,
        ground: &'static str,
        marks: Vec<u32>,
    ) -> Self {
        let (item, side, levels, dimension) = NOISE;
        Self {
            tile: NoiseTile::new(seed, item, side, levels, dimension),
            grain: NearGrain::new(seed),
            weather,
            ground,
            scale: scale as f32,
            marks,
        }
    }

    /// The noise at a place (metres) of a surface with this normal, with `waves` waves in a metre.
    fn read(&self, p: Vec3, normal: Vec3, waves: f32) -> f32 {
        self.tile_at(p * waves, normal)
    }

    /// The noise at a place whose coordinates count waves.
    fn tile_at(&self, p: Vec3, normal: Vec3) -> f32 {
        let read = |x: f32, y: f32| self.tile.between(x, y).clamp(-2.5, 2.5);
        from_three_sides(p, normal, read)
    }
}

impl Detail for WallGrain {
    fn refine(&self, surfel: &mut Surfel, id: u32, spread: f32) {
        let kind = match surfel.material {
            MORTAR_ROW => 0,
            BRICK_ROW => 1,
            STONE_ROW => 2,
            SOIL_ROW | WOOD_ROW => return self.plain(surfel, spread),
            _ => return,
        };
        // Each block reads the noise elsewhere.
        let own = (id as usize).checked_sub(1);
        let own = own.and_then(|k| self.marks.get(k)).map_or(0, |&mark| mark);
        let away = Vec3::new(
            (own >> 22) as f32,
            ((own >> 11) & 1023) as f32,
            (own & 1023) as f32,
        );
        let at = surfel.position / self.scale;
        let spread = spread / self.scale;
        let shown = |waves: f32| (2.0 - 4.0 * waves * spread).clamp(0.0, 1.0);
        let broad = self.read(at + away * 0.37, surfel.normal, BROAD) * shown(BROAD);
        let fine = self.read(at + away * 0.53, surfel.normal, FINE) * shown(FINE);
        let light = greater(1.0 + CLOUDS[kind] * (0.7 * broad + 0.5 * fine), 0.3);
        surfel.colour = surfel.colour.map(|v| lesser(v * light, 255.0));
        let [patches, stripes] =
            [PATCHES, STRIPES].map(|waves| self.tile_at(at * waves, surfel.normal));
        let noise = Noise {
            patches,
            fine,
            stripes,
            own: (own >> 16 & 255) as f32 / 127.5 - 1.0,
        };
        let rough = 1.0 - SMOOTH * self.weather.apply(surfel, at, &noise);
        let strength = GrainStrength {
            speckle: rough * STRENGTHS[kind].speckle,
            height: rough * STRENGTHS[kind].height,
        };
        let place = (at * UNITS + away, surfel.normal);
        if let Some(grain) = self.grain.at(place, spread * UNITS, strength) {
            grain.add_to(&mut surfel.colour, &mut surfel.normal);
        }
    }

    fn mark(&self) -> Option<u64> {
        Some(self.weather.mark())
    }
}

/// A place with its coordinates exchanged so that y points across the surface, and x and z run along it.
fn upright(at: Vec3, normal: Vec3) -> Vec3 {
    let n = normal.abs();
    if n.y > 0.6 {
        at
    } else if n.x > n.z {
        Vec3::new(at.z, at.x, at.y)
    } else {
        Vec3::new(at.x, at.z, at.y)
    }
}

impl WallGrain {
    /// Adds the grain of the ground and of wood, which have no weather.
    fn plain(&self, surfel: &mut Surfel, spread: f32) {
        let at = surfel.position / self.scale;
        let spread = spread / self.scale;
        let shown = |waves: f32| (2.0 - 4.0 * waves * spread).clamp(0.0, 1.0);
        let read = |waves: f32| self.read(at, surfel.normal, waves) * shown(waves);
        let light = match surfel.material {
            WOOD_ROW => {
                let fibres = self.tile_at(at * Vec3::new(40.0, 2.5, 40.0), surfel.normal);
                1.0 + 0.10 * fibres * shown(20.0) + 0.05 * read(BROAD)
            }
            _ => relief(
                self.ground,
                upright(at, surfel.normal),
                [read(1.3), read(BROAD)],
                shown(PEBBLES),
            ),
        };
        surfel.colour = surfel
            .colour
            .map(|v| lesser(v * greater(light, 0.3), 255.0));
    }
}
