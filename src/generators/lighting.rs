//! The light of a picture, whatever finisher makes it.

use crate::light::ShadeParams;
use crate::material::Material;

/// Lamp and shading, and the materials that they fall on.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LightParams {
    pub shade: ShadeParams,
    /// The table of the materials that bodies name.
    pub materials: Vec<Material>,
}
