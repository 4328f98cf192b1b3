//! A material under the light of a recipe.

use super::ShadeParams;
use crate::material::Material;

/// Entries of the table of highlights.
pub(crate) const SHINE: usize = 256;

/// The exponent of a highlight at which half of the relief counts.
pub(crate) const SMOOTH: f32 = 12.0;

/// How much of the relief counts for a highlight with this exponent. Where a surface is smooth enough for a narrow
/// highlight, a film fills its relief. Else noise would tear highlights to worms and dots.
fn fine_part(exponent: f32) -> f32 {
    SMOOTH / (SMOOTH + exponent)
}

/// A material with the factors of the recipe.
pub(crate) struct Finish {
    pub ambient: f32,
    pub diffuse: f32,
    /// The highlight by the cosine between mirrored light and view, 0..1 in [`SHINE`] steps.
    pub shine: Vec<f32>,
    /// How much of the relief's slope counts for highlights, 0..1 (see [`fine_part`]): 1 without a film.
    pub fine: f32,
}

impl Finish {
    /// Works out the table of its highlights.
    pub fn new(material: &Material, params: &ShadeParams) -> Self {
        let exponent = f64::from(material.shininess) * params.shininess;
        let strength = material.specular * params.specular as f32;
        let shine = (0..=SHINE)
            .map(|i| strength * libm::pow(i as f64 / SHINE as f64, exponent.max(0.1)) as f32);
        Self {
            ambient: material.ambient * params.ambient as f32,
            diffuse: material.diffuse * params.diffuse as f32,
            shine: shine.collect(),
            fine: match material.mirror > 0.0 {
                true => fine_part(exponent as f32),
                false => 1.0,
            },
        }
    }
}
