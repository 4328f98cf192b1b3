//! The light of a scene: a recipe's lamp in space, its shadows, and Phong's shading of a point.

use super::backdrop::floor_colour;
use super::contact::FloorContact;
use super::floor::{FloorPlane, FloorSearch};
use super::four_lanes::FourVectors;
use super::reflection::{LitPoints, Reaching, SurfaceFinish, finish_of, open_to, seen_of};
use super::shadow::{ShadowMaps, ShadowSample};
use super::{Cut, Lamp, Order, Scene};
use crate::light::{ShadeParams, Tone};
use crate::material::Material;
use crate::order::lesser;
use glam::Vec3;

/// The ratio of the shadow map's side to the side of one of the six maps around a lamp.
const LAMP_SIDE: usize = 2;
/// If bodies fill the texels of the shadow maps more often than this, the maps of later samples have fewer texels: the
/// side is halved, at most [`HALVINGS`] times.
const MOST_LAYERS: usize = 16;
const HALVINGS: usize = 2;
/// A bulb shines at night: the floor gets this share of the sky's light.
const NIGHT: f32 = 0.4;
/// The finish of a scene without materials.
const BLACK: SurfaceFinish = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];

/// Cosine below which a triangle's own normal is ignored in favour of its corners' normals.
const TURNED: f32 = 0.05;

/// Resolution of shadows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sharpness {
    /// For moving views: softer, and with coarser bodies.
    Coarse,
    /// For frames whose larger side has at most [`Sharpness::SMALL`] pixels.
    Small,
    /// For frames whose larger side has at most [`Sharpness::LARGE`] pixels.
    Large,
    /// For frames with a larger side.
    Huge,
}

impl Sharpness {
    /// Limit of [`Sharpness::Small`]: a texel is no larger than a pixel if all bodies fill the frame.
    pub const SMALL: usize = 720;
    /// Limit of [`Sharpness::Large`], in the same way.
    pub const LARGE: usize = 2 * Self::SMALL;

    /// The sharpness that a frame needs.
    pub fn of(order: &Order) -> Self {
        match order.size[0].max(order.size[1]) {
            _ if order.is_moving => Self::Coarse,
            side if side <= Self::SMALL => Self::Small,
            side if side <= Self::LARGE => Self::Large,
            _ => Self::Huge,
        }
    }

    /// Texels along a side of the shadow map.
    fn texels(self) -> usize {
        match self {
            Self::Coarse => 768,
            Self::Small => 1024,
            Self::Large => 2048,
            Self::Huge => 4096,
        }
    }

    /// Shadow maps that are still to be drawn, with their side halved some times.
    fn shadows(self, scene: &Scene, lamp: Lamp, halvings: usize) -> ShadowMaps {
        let side = match lamp {
            Lamp::Sun(_) => self.texels(),
            Lamp::Bulb { .. } => self.texels() / LAMP_SIDE,
        };
        ShadowMaps::new(scene, lamp, side >> halvings, self == Self::Coarse)
    }
}

/// The lighting of a scene, kept for all frames while the camera moves.
pub struct Lighting {
    lamp: Lamp,
    params: ShadeParams,
    finishes: Vec<SurfaceFinish>,
    tone: Tone,
    shadows: ShadowMaps,
    floor: FloorSearch,
    contact: FloorContact,
    sharpness: Sharpness,
    is_ready: bool,
}

impl Lighting {
    /// The lighting of a scene with these materials.
    pub fn new(
        scene: &Scene,
        lamp: Lamp,
        (params, materials): (&ShadeParams, &[Material]),
        sharpness: Sharpness,
    ) -> Self {
        let finish = |material| finish_of(material, params);
        Self {
            lamp,
            params: *params,
            finishes: materials.iter().map(finish).collect(),
            tone: Tone::new(),
            shadows: sharpness.shadows(scene, lamp, 0),
            floor: FloorSearch::new(scene),
            contact: FloorContact::new(scene),
            sharpness,
            is_ready: false,
        }
    }

    /// The same lighting with the lamp at another place. Its shadow maps are still to be drawn.
    pub(super) fn with_lamp(&self, scene: &Scene, lamp: Lamp) -> Self {
        let layers = self.shadows.layers();
        let is_much = |halvings: &usize| layers >> (2 * halvings) > MOST_LAYERS;
        let halvings = (0..HALVINGS).take_while(is_much).count();
        let light = Self {
            lamp,
            params: self.params,
            finishes: self.finishes.clone(),
            tone: self.tone.clone(),
            shadows: self.sharpness.shadows(scene, lamp, halvings),
            floor: self.floor.clone(),
            contact: self.contact.clone(),
            sharpness: self.sharpness,
            is_ready: false,
        };
        light.cut_by(self.cut())
    }

    /// Its lamp.
    pub(super) fn lamp(&self) -> Lamp {
        self.lamp
    }

    /// The same lighting for a scene that is cut by a plane.
    pub fn cut_by(mut self, cut: Option<Cut>) -> Self {
        self.shadows.cut = cut;
        self.contact.cut_by(cut);
        self
    }

    /// The plane that cuts its scene.
    pub fn cut(&self) -> Option<Cut> {
        self.shadows.cut
    }

    /// The resolution of its shadows.
    pub fn sharpness(&self) -> Sharpness {
        self.sharpness
    }

    /// Finds the floor, and draws its maps and those of the shadows, for the work of about this many triangles; true
    /// when finished.
    pub fn advance(&mut self, scene: &Scene, amount: usize) -> bool {
        let has_floor =
            |own: &mut Self| own.floor.advance(scene, amount) && own.contact.advance(scene, amount);
        if !self.is_ready && has_floor(self) {
            self.is_ready = self.params.shadow <= 0.0 || self.shadows.advance(scene, amount);
        }
        self.is_ready
    }

    /// The plane of the floor; the light must be ready.
    pub(super) fn floor_plane(&self) -> FloorPlane {
        self.floor.plane()
    }

    /// The visible share of the sky over the floor below a point, 0..1.
    #[inline(always)]
    pub(super) fn floor_open(&self, point: Vec3) -> f32 {
        self.contact.open(point)
    }

    /// The colour on the screen of the floor at a point. Its tone in full light depends on no recipe.
    #[inline(always)]
    pub(super) fn floor(&self, point: Vec3, reaching: &Reaching) -> [f32; 3] {
        let (strength, sky) = match self.lamp {
            Lamp::Sun(_) => (1.0, 1.0),
            Lamp::Bulb { .. } => {
                let (to, strength) = self.lamp.from(point);
                (lesser(to.y * strength, 1.0), NIGHT)
            }
        };
        let open = open_to(&self.params, lesser(reaching.sky, reaching.floor));
        let lamp = seen_of(&self.params, reaching.lamp, open);
        floor_colour(lamp * strength, open * sky)
    }

    /// The visible share of the lamp at a point, 0..1; `normal` is that of the triangle.
    pub fn visible(&self, point: Vec3, normal: Vec3) -> f32 {
        let (to, _) = self.lamp.from(point);
        match normal.dot(to) > 0.0 {
            true => self.seen(&self.spot_of(point, normal, 0.0)),
            false if self.params.shadow <= 0.0 => 1.0,
            false => 0.0,
        }
    }

    /// The shadow map position for a point; `None` if it faces away from the lamp. `flat` is the normal of
    /// its triangle, and `slack` how far the body's own surface may lie off the point, in the world.
    #[inline(always)]
    pub(super) fn spot(
        &self,
        position: Vec3,
        [normal, flat]: [Vec3; 2],
        slack: f32,
    ) -> Option<ShadowSample> {
        let (to, _) = self.lamp.from(position);
        // A triangle turned away from the lamp may be part of a round surface that faces it.
        let is_flat = flat.dot(to) > TURNED;
        let normal = if is_flat { flat } else { normal };
        let faces = normal.dot(to) > 0.0;
        faces.then(|| self.spot_of(position, normal, slack))
    }

    /// Like `spot`, for the far side of a thin body, which faces the lamp. `thick` is the thickness, in the world.
    pub(super) fn spot_behind(&self, position: Vec3, normal: Vec3, thick: f32) -> ShadowSample {
        let (to, _) = self.lamp.from(position);
        self.spot_of(position + to * thick, -normal, 0.0)
    }

    /// Like `spot`, for a surface that is known to face the lamp.
    #[inline(always)]
    fn spot_of(&self, point: Vec3, normal: Vec3, slack: f32) -> ShadowSample {
        match self.params.shadow <= 0.0 {
            true => ShadowSample::BESIDE,
            false => self.shadows.spot(point, normal, slack),
        }
    }

    /// The visible share of the lamp at a place of the shadow maps, 0..1.
    #[inline(always)]
    pub(super) fn seen(&self, spot: &ShadowSample) -> f32 {
        self.shadows.visible(spot)
    }

    /// The distance from a point to the body that hides the lamp from it; `None` if nothing does, or there are no
    /// shadows.
    pub(super) fn blocker(&self, point: Vec3) -> Option<f32> {
        let has_shadows = self.params.shadow > 0.0;
        has_shadows.then(|| self.shadows.blocker(point)).flatten()
    }

    /// The visible share of the lamp on a surface that faces it, 0..1; `to` is the direction to the lamp.
    pub(super) fn visible_along(&self, point: Vec3, to: Vec3) -> f32 {
        self.seen(&self.spot_of(point, to, 0.0))
    }

    /// The light that points of surfaces send to the eye, linear.
    #[inline(always)]
    pub(super) fn reflected(&self, points: &LitPoints) -> FourVectors {
        points.light(&self.lamp, &self.params)
    }

    /// The finish of a row of the table of materials; beyond the table, that of the last row.
    #[inline(always)]
    pub(super) fn finish(&self, material: u8) -> &SurfaceFinish {
        let last = self.finishes.len().saturating_sub(1);
        let finish = self.finishes.get(usize::from(material).min(last));
        finish.unwrap_or(&BLACK)
    }

    /// The colour on the screen of linear light.
    #[inline(always)]
    pub(super) fn screen(&self, light: Vec3) -> [u8; 3] {
        light.to_array().map(|v| self.tone.screen(v))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Body, Instance, Place};
    use super::*;
    use crate::solid::Surface;

    /// Squares above each other.
    fn pile_of_squares(count: u32) -> Scene {
        let mut surface = Surface::default();
        for k in 0..count {
            let y = k as f32 / 1024.0;
            for [x, z] in [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]] {
                surface.positions.push(Vec3::new(x, y, z));
                surface.normals.push(Vec3::Y);
                surface.colours.push([128; 3]);
            }
            let [a, b, c, d] = [0, 1, 2, 3].map(|corner| 4 * k + corner);
            surface.triangles.extend([[a, b, c], [a, c, d]]);
        }
        Scene {
            bodies: vec![Body::new(vec![surface], 0)],
            instances: vec![Instance {
                body: 0,
                place: Place::default(),
                id: 1,
                paint: None,
            }],
            ..Scene::default()
        }
    }

    /// How many slices the shadow maps take: for the first sample, and for a sample with the lamp at another place.
    fn slices_of(scene: &Scene) -> [usize; 2] {
        let params = ShadeParams::DEFAULT;
        let up = Lamp::Sun(Vec3::Y);
        let first = ready(
            Lighting::new(scene, up, (&params, &[]), Sharpness::Small),
            scene,
        );
        let beside = Lamp::Sun(Vec3::new(0.1, 1.0, 0.0).normalize());
        let second = ready(first.0.with_lamp(scene, beside), scene);
        [first.1, second.1]
    }

    /// Makes the lighting ready; gives it and the number of slices that this took.
    fn ready(mut light: Lighting, scene: &Scene) -> (Lighting, usize) {
        let mut slices = 0;
        while !light.advance(scene, 20_000) {
            slices += 1;
        }
        (light, slices)
    }

    #[test]
    fn later_samples_save_work_where_bodies_cover_each_other_many_times() {
        let [first, second] = slices_of(&pile_of_squares(20));
        assert!(second > first / 2, "{first} {second}");
        let [first, second] = slices_of(&pile_of_squares(100));
        assert!(second < first / 2, "{first} {second}");
    }
}
