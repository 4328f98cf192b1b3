//! The light of a picture, for both finishers.

use crate::light::ShadeParams;
use crate::material::Material;

/// The lamp, the shading, and the materials.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LightParams {
    pub shade: ShadeParams,
    /// The table of materials; bodies refer to its entries.
    pub materials: Vec<Material>,
}
