//! Finishes: the colours and the materials of a component and its parts.

use super::{Mark, Part};
use crate::material::Material;
use crate::order::{greater, lesser};
use crate::random::{Purpose, Random};

/// Fine detail of a surface, at pixels. It lies in the space of the body, and moves with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Texture {
    /// No detail.
    None,
    /// Grains of stone or clay.
    Grains {
        /// The deviation of lightness, relative to the lightness.
        speckle: f32,
        /// The deviation of height, relative to the size of a grain.
        height: f32,
    },
    /// Lines of wood along the body.
    Wood,
    /// Pits of a peel.
    Pores,
    /// Fine scratches, as those of a lathe or of a brush.
    Brushed,
    /// Fine fibres along the body, as those of a leaf, a husk or a grain.
    Fibres,
}

/// The colour of one part; the body's colour has no entry.
pub(super) type PartColour = (Part, [u8; 3]);

/// The colours and the materials of a component and its parts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finish {
    /// Its word in links.
    pub word: &'static str,
    /// Its name in English.
    pub label: &'static str,
    /// The colours of bodies (sRGB); each body has one of them.
    pub bases: &'static [[u8; 3]],
    /// The greatest change of a body's lightness, relative to the lightness.
    pub tone: f64,
    /// The greatest change of each of a body's red, green and blue, relative to its value.
    pub tint: f64,
    /// The colours of parts; others have the colour of the body.
    pub(super) parts: &'static [PartColour],
    /// The factors of red, green and blue where [`Mark::shade`] is -1.
    pub dark: [f32; 3],
    /// The factors of red, green and blue where [`Mark::shade`] is 1.
    pub light: [f32; 3],
    /// The material of the body.
    pub body: Material,
    /// The material of all other parts.
    pub rest: Material,
    /// The fine detail.
    pub texture: Texture,
}

impl Finish {
    /// The colour of a part; `None` is the colour of the body.
    pub fn part(&self, part: Part) -> Option<[u8; 3]> {
        let found = self.parts.iter().find(|entry| entry.0 == part);
        found.map(|entry| entry.1)
    }

    /// The material of a part.
    pub fn material(&self, part: Part) -> Material {
        match part {
            Part::Body => self.body,
            _ => self.rest,
        }
    }

    /// The colour of the body with this id.
    pub fn base(&self, seed: u64, id: u64) -> [f32; 3] {
        let mut random = Random::new(seed, Purpose::Paint, id);
        let base = self.bases[random.below(self.bases.len())];
        let tone = 1.0 + self.tone * random.signed();
        base.map(|v| {
            let value = f64::from(v) * tone * (1.0 + self.tint * random.signed());
            lesser(value, 255.0) as f32
        })
    }

    /// The colour of a mark on a body with this colour.
    pub fn colour(&self, mark: &Mark, base: [f32; 3]) -> [u8; 3] {
        let part = self.part(mark.part).map(|part| part.map(f32::from));
        self.mixed(mark, base, part.unwrap_or(base))
    }

    /// The brightest red, green and blue of all bodies.
    pub fn brightest(&self) -> [f32; 3] {
        let most = (1.0 + self.tone) * (1.0 + self.tint);
        std::array::from_fn(|k| {
            let values = self.bases.iter().map(|base| f64::from(base[k]));
            lesser(most * values.fold(0.0, greater), 255.0) as f32
        })
    }

    /// The colour of a mark in a mesh that bodies of many colours share. Multiplied by [`Finish::tint`], it is the colour
    /// of the body, and nearly that of its parts.
    pub fn shared_colour(&self, mark: &Mark) -> [u8; 3] {
        let brightest = self.brightest();
        let part = self.part(mark.part).map(|part| {
            std::array::from_fn(|k| {
                let values = self.bases.iter().map(|base| f32::from(base[k]));
                let mean = values.sum::<f32>() / self.bases.len() as f32;
                lesser(
                    f32::from(part[k]) * brightest[k] / greater(mean, 1.0),
                    255.0,
                )
            })
        });
        self.mixed(mark, brightest, part.unwrap_or(brightest))
    }

    /// The tint of the body with this id, for a mesh with colours of [`Finish::shared_colour`]; 255 is one.
    pub fn tint(&self, seed: u64, id: u64) -> [u8; 3] {
        let (base, brightest) = (self.base(seed, id), self.brightest());
        std::array::from_fn(|k| byte(255.0 * base[k] / greater(brightest[k], 1.0)))
    }

    /// The mean tint of all bodies, 0..255.
    pub fn mean_tint(&self) -> [f32; 3] {
        let (count, brightest) = (self.bases.len() as f32, self.brightest());
        std::array::from_fn(|k| {
            let sum: f32 = self.bases.iter().map(|base| f32::from(base[k])).sum();
            255.0 * sum / (count * greater(brightest[k], 1.0))
        })
    }

    fn mixed(&self, mark: &Mark, base: [f32; 3], part: [f32; 3]) -> [u8; 3] {
        let (factors, much) = match mark.shade < 0.0 {
            true => (self.dark, -mark.shade),
            false => (self.light, mark.shade),
        };
        std::array::from_fn(|k| {
            let mixed = base[k] + (part[k] - base[k]) * mark.share;
            byte(mixed * (1.0 + (factors[k] - 1.0) * much))
        })
    }
}

/// The nearest byte.
fn byte(v: f32) -> u8 {
    (v + 0.5) as u8
}
