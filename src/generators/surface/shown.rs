//! What is on the turntable: the stones, or a view of the work as it goes on.

use super::Surface;
use super::params::Params;
use super::subject::{Making, Of, Subject};
use super::views::View;
use super::yaw::{clockwise, seen_by, turned};
use crate::generators::turntable::{Stand, Turntable};
use crate::generators::{Budget, Clock, FrameSlice, SeenBody, TurnOrder};
use crate::notice::{Code, Notice};
use crate::scene::Frame;
use crate::surface_stones::Fit;
use crate::surface_views::{Ground, MATERIALS};
use glam::DVec3;

/// Places of the model are so deep under stones at most, in its box.
const BURIED: f32 = 0.06;

/// What is shown.
#[derive(Default)]
pub(super) struct Shown {
    table: Turntable,
    subject: Option<Subject>,
    /// What it is of.
    of: Option<Of>,
    /// Its number, which no other scene has.
    number: u64,
    /// The next one, in the making.
    making: Option<(Of, Making)>,
    /// The bare surface that views share, and of which surface it is.
    pub(super) ground: Option<(u64, Ground)>,
}

impl Shown {
    /// The frame last finished.
    pub fn frame(&self) -> Option<&Frame> {
        self.table.frame()
    }

    /// What is shown, if it is this view.
    pub fn subject(&self, view: View) -> Option<&Subject> {
        self.subject
            .as_ref()
            .filter(|_| self.of.is_some_and(|of| of.view == view))
    }
}

impl Surface {
    pub(super) fn turn_slice(
        &mut self,
        order: &TurnOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<FrameSlice, Notice> {
        if order.step()?.is_some() {
            return Err(order.no_such_body());
        }
        let mut shown = std::mem::take(&mut self.shown);
        let budget = Budget::new(clock, budget);
        let made = match self.choose(&mut shown, View::of_words(&order.how), clock, budget) {
            Some(slice) => Ok(slice),
            None => self.frame_slice(&mut shown, order, clock, budget),
        };
        self.shown = shown;
        made
    }

    /// Makes what is to be seen; nothing where it is there, or nothing can be made yet.
    fn choose(
        &self,
        shown: &mut Shown,
        view: View,
        clock: Clock,
        budget: Budget,
    ) -> Option<FrameSlice> {
        let of = self.wanted(view)?;
        if shown.of == Some(of) {
            shown.making = None;
            return None;
        }
        // A frame that was begun is finished first: else what moves would never be seen.
        let is_alike = shown.of.is_some_and(|shown| shown.view == of.view);
        if is_alike
            && shown.of.is_some_and(|shown| shown.surface == of.surface)
            && !shown.table.is_idle()
        {
            return None;
        }
        let is_new = shown
            .making
            .as_ref()
            .is_none_or(|(making, _)| *making != of);
        if is_new {
            let last = match shown.subject.take() {
                Some(Subject::Particles(last)) if is_alike => Some(last),
                other => {
                    shown.subject = other;
                    None
                }
            };
            let making =
                Making::new(last.filter(|_| shown.of.is_some_and(|s| s.surface == of.surface)));
            shown.making = Some((of, making));
        }
        let (_, making) = shown.making.as_mut()?;
        let mut subject = None;
        let done = budget.until(clock, || {
            subject = self.make(making, of, &mut shown.ground);
            subject.is_some()
        });
        if done {
            shown.number += 1;
            (shown.subject, shown.of, shown.making) = (subject, Some(of), None);
            return None;
        }
        Some(FrameSlice {
            begun: is_new,
            done: false,
            progress: 0.0,
        })
    }

    fn frame_slice(
        &self,
        shown: &mut Shown,
        order: &TurnOrder,
        clock: Clock,
        budget: Budget,
    ) -> Result<FrameSlice, Notice> {
        let Some(subject) = &shown.subject else {
            return Err(Code::NotYet.into());
        };
        let Params { light, yaw, .. } = &self.working.params;
        let mut light = seen_by(light, *yaw);
        if !matches!(subject, Subject::Stones(_)) {
            light.materials = MATERIALS.to_vec();
        }
        let order = TurnOrder {
            camera: turned(order.camera, *yaw),
            ..order.clone()
        };
        let scene = subject.scene();
        let stand = Stand {
            scene,
            number: shown.number,
            light: &light,
            ground: scene.lowest(),
        };
        let left = budget.left(clock);
        shown.table.advance(&stand, &order, clock, left)
    }

    /// The stone, or the cell, at a pixel of the frame last finished.
    pub(super) fn seen_at(&self, x: usize, y: usize) -> Option<SeenBody> {
        let scene = self.shown.subject.as_ref()?.scene();
        let place = self.shown.frame()?.instance_at(x, y)?;
        let instance = scene.instances.get(place).filter(|i| i.id > 0)?;
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
