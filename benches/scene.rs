//! Frames of a scene: a hide of many scales, as the turntable shows it.

use super::{Clock, Timing, shortest};
use bubblestone::generators::ALL;
use bubblestone::generators::pavement;
use bubblestone::heightfield::{GROUND, HeightFieldScene, TextureParams};
use bubblestone::light::ShadeParams;
use bubblestone::material::{Gloss, Material, material_table};
use bubblestone::scene::{
    Backdrop, Body, Camera, Frame, Instance, Lamp, Lighting, Order, Place, Scene, Sharpness,
};
use bubblestone::solid::Surface;
use bubblestone::studio::Studio;

/// The number of scales of the hide.
const SCALES: usize = 2_000;
/// The number of triangles of each scale at its finest level.
const EACH: usize = 200;
/// A level has this many times the triangles of the next one, as in the turntable's scenes.
const FINER: usize = 4;
/// The recipe of a fish's hide with a few more scales than needed.
const HIDE: &str = "tile=1&kind=ellipse&ca=1.3&cs=12.3&dir=constant&angle=90&stone=skin&sv=1.8\
    &sr=0.8&sc=1.8&tilt=0.15&sa=-90&tc=0.5&palette=fish&ground=hide";
/// Width and height of the still frame in pixels; a turning one has half of them.
pub const SIZE: [usize; 2] = [640, 480];
/// A camera that sees the whole hide, which fills most of the frame.
pub const CAMERA: Camera = Camera {
    angle: 0.0,
    height: 56.0,
    distance: 1.85,
    lens: 28.0,
    target: [0.0, 0.0, 0.03],
};
const STILL: Order = Order {
    camera: CAMERA,
    size: SIZE,
    samples: 1,
    aperture: 0.0,
    is_moving: false,
    backdrop: Backdrop::Floor,
    cut: None,
};
/// The work of a slice, as on the turntable.
const SLICE: usize = 20_000;

/// A hide and its light.
pub struct Hide {
    /// The scene with a single level for the scales, so that their size on the screen has no effect, and the
    /// coarsest ground.
    still: Scene,
    /// The scene with a second, coarser level for the scales.
    turning: Scene,
    lamp: Lamp,
    params: ShadeParams,
    materials: Vec<Material>,
}

impl Hide {
    /// Returns none if the recipe fails.
    pub fn new() -> Option<Self> {
        let mut studio = Studio::new(ALL, pavement::recipe(HIDE).0);
        studio.finish(&mut || 0.0).ok()?;
        let made = studio.engine().products()?;
        let (cells, planes) = (made.scales, made.planes?);
        let texture = TextureParams {
            side: planes.side,
            stone: made.stones,
            ..TextureParams::default()
        };
        let cut_out = || {
            let mut cutout = HeightFieldScene::new(texture, cells.len(), planes);
            while !cutout.advance(cells, planes) {}
            cutout.finish()
        };
        let (mut still, mut turning) = (cut_out(), cut_out());
        let instances = still.instances.iter().copied();
        let (ground, mut scales): (Vec<_>, Vec<_>) = instances.partition(is_ground);
        scales.truncate(SCALES);
        for instance in &ground {
            let body = &mut still.bodies[instance.body as usize];
            body.levels = body.levels[body.levels.len() - 1..].into();
            turning.bodies[instance.body as usize] = body.clone();
        }
        for instance in &scales {
            let body = &mut still.bodies[instance.body as usize];
            let finest = body.levels[0].coarser(EACH, f32::MIN);
            let coarser = finest.coarser(EACH / FINER, f32::MIN);
            let material = body.material;
            *body = Body::new(vec![finest.clone()], material);
            turning.bodies[instance.body as usize] = Body::new(vec![finest, coarser], material);
        }
        still.instances = [scales, ground].concat();
        turning.instances.clone_from(&still.instances);
        let params = ShadeParams::default();
        Some(Self {
            lamp: Lamp::over_picture(params.light, planes.ground / planes.side as f32),
            still,
            turning,
            params,
            materials: material_table("fish", "hide", Gloss::Own),
        })
    }

    /// The finest surfaces with their places; the ground is the last.
    pub fn surfaces(&self) -> impl Iterator<Item = (&Surface, &Place)> {
        self.still.instances.iter().map(|instance| {
            let body = &self.still.bodies[instance.body as usize];
            (&body.levels[0], &instance.place)
        })
    }

    /// The unit vector to the lamp, and the middle and radius of the lit ball.
    #[cfg(target_arch = "wasm32")]
    pub fn lit(&self) -> ([f32; 3], [f32; 3], f32) {
        let to = match self.lamp {
            Lamp::Sun(to) => to.to_array(),
            Lamp::Bulb { at, .. } => at.to_array(),
        };
        let (middle, radius) = self.still.ball();
        (to, middle.to_array(), radius)
    }

    fn light(&self, scene: &Scene) -> Lighting {
        let made_of = (&self.params, &self.materials[..]);
        let mut light = Lighting::new(scene, self.lamp, made_of, Sharpness::of(&STILL));
        while !light.advance(scene, SLICE) {}
        light
    }
}

fn is_ground(instance: &Instance) -> bool {
    instance.id == GROUND
}

/// Times of a still frame with new shadows, and of a frame while the hide turns: first with the triangles
/// alone, then with the relief of the picture's planes.
pub fn timings(clock: Clock) -> Vec<Timing> {
    let Some(mut hide) = Hide::new() else {
        return Vec::new();
    };
    let scales = hide.surfaces().take(SCALES);
    let triangles: usize = scales.map(|(surface, _)| surface.triangles.len()).sum();
    assert!(hide.surfaces().count() == SCALES + 1 && triangles == SCALES * EACH);
    let relief = [hide.still.detail.take(), hide.turning.detail.take()];
    let mut timings = hide.timings("", clock);
    [hide.still.detail, hide.turning.detail] = relief;
    timings.extend(hide.timings(", with the picture's relief", clock));
    timings
}

impl Hide {
    fn timings(&self, with: &str, clock: Clock) -> Vec<Timing> {
        let mut frame = Frame::new(STILL);
        let mut make = |scene: &Scene, light: &Lighting, order: Order| {
            frame.begin(order);
            while !frame.advance(scene, light, SLICE) {}
            // The result is used, so that no compiler drops the work.
            let scales = frame.ids().iter().filter(|&&id| id != GROUND).count();
            assert!(3 * scales > 2 * frame.ids().len());
        };
        let stills = (0..7).map(|_| {
            let start = clock();
            let light = self.light(&self.still);
            make(&self.still, &light, STILL);
            clock() - start
        });
        let stills = shortest(stills);
        let light = self.light(&self.turning);
        let turns = (0..15).map(|k| {
            let camera = Camera {
                angle: f64::from(k),
                ..CAMERA
            };
            let order = Order {
                camera,
                size: SIZE.map(|n| n / 2),
                is_moving: true,
                ..STILL
            };
            let start = clock();
            make(&self.turning, &light, order);
            clock() - start
        });
        let turns = shortest(turns);
        let timing = |what: &str, ms| Timing {
            name: format!("{SCALES} scales of {EACH} triangles, {what}{with}"),
            ms,
        };
        vec![
            timing("still with its shadows", stills),
            timing("turning", turns),
        ]
    }
}
