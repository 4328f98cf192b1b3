//! The finished picture once more, with more pixels: the same bodies and noises, seen finer.
//!
//! Stages up to the cells' coats know picture units only. From the painter on, `pixel_scale` pixels
//! stand for each unit. Stones are painted in bands of rows, as nine samples of all pixels would not
//! fit into memory.

use super::height_field::{
    Bodies, Finish, HeightField, HeightFieldParams, Passes, ROWS, Revisions,
};
use super::{Clock, PictureSlice};
use crate::heightfield::Planes;
use crate::notice::{Code, Notice};

/// Most pixels along the side: more would not fit into the memory that browsers give a page.
pub const MOST_PIXELS: usize = 4096;
/// At most so many pixels for one of the picture, along a side.
const MOST_SCALE: usize = 4;
/// Pixels that stones are put into at a time: what is known of their samples is held for these only.
const BAND: usize = 1 << 21;
/// Bytes of all that is held at once, for each pixel, besides the band.
const BYTES: usize = 28;

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

/// What a bigger picture is made of.
pub(super) struct Picture<'a> {
    /// Pixels along its side.
    pub side: usize,
    /// Which of the pictures it is; none before it is finished.
    pub revision: Option<u64>,
    pub bodies: Option<Bodies<'a>>,
}

impl Bigger {
    /// Works for about `budget` milliseconds on a picture with `scale` times as many pixels along its
    /// side; `kept` is what was made by now.
    ///
    /// # Errors
    /// A notice where the picture is not finished, or would be too large; nothing is kept then.
    pub fn advance(
        kept: &mut Option<Bigger>,
        picture: &Picture,
        (scale, params): (usize, &dyn Fn() -> HeightFieldParams),
        clock: Clock,
        budget: f64,
    ) -> Result<PictureSlice, Notice> {
        let goes_on = |b: &Bigger| {
            (b.scale, Some(b.revision)) == (scale, picture.revision) && b.at().is_some()
        };
        let going = kept.take().filter(goes_on);
        let Picture {
            side,
            revision,
            bodies: Some(bodies),
        } = *picture
        else {
            return Err(Code::NotYet.into());
        };
        let revision = revision.ok_or(Code::NotYet)?;
        let bigger_side = side.saturating_mul(scale);
        if !(1..=MOST_SCALE).contains(&scale) || bigger_side > MOST_PIXELS {
            let most = (MOST_PIXELS / side).clamp(1, MOST_SCALE);
            let notice = Notice::new(Code::BadScale).with("side", side);
            let notice = notice.with("most", most).with("given", scale);
            return Err(notice.with("pixels", MOST_PIXELS));
        }
        let begun = going.is_none();
        let mut bigger = match going {
            Some(bigger) => bigger,
            None => Self::begin(scale, bigger_side, revision, params)?,
        };
        let begin = clock();
        // Not `>=`: a clock that fails must not make this endless.
        while bigger.at().is_some() {
            bigger.add(bodies);
            let inside = clock() - begin < budget;
            if !inside {
                break;
            }
        }
        let slice = PictureSlice {
            begun,
            progress: bigger.progress(bigger_side, bodies.cells.len()),
            side: bigger_side,
            rows: bigger.take(),
            done: bigger.at().is_none(),
        };
        *kept = Some(bigger);
        Ok(slice)
    }

    fn begin(
        scale: usize,
        side: usize,
        revision: u64,
        params: &dyn Fn() -> HeightFieldParams,
    ) -> Result<Bigger, Notice> {
        let mut room: Vec<u8> = Vec::new();
        if room.try_reserve_exact(BYTES * side * side).is_err() {
            return Err(Notice::new(Code::NoMemory).with("side", side));
        }
        drop(room);
        Ok(Bigger {
            scale,
            revision,
            finish: HeightField::new(params(), Passes::One, band(side)),
            slices: 0,
            given: 0,
        })
    }

    /// The planes, once they are finished, of the picture of this revision.
    pub fn planes(&self, revision: u64) -> Option<&Planes> {
        let planes = self.finish.weather.made();
        planes.filter(|_| self.at().is_none() && self.revision == revision)
    }

    /// One slice of the work.
    fn add(&mut self, bodies: Bodies) {
        let Some(at) = self.at() else {
            return;
        };
        self.finish.advance(at, bodies, INPUTS);
        self.slices = match self.at() == Some(at) {
            true => self.slices + 1,
            false => 0,
        };
    }

    fn progress(&self, side: usize, cells: usize) -> f64 {
        let slices = self.slices as f64;
        let rows = side.div_ceil(ROWS) as f64;
        let bands = side.div_ceil(band(side)) as f64;
        let (from, to, part) = match self.at() {
            Some(Finish::Planes) if !self.finish.is_bedded(INPUTS) => {
                (0.0, 0.05, slices / (2.0 * rows))
            }
            Some(Finish::Planes) => {
                let stones = self.finish.stones_coming(INPUTS) as f64 / cells.max(1) as f64;
                let done = self.finish.bands_done(INPUTS) as f64 + stones;
                (0.05, 0.75, done / bands)
            }
            Some(Finish::Weather) => (0.75, 0.9, slices / (3.0 * rows)),
            Some(Finish::Shading) => (0.9, 1.0, slices / (2.0 * rows)),
            None => (1.0, 1.0, 0.0),
        };
        from + (to - from) * part.min(1.0)
    }

    /// The stage at work; none where all is done.
    fn at(&self) -> Option<Finish> {
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

/// Rows of a picture that stones are put into at a time.
fn band(side: usize) -> usize {
    (BAND / side).max(ROWS)
}
