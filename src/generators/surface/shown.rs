//! What is on the turntable: the stones, or a view of the work as it goes on.

use super::Surface;
use super::params::Params;
use super::views::View;
use crate::generators::height_field::LightParams;
use crate::generators::turntable::{Stand, Turntable};
use crate::generators::{Clock, FrameSlice, SeenBody, TurnOrder};
use crate::light::Light;
use crate::notice::{Code, Notice};
use crate::scene::{Camera, Frame, Scene};
use crate::surface::stones::Fit;
use glam::DVec3;
use std::rc::Rc;

/// Places of the model are so deep under stones at most, in its box.
const BURIED: f32 = 0.06;

/// Clockwise seen from above, by degrees.
fn clockwise([x, z]: [f64; 2], degrees: f64) -> [f64; 2] {
    let angle = degrees.to_radians();
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    [x * cos - z * sin, x * sin + z * cos]
}

/// The camera that sees the model as `camera` does where it is turned by `yaw`.
pub(super) fn turned(camera: Camera, yaw: f64) -> Camera {
    if yaw == 0.0 {
        return camera;
    }
    let [x, y, z] = camera.target;
    let [x, z] = clockwise([x, z], -yaw);
    Camera {
        angle: camera.angle - yaw,
        target: [x, y, z],
        ..camera
    }
}

/// The light that falls on the model as `light` does where it is turned by `yaw`.
pub(super) fn seen_by(light: &LightParams, yaw: f64) -> LightParams {
    let mut light = light.clone();
    light.shade.light = match light.shade.light {
        _ if yaw == 0.0 => return light,
        Light::Parallel { azimuth, elevation } => Light::Parallel {
            azimuth: azimuth - yaw.to_radians(),
            elevation,
        },
        Light::Point { x, y, z } => {
            let [x, y] = clockwise([x - 0.5, y - 0.5], -yaw);
            Light::Point {
                x: x + 0.5,
                y: y + 0.5,
                z,
            }
        }
    };
    light
}

/// What is shown.
#[derive(Default)]
pub(super) struct Shown {
    table: Turntable,
    /// What the frame is of: the view, and of which work.
    of: Option<(View, u64)>,
    scene: Option<Rc<Scene>>,
    /// Its number, and of all so far.
    number: u64,
    count: u64,
}

impl Shown {
    /// The frame last finished.
    pub fn frame(&self) -> Option<&Frame> {
        self.table.frame()
    }

    fn show(&mut self, of: (View, u64), scene: Rc<Scene>) {
        self.count += 1;
        (self.of, self.scene, self.number) = (Some(of), Some(scene), self.count);
    }
}

impl Surface {
    pub(super) fn turn_slice(
        &mut self,
        order: &TurnOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<FrameSlice, Notice> {
        if let Some((id, step)) = order.step()? {
            let _ = (id, step);
            return Err(order.no_such_body());
        }
        let mut shown = std::mem::take(&mut self.shown);
        self.choose(&mut shown, View::of_words(&order.how));
        let made = self.frame_slice(&mut shown, order, clock, budget);
        self.shown = shown;
        made
    }

    /// Takes the scene that is to be seen, where it is another one than that before.
    fn choose(&self, shown: &mut Shown, view: View) {
        let Some((scene, revision)) = self.made.scene() else {
            return;
        };
        let of = (view, revision);
        if shown.of != Some(of) {
            shown.show(of, scene.clone());
        }
    }

    fn frame_slice(
        &self,
        shown: &mut Shown,
        order: &TurnOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<FrameSlice, Notice> {
        let Some(scene) = &shown.scene else {
            return Err(Code::NotYet.into());
        };
        let Params { light, yaw, .. } = &self.working.params;
        let light = seen_by(light, *yaw);
        let order = TurnOrder {
            camera: turned(order.camera, *yaw),
            ..order.clone()
        };
        let stand = Stand {
            scene,
            number: shown.number,
            light: &light,
            ground: scene.lowest(),
        };
        shown.table.advance(&stand, &order, clock, budget)
    }

    /// The stone at a pixel of the frame last finished.
    pub(super) fn seen_at(&self, x: usize, y: usize) -> Option<SeenBody> {
        let scene = self.shown.scene.as_ref()?;
        let place = self.shown.frame()?.instance_at(x, y)?;
        let instance = scene.instances.get(place)?;
        let (middle, _) = scene.ball_of(instance);
        let [mx, mz] = [middle.x, middle.z].map(f64::from);
        let [mx, mz] = clockwise([mx, mz], self.working.params.yaw);
        Some(SeenBody {
            id: instance.id,
            cell: [0.0; 2],
            middle: [mx, middle.y.into(), mz],
        })
    }

    /// The place of the model at a pixel of the frame last finished, as rows of strokes and spots have it; nothing
    /// beside the model.
    pub(super) fn place_at(&self, x: usize, y: usize) -> Option<[i64; 3]> {
        let frame = self.shown.frame()?;
        frame.instance_at(x, y)?;
        let [width, height] = frame.order().size;
        let depth = *frame.depths().get(y * width + x)?;
        let view = frame.order().camera.view(width, height);
        let p = view.eye + view.ray(x as f32 + 0.5, y as f32 + 0.5) * depth;
        let built = self.made.last_built()?;
        let fit = Fit::new(&built.whole);
        let model = DVec3::from(p.to_array().map(f64::from)) / fit.scale + fit.middle;
        p.is_finite()
            .then(|| super::tracing::numbers(&built.mesh, model))
    }

    /// Where such a place is in the frame last finished, in pixels; nothing where it is not seen there.
    pub(super) fn pixel_of(&self, place: [i64; 3]) -> Option<[f64; 2]> {
        let frame = self.shown.frame()?;
        let built = self.made.last_built()?;
        let fit = Fit::new(&built.whole);
        let [width, height] = frame.order().size;
        let view = frame.order().camera.view(width, height);
        let seen = view.of(fit.place(super::tracing::place(&built.mesh, place)));
        if seen.z <= view.near {
            return None;
        }
        let [x, y, _] = view.on_screen(seen);
        let is_inside = x >= 0.0 && y >= 0.0 && x < width as f32 && y < height as f32;
        let depth = frame.depths().get(y as usize * width + x as usize);
        let is_seen = is_inside && depth.is_some_and(|&depth| seen.z < depth + BURIED);
        is_seen.then(|| [x.into(), y.into()])
    }
}
