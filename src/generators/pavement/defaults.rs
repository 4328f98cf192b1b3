//! Defaults of the stages' parameters, from the defaults in the pavement's table, so that they stand in one place.

use super::{params, recipe};
use crate::field::FieldParams;
use crate::generators::common;
use crate::heightfield::TextureParams;
use crate::light::ShadeParams;
use crate::material::{ColourParams, WeatherParams};
use crate::packing::PackingParams;
use crate::recipe::Recipe;
use crate::solid::{SkinParams, StoneParams};

macro_rules! defaults {
    ($($params:ty: $of:expr, $link:expr;)*) => {
        $(impl Default for $params {
            fn default() -> Self {
                $of(&recipe($link).0)
            }
        })*
    };
}

defaults! {
    FieldParams: params::fields, PLAIN;
    PackingParams: params::packing, PLAIN;
    StoneParams: stone, PLAIN;
    SkinParams: |recipe| common::stone(recipe, 1.0).skin, "stone=skin";
    ColourParams: |recipe| common::colour(recipe, recipe.side()), PLAIN;
    TextureParams: texture, PLAIN;
    WeatherParams: common::weather, PLAIN;
    ShadeParams: common::shading, PLAIN;
}

/// The link of a pavement with all defaults.
const PLAIN: &str = "";

/// With the defaults of skin, if it becomes skin.
fn stone(recipe: &Recipe) -> StoneParams {
    StoneParams {
        skin: SkinParams::default(),
        ..common::stone(recipe, 1.0)
    }
}

fn texture(recipe: &Recipe) -> TextureParams {
    TextureParams {
        stone: stone(recipe),
        ..params::texture(recipe)
    }
}
