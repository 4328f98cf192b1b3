//! The finished picture once more, with more pixels: the same cells, stones and noises, seen finer.

use super::{Studio, translate};
use crate::export::{Map, MapKind, maps};
use crate::render::Shader;
use crate::solid::Quarry;
use crate::texture::{Painter, Planes};

/// Most pixels along the side: more would not fit into the memory that browsers give a page.
pub const MOST_PIXELS: usize = 4096;
/// At most so many pixels for one of the picture, along a side.
const MOST_SCALE: usize = 4;
/// Pixels that stones are put into at a time: what is known of their samples is held for these only.
const BAND: usize = 1 << 21;
/// Rows of one slice of what goes by rows.
const ROWS: usize = 16;
/// Bytes of all that is held at once, for each pixel, besides the band.
const BYTES: usize = 28;

/// What one slice of work gave of a bigger picture.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureSlice {
    /// The picture begins with these rows: those of calls before are of another one.
    pub begun: bool,
    /// How much of the work is done, about, 0..1.
    pub progress: f64,
    /// Pixels along the picture's side.
    pub side: usize,
    /// Red, green, blue of the next pixels, whole rows from the top; mostly none yet.
    pub rows: Vec<u8>,
    /// The picture ends with them.
    pub done: bool,
}

/// A bigger picture in the making, or what is left of it.
pub(super) struct Bigger {
    scale: usize,
    /// State of the work that it is made of.
    stamp: u64,
    quarry: Quarry,
    painter: Option<Painter>,
    /// Bands of rows in which all stones are, and stones in the band at hand.
    bands: usize,
    stones: usize,
    at: At,
    /// Slices since `at` is what it is.
    turns: usize,
    planes: Option<Planes>,
    shader: Option<Shader>,
    given: usize,
}

/// What is being made, in this order.
#[derive(Clone, Copy, PartialEq)]
enum At {
    Ground,
    Stones,
    Weather,
    Light,
    Done,
}

impl Studio {
    /// Works for about `budget` milliseconds by `clock` on the finished picture with `scale` times as
    /// many pixels along its side. Begins anew where the picture or the scale is another one than the
    /// last time, or the last one was done. What it holds is let go by [`Studio::stop_file`].
    ///
    /// # Errors
    /// A sentence where the picture is not finished, or would be too large.
    pub fn picture_file(
        &mut self,
        scale: usize,
        clock: &mut dyn FnMut() -> f64,
        budget: f64,
    ) -> Result<PictureSlice, String> {
        let stamp = self.stamp();
        let goes_on = |b: &Bigger| (b.scale, b.stamp) == (scale, stamp) && b.at != At::Done;
        let kept = self.bigger.take().filter(goes_on);
        let side = self.side().saturating_mul(scale);
        if !self.done() {
            return Err("The picture is not finished: save it when it is done.".to_owned());
        }
        if !(1..=MOST_SCALE).contains(&scale) || side > MOST_PIXELS {
            let most = (MOST_PIXELS / self.side()).clamp(1, MOST_SCALE);
            return Err(format!(
                "A picture of {} pixels can be saved at 1 to {most} times its side, not at {scale}: \
                 {MOST_PIXELS} pixels a side are the most.",
                self.side()
            ));
        }
        let begun = kept.is_none();
        let mut bigger = match kept {
            Some(bigger) => bigger,
            None => self.begin_bigger(scale, side, stamp)?,
        };
        let begin = clock();
        // Not `>=`: a clock that fails must not make this endless.
        while bigger.at != At::Done {
            self.add_to(&mut bigger);
            let inside = clock() - begin < budget;
            if !inside {
                break;
            }
        }
        let slice = PictureSlice {
            begun,
            progress: self.progress_of(&bigger, side),
            side,
            rows: bigger.take(),
            done: bigger.at == At::Done,
        };
        self.bigger = Some(bigger);
        Ok(slice)
    }

    /// Lets go of files in the making, and of what was kept of a bigger picture for its maps.
    pub fn stop_file(&mut self) {
        self.saving = None;
        self.bigger = None;
    }

    /// A map of the planes of the bigger picture that was finished last.
    ///
    /// # Errors
    /// A sentence where there is none, or of another pavement.
    pub fn bigger_map(&self, kind: MapKind) -> Result<Map, String> {
        let stamp = self.stamp();
        let done = |b: &&Bigger| b.at == At::Done && b.stamp == stamp;
        let bigger = self.bigger.as_ref().filter(done);
        let planes = bigger.and_then(|b| b.planes.as_ref());
        let planes = planes.ok_or("Maps are made of a finished picture: make that first.")?;
        let optics = translate::optics(&self.working);
        let shininess = translate::shading(&self.working).shininess;
        Ok(maps::map(kind, planes, &optics, shininess))
    }

    fn begin_bigger(&self, scale: usize, side: usize, stamp: u64) -> Result<Bigger, String> {
        let mut room: Vec<u8> = Vec::new();
        if room.try_reserve_exact(BYTES * side * side).is_err() {
            return Err(format!(
                "There is not enough memory for a picture of {side} pixels: choose a smaller one."
            ));
        }
        drop(room);
        let mut params = translate::texture(&self.working);
        params.fine = scale;
        let mut painter = Painter::banded(params, (BAND / side).max(ROWS));
        painter.dress(&self.made.coats);
        Ok(Bigger {
            scale,
            stamp,
            quarry: Quarry::for_pixels(scale),
            painter: Some(painter),
            bands: 0,
            stones: 0,
            at: At::Ground,
            turns: 0,
            planes: None,
            shader: None,
            given: 0,
        })
    }

    /// One slice of the work.
    fn add_to(&self, bigger: &mut Bigger) {
        bigger.turns += 1;
        let over = match (&mut bigger.painter, &self.made.domain) {
            (Some(painter), Some(domain)) => match bigger.at {
                At::Ground => painter.prepare(ROWS),
                At::Stones => {
                    if let Some(cell) = self.scales().get(bigger.stones) {
                        let done = painter.paint_slice(&mut bigger.quarry, cell, bigger.stones);
                        bigger.stones += usize::from(done);
                        false
                    } else {
                        (bigger.bands, bigger.stones) = (bigger.bands + 1, 0);
                        !painter.next_band()
                    }
                }
                _ => painter.weather(domain, ROWS) && painter.finish(ROWS),
            },
            _ => self.light(bigger),
        };
        if over {
            bigger.turns = 0;
            bigger.at = match bigger.at {
                At::Ground => At::Stones,
                At::Stones => At::Weather,
                At::Weather => {
                    bigger.planes = bigger.painter.take().map(Painter::into_planes);
                    At::Light
                }
                _ => At::Done,
            };
        }
    }

    fn light(&self, bigger: &mut Bigger) -> bool {
        let Some(planes) = &bigger.planes else {
            return true;
        };
        let params = translate::shading(&self.working);
        let new = || Shader::new(&params, planes.side, planes.fine);
        let shader = bigger.shader.get_or_insert_with(new);
        shader.advance(planes, &translate::optics(&self.working), ROWS)
    }

    fn progress_of(&self, bigger: &Bigger, side: usize) -> f64 {
        let turns = bigger.turns as f64;
        let rows = side.div_ceil(ROWS) as f64;
        let cells = self.scales().len().max(1);
        let bands = side.div_ceil((BAND / side).max(ROWS)) as f64;
        let (from, to, part) = match bigger.at {
            At::Ground => (0.0, 0.05, turns / (2.0 * rows)),
            At::Stones => {
                let stones = bigger.stones as f64 / cells as f64;
                (0.05, 0.75, (bigger.bands as f64 + stones) / bands)
            }
            At::Weather => (0.75, 0.9, turns / (3.0 * rows)),
            At::Light => (0.9, 1.0, turns / (2.0 * rows)),
            At::Done => (1.0, 1.0, 0.0),
        };
        from + (to - from) * part.min(1.0)
    }
}

impl Bigger {
    /// The rows that are finished and were not given yet.
    fn take(&mut self) -> Vec<u8> {
        let Some(shader) = &self.shader else {
            return Vec::new();
        };
        let finished = shader.finished();
        let fresh = &finished[self.given..];
        self.given = finished.len();
        let pixels = fresh.chunks_exact(4);
        let rows = pixels.flat_map(|p| [p[0], p[1], p[2]]).collect();
        if self.at == At::Done {
            self.shader = None;
        }
        rows
    }
}
