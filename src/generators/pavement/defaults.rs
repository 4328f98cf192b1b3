//! What the stages make where nothing else is said: a pavement by the defaults of its table of
//! parameters, where they stand once.

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

/// The link of a pavement by defaults.
const PLAIN: &str = "";

/// Made into skin, it is skin by defaults.
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
