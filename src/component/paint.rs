//! Finishes: the colours and the materials of a component and its parts.

use super::{Mark, Part};
use crate::material::Material;
use crate::order::lesser;
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

    /// Whether a colour (sRGB, 0 to 255) is nearer to that of a part than to those of bodies.
    pub fn is_of_part(&self, colour: [f32; 3]) -> bool {
        let least = |colours: &mut dyn Iterator<Item = [u8; 3]>| {
            let far = colours.map(|other| {
                let away = |k: usize| f32::from(other[k]) - colour[k];
                (0..3).map(|k| away(k) * away(k)).sum::<f32>()
            });
            far.fold(f32::INFINITY, lesser)
        };
        let parts = &mut self.parts.iter().map(|entry| entry.1);
        least(parts) < least(&mut self.bases.iter().copied())
    }

    /// The vertex colour of a mark in the mesh of variant `number`. Each variant has its own base colour, which does
    /// not change the colours of parts. A body multiplies these colours by its [`Finish::tint`].
    pub fn variant_colour(&self, mark: &Mark, number: u64) -> [u8; 3] {
        let base = self.bases[(number % self.bases.len() as u64) as usize];
        let most = self.most() as f32;
        let [base, part] = [base, self.part(mark.part).unwrap_or(base)]
            .map(|colour| colour.map(|v| lesser(f32::from(v) * most, 255.0)));
        self.mixed(mark, base, part)
    }

    /// The tint of the body with this id, for a mesh with colours of [`Finish::variant_colour`]; 255 is one. `vary`
    /// scales its difference from the mean.
    pub fn tint(&self, seed: u64, id: u64, vary: f64) -> [u8; 3] {
        let mut random = Random::new(seed, Purpose::Paint, id);
        let tone = 1.0 + self.tone * random.signed();
        [0; 3].map(|_| {
            let factor = tone * (1.0 + self.tint * random.signed());
            let varied = (1.0 + (factor - 1.0) * vary).clamp(0.0, self.most());
            byte((255.0 * varied / self.most()) as f32)
        })
    }

    /// The greatest factor by which tone and tint can change a base colour.
    fn most(&self) -> f64 {
        (1.0 + self.tone) * (1.0 + self.tint)
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
