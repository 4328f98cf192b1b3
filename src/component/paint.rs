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
        let drawn = Drawn::new(self, seed, id);
        drawn.applied_to(self.bases[drawn.base])
    }

    /// The colour of a mark on a body with this colour.
    pub fn colour(&self, mark: &Mark, base: [f32; 3]) -> [u8; 3] {
        let part = self.part(mark.part).map(|part| part.map(f32::from));
        self.mixed(mark, base, part.unwrap_or(base))
    }

    /// The colour of a mark in a mesh that bodies of all colours share. Multiplied by [`Finish::tint`], it is the colour
    /// of the body. The colours of parts are right on the mean; they lean towards the body's colour.
    pub fn shared_colour(&self, mark: &Mark) -> [u8; 3] {
        let brightest = self.brightest();
        let part = self.part(mark.part).map(|part| {
            std::array::from_fn(|k| {
                let values = self.bases.iter().map(|base| f32::from(base[k]));
                let mean = values.sum::<f32>() / self.bases.len() as f32;
                let value = f32::from(part[k]) * brightest[k] / greater(mean, 1.0);
                lesser(value, 255.0)
            })
        });
        self.mixed(mark, brightest, part.unwrap_or(brightest))
    }

    /// The tint of the body with this id, for a mesh with colours of [`Finish::shared_colour`]; 255 is one.
    pub fn tint(&self, seed: u64, id: u64) -> [u8; 3] {
        let (base, brightest) = (self.base(seed, id), self.brightest());
        std::array::from_fn(|k| byte(255.0 * base[k] / greater(brightest[k], 1.0)))
    }

    /// The colour of a mark in the mesh of the variant with this number, which has a colour of its own: so parts keep
    /// theirs, however much those of bodies differ. It goes with [`Finish::mild_tint`].
    pub fn variant_colour(&self, mark: &Mark, number: u64) -> [u8; 3] {
        let base = self.bases[(number % self.bases.len() as u64) as usize];
        let most = self.most() as f32;
        let [base, part] = [base, self.part(mark.part).unwrap_or(base)]
            .map(|colour| colour.map(|v| lesser(f32::from(v) * most, 255.0)));
        self.mixed(mark, base, part)
    }

    /// The tint of the body with this id, for a mesh with colours of [`Finish::variant_colour`]; 255 is one.
    pub fn mild_tint(&self, seed: u64, id: u64) -> [u8; 3] {
        let factors = Drawn::new(self, seed, id).factors;
        factors.map(|v| byte((255.0 * v / self.most()) as f32))
    }

    /// The brightest red, green and blue of all bodies.
    fn brightest(&self) -> [f32; 3] {
        std::array::from_fn(|k| {
            let values = self.bases.iter().map(|base| f64::from(base[k]));
            lesser(self.most() * values.fold(0.0, greater), 255.0) as f32
        })
    }

    /// The greatest factor of a base.
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

/// The random numbers of a body.
struct Drawn {
    /// The index of its base.
    base: usize,
    /// The factors of red, green and blue.
    factors: [f64; 3],
}

impl Drawn {
    fn new(finish: &Finish, seed: u64, id: u64) -> Self {
        let mut random = Random::new(seed, Purpose::Paint, id);
        let base = random.below(finish.bases.len());
        let tone = 1.0 + finish.tone * random.signed();
        let factors = [0; 3].map(|_| tone * (1.0 + finish.tint * random.signed()));
        Self { base, factors }
    }

    fn applied_to(&self, base: [u8; 3]) -> [f32; 3] {
        let value = |k: usize| lesser(f64::from(base[k]) * self.factors[k], 255.0) as f32;
        std::array::from_fn(value)
    }
}

/// The nearest byte.
fn byte(v: f32) -> u8 {
    (v + 0.5) as u8
}
