//! The finished picture once more, with more pixels: the same cells, stones and noises, seen finer.

use super::files::map_of;
use super::height_field::{Bodies, HeightField, Passes, ROWS, Revisions};
use super::{Studio, params};
use crate::export::{Map, MapKind};
use crate::notice::{Code, Notice};
use crate::recipe::Stage;

/// Most pixels along the side: more would not fit into the memory that browsers give a page.
pub const MOST_PIXELS: usize = 4096;
/// At most so many pixels for one of the picture, along a side.
const MOST_SCALE: usize = 4;
/// Pixels that stones are put into at a time: what is known of their samples is held for these only.
const BAND: usize = 1 << 21;
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
    /// Which of the pictures it is.
    revision: u64,
    finish: HeightField,
    /// Slices of the stage at work.
    slices: usize,
    /// Bytes of the picture that were handed out.
    given: usize,
}

/// A bigger picture has no inputs that change.
const INPUTS: Revisions = Revisions {
    domain: 0,
    cells: 0,
};

impl Studio {
    /// Works for about `budget` milliseconds by `clock` on the finished picture with `scale` times as
    /// many pixels along its side. Begins anew where the picture or the scale is another one than the
    /// last time, or the last one was done. What it holds is let go by [`Studio::stop_file`].
    ///
    /// # Errors
    /// A notice where the picture is not finished, or would be too large.
    pub fn picture_file(
        &mut self,
        scale: usize,
        clock: &mut dyn FnMut() -> f64,
        budget: f64,
    ) -> Result<PictureSlice, Notice> {
        let revision = self.made.finish.light.revision();
        let goes_on = |b: &Bigger| (b.scale, b.revision) == (scale, revision) && b.at().is_some();
        let kept = self.bigger.take().filter(goes_on);
        let side = self.side().saturating_mul(scale);
        if !self.done() {
            return Err(Code::NotYet.into());
        }
        if !(1..=MOST_SCALE).contains(&scale) || side > MOST_PIXELS {
            let most = (MOST_PIXELS / self.side()).clamp(1, MOST_SCALE);
            let notice = Notice::new(Code::BadScale).with("side", self.side());
            let notice = notice.with("most", most).with("given", scale);
            return Err(notice.with("pixels", MOST_PIXELS));
        }
        let begun = kept.is_none();
        let mut bigger = match kept {
            Some(bigger) => bigger,
            None => self.begin_bigger(scale, side, revision)?,
        };
        let begin = clock();
        // Not `>=`: a clock that fails must not make this endless.
        while bigger.at().is_some() {
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
            done: bigger.at().is_none(),
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
    /// A notice where there is none, or of another pavement.
    pub fn bigger_map(&self, kind: MapKind) -> Result<Map, Notice> {
        let revision = self.made.finish.light.revision();
        let done = |b: &&Bigger| b.at().is_none() && b.revision == revision;
        let bigger = self.bigger.as_ref().filter(|_| self.done()).filter(done);
        let planes = bigger.and_then(|b| b.finish.weather.made());
        let planes = planes.ok_or(Code::NoBiggerPicture)?;
        Ok(map_of(kind, planes, &self.working.params.finish.light))
    }

    fn begin_bigger(&self, scale: usize, side: usize, revision: u64) -> Result<Bigger, Notice> {
        let mut room: Vec<u8> = Vec::new();
        if room.try_reserve_exact(BYTES * side * side).is_err() {
            return Err(Notice::new(Code::NoMemory).with("side", side));
        }
        drop(room);
        let params = params::finish(&self.working.recipe, scale, self.finer);
        Ok(Bigger {
            scale,
            revision,
            finish: HeightField::new(params, Passes::One, band(side)),
            slices: 0,
            given: 0,
        })
    }

    /// One slice of the work.
    fn add_to(&self, bigger: &mut Bigger) {
        let (Some(domain), Some(at)) = (self.made.terrain.domain.made(), bigger.at()) else {
            return;
        };
        let bodies = Bodies {
            domain,
            cells: self.made.scales(),
            coats: self.made.coats(),
        };
        bigger.finish.advance(at, bodies, INPUTS);
        bigger.slices = match bigger.at() == Some(at) {
            true => bigger.slices + 1,
            false => 0,
        };
    }

    fn progress_of(&self, bigger: &Bigger, side: usize) -> f64 {
        let slices = bigger.slices as f64;
        let rows = side.div_ceil(ROWS) as f64;
        let cells = self.scales().len().max(1);
        let bands = side.div_ceil(band(side)) as f64;
        let (from, to, part) = match bigger.at() {
            Some(Stage::Planes) if !bigger.finish.is_bedded(INPUTS) => {
                (0.0, 0.05, slices / (2.0 * rows))
            }
            Some(Stage::Planes) => {
                let stones = bigger.finish.stones_coming(INPUTS) as f64 / cells as f64;
                let done = bigger.finish.bands_done(INPUTS) as f64 + stones;
                (0.05, 0.75, done / bands)
            }
            Some(Stage::Weather) => (0.75, 0.9, slices / (3.0 * rows)),
            Some(_) => (0.9, 1.0, slices / (2.0 * rows)),
            None => (1.0, 1.0, 0.0),
        };
        from + (to - from) * part.min(1.0)
    }
}

/// Rows of a picture that stones are put into at a time.
fn band(side: usize) -> usize {
    (BAND / side).max(ROWS)
}

impl Bigger {
    /// The stage at work; none where all is done.
    fn at(&self) -> Option<Stage> {
        self.finish.due(INPUTS).map(|(stage, _)| stage)
    }

    /// The rows that are finished and were not given yet.
    fn take(&mut self) -> Vec<u8> {
        let finished = self.finish.shaded();
        let fresh = &finished[self.given.min(finished.len())..];
        let pixels = fresh.chunks_exact(4);
        let rows = pixels.flat_map(|p| [p[0], p[1], p[2]]).collect();
        self.given = finished.len();
        if self.at().is_none() {
            self.finish.drop_shader();
        }
        rows
    }
}
