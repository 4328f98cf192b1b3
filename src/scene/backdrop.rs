//! The background of a scene: a floor that fades into the air above it, a sky, or nothing.

use super::View;
use crate::order::{greater, lesser};
use glam::Vec3;

/// The background behind the bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Backdrop {
    /// An infinite floor under the lowest body, as in a photographer's studio.
    #[default]
    Floor,
    /// The sky, and land far below it.
    Sky,
    /// No background: pixels without a body are transparent.
    Nothing,
}

impl Backdrop {
    /// All backdrops with their words.
    pub const ALL: [(Backdrop, &'static str); 3] = [
        (Backdrop::Floor, "floor"),
        (Backdrop::Sky, "sky"),
        (Backdrop::Nothing, "nothing"),
    ];
}

/// Colours of the floor on the screen (sRGB, 0..255), the same for all recipes: in full light, and in the lamp's
/// shadow, where the sky's cooler light is left.
const FLOOR: [[f32; 3]; 2] = [[203.0, 198.0, 190.0], [112.0, 114.0, 120.0]];
/// The share of the light that is lost in the corners of a picture with a floor (vignetting).
const CORNERS: f32 = 0.2;
/// The floor fades between these distances, in radii of the ball around all bodies.
const FADES: [f32; 2] = [1.1, 3.2];
/// Above the floor the background gets lighter upwards: the share of white straight up, and the sine of the elevation
/// where it begins.
const LIGHTER: f32 = 0.5;
const BEGINS: f32 = -0.7;
/// Colours on the screen (sRGB, 0..255): at the horizon, and far above or below it.
type Gradient = [[f32; 3]; 2];
const AIR: Gradient = [[214.0, 224.0, 233.0], [104.0, 146.0, 198.0]];
/// At the horizon the land has the colour of the air, like haze.
const LAND: Gradient = [AIR[0], [126.0, 123.0, 114.0]];

/// The colour on the screen in a direction (a unit vector); black for [`Backdrop::Nothing`]. `far` is the colour of
/// the floor where it fades.
pub(super) fn behind(backdrop: Backdrop, way: Vec3, far: [f32; 3]) -> [f32; 3] {
    let high = greater(way.y, 0.0);
    match backdrop {
        Backdrop::Floor => {
            let part = LIGHTER * greater(way.y - BEGINS, 0.0) / (1.0 - BEGINS);
            far.map(|v| v + (255.0 - v) * part)
        }
        Backdrop::Sky if way.y >= 0.0 => between(AIR, lesser(1.6 * high, 1.0).sqrt()),
        Backdrop::Sky => between(LAND, lesser(-2.0 * way.y, 1.0).sqrt()),
        Backdrop::Nothing => [0.0; 3],
    }
}

fn between([low, high]: Gradient, part: f32) -> [f32; 3] {
    std::array::from_fn(|k| low[k] + (high[k] - low[k]) * part)
}

/// The colour on the screen of the floor, with this share of the lamp and of the sky.
#[inline(always)]
pub(super) fn floor_colour(lamp: f32, sky: f32) -> [f32; 3] {
    let [lit, shaded] = FLOOR;
    std::array::from_fn(|k| shaded[k] * sky + (lit[k] - shaded[k]) * lamp)
}

/// The share of the light that vignetting leaves in the direction `way`: 1 straight ahead, less towards the corners.
#[inline(always)]
pub(super) fn left_of_corner(view: &View, way: Vec3) -> f32 {
    let ahead = way.dot(view.ahead);
    let [x, y] = view.middle.map(|half| half * view.slope);
    1.0 - CORNERS * (1.0 / (ahead * ahead) - 1.0) / (x * x + y * y)
}

/// Rounds a colour up or down by a pattern over pixels, so that slow changes have no steps (Jimenez 2014, Next
/// Generation Post Processing in Call of Duty: Advanced Warfare: interleaved gradient noise).
#[inline(always)]
pub(super) fn dithered(colour: [f32; 3], [x, y]: [usize; 2]) -> [u8; 3] {
    let part = |v: f32| v - v.floor();
    let noise = part(52.982_918 * part(0.067_110_56 * x as f32 + 0.005_837_15 * y as f32));
    colour.map(|v| (v + noise) as u8)
}

/// The distance from the centre of the bounding ball at which the floor has faded out; `radius` is the ball's.
pub(super) fn end_of_floor(radius: f32) -> f32 {
    FADES[1] * radius
}

/// Opacity of the floor at a distance from the centre of a ball with this radius, 0..1.
pub(super) fn floor_part(away: f32, radius: f32) -> f32 {
    let [from, to] = FADES.map(|part| part * radius);
    let part = ((to - away) / greater(to - from, f32::MIN_POSITIVE)).clamp(0.0, 1.0);
    part * part * (3.0 - 2.0 * part)
}
