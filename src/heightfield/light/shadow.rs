//! Height-field shadows at constant cost a pixel.
//!
//! What casts a shadow is carried from line to line of pixels away from the light: rows, or columns
//! where the light comes more from the side. The lamp has an extent: its upper and lower rim cast a
//! shadow each, and the penumbra lies between the two.
//!
//! On a tile the shadows of a parallel light come in again at the other edge: the lines from which they
//! reach so far are crossed before the first one. Under a point light no picture can repeat, and nothing
//! beyond its edges throws a shadow.

use super::Light;
use super::cast_far::Sweep;
use super::cast_near::Fan;
use super::course::{Course, Strip};
use crate::heightfield::Planes;
use crate::order::{greater, lesser};

/// Shadows are followed back at most through so many pictures of a tile.
const FARTHEST: usize = 4;

/// The lamp's visible part at each pixel, in the making.
pub struct Shadows {
    side: usize,
    fine: usize,
    /// 255 where the whole lamp is seen.
    lit: Vec<u8>,
    caster: Caster,
    /// Runs of lines still to be done, the next one last.
    courses: Vec<Course>,
    strip: Strip,
    begun: bool,
}

/// What carries the shadows of a kind of light.
enum Caster {
    Far(Sweep),
    Near(Fan),
}

impl Shadows {
    /// Shadows of `light` in a picture of `side` pixels, `fine` for each picture unit.
    pub fn new(light: Light, side: usize, fine: usize) -> Self {
        let (caster, courses) = cast_by(light, side, fine);
        Self {
            side,
            fine,
            lit: vec![255; side * side],
            caster,
            courses,
            strip: Strip::default(),
            begun: false,
        }
    }

    /// Begins anew under another light.
    pub fn restart(&mut self, light: Light) {
        (self.caster, self.courses) = cast_by(light, self.side, self.fine);
        self.lit.fill(255);
        self.begun = false;
    }

    /// Carries the shadows on by about `lines` lines; true when all are done.
    pub fn advance(&mut self, planes: &Planes, lines: usize) -> bool {
        let bump = &planes.bump;
        if !std::mem::replace(&mut self.begun, true) {
            match &mut self.caster {
                Caster::Near(fan) => fan.raise(planes.ground),
                Caster::Far(_) if planes.tile => self.wrap(bump),
                Caster::Far(_) => {}
            }
        }
        let mut done = 0;
        while let Some(course) = self.courses.last_mut() {
            if done >= lines {
                return false;
            }
            let fresh = course.is_fresh();
            let span = course.take();
            let course = course.clone();
            if let (true, Caster::Near(fan)) = (fresh, &mut self.caster) {
                fan.turn(&course, bump);
            }
            done += span.len();
            self.draw(bump, &course, span);
            if course.is_over() {
                self.courses.pop();
            }
        }
        true
    }

    /// The plane so far.
    pub fn lit(&self) -> &[u8] {
        &self.lit
    }

    /// Lets the shadows of a parallel light come in from the pictures around.
    fn wrap(&mut self, bump: &[f32]) {
        let (Caster::Far(sweep), [course]) = (&mut self.caster, &self.courses[..]) else {
            return;
        };
        let mut range = (f32::MAX, f32::MIN);
        for &height in bump {
            range = (lesser(range.0, height), greater(range.1, height));
        }
        let mut before = sweep.wrap(range.1 - range.0).min(FARTHEST * self.side);
        // The nearest lines come last, so they are pushed first.
        let course = course.clone();
        while before > 0 {
            let lines = before.min(self.side);
            self.courses.push(course.last(lines));
            before -= lines;
        }
    }

    /// The lines of `span`, in the order of the course.
    fn draw(&mut self, bump: &[f32], course: &Course, span: std::ops::Range<usize>) {
        let side = self.side;
        if course.columns {
            self.strip.load(bump, &self.lit, side, &span);
        }
        for step in 0..span.len() {
            let place = if course.backwards {
                span.len() - 1 - step
            } else {
                step
            };
            let (heights, lit) = if course.columns {
                self.strip.line(place)
            } else {
                let row = (span.start + place) * side..(span.start + place + 1) * side;
                (&bump[row.clone()], &mut self.lit[row])
            };
            match &mut self.caster {
                Caster::Far(sweep) => sweep.line(heights, lit),
                Caster::Near(fan) => fan.line(span.start + place, heights, lit),
            }
        }
        if course.columns {
            self.strip.store(&mut self.lit, side, &span);
        }
    }
}

fn cast_by(light: Light, side: usize, fine: usize) -> (Caster, Vec<Course>) {
    match light {
        Light::Parallel { azimuth, elevation } => {
            let (sweep, course) = Sweep::new(azimuth, elevation, [side, fine]);
            (Caster::Far(sweep), vec![course])
        }
        Light::Point { x, y, z } => {
            let (fan, courses) = Fan::new(x, y, z, [side, fine]);
            (Caster::Near(fan), courses.into())
        }
    }
}
