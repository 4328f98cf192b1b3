//! The colours of what is seen. Pixels are worked on in squares, whose surfaces, texels of shadow maps and pixels of
//! planes lie near each other in memory, too.

use super::backdrop::{FLOOR_COLOUR, behind, end_of_floor, floor_part};
use super::met::{Corners, Met, Part};
use super::occlusion::Occlusion;
use super::shadow::Spot;
use super::sight::{FLOOR, NOTHING, Sight};
use super::{Backdrop, Lighting, Scene, Surfel, View};
use glam::Vec3;
use std::ops::Range;

/// Rows that are worked on together, and columns.
const BAND: usize = 8;

/// Where the floor is and how it ends: it lies under all bodies, around the middle of the ball that they are in.
#[derive(Clone, Copy, Default)]
pub(super) struct Ground {
    pub middle: Vec3,
    pub radius: f32,
    pub height: f32,
}

/// What a frame is shaded by.
#[derive(Clone, Copy)]
pub(super) struct Studio<'a> {
    pub scene: &'a Scene,
    pub light: &'a Lighting,
    pub sight: &'a Sight,
    pub backdrop: Backdrop,
    pub ground: Ground,
    /// The colour on the screen of the floor where it fades.
    pub far: [f32; 3],
}

/// Colours in the making, from the top.
pub(super) struct Shading {
    occlusion: Occlusion,
    has_occlusion: bool,
    /// What is met in the rows of the band that is shaded and of the next one, which its occlusion reaches into.
    found: Vec<Found>,
    found_rows: usize,
}

impl Shading {
    pub fn new() -> Self {
        Self {
            occlusion: Occlusion::new(),
            has_occlusion: false,
            found: Vec::new(),
            found_rows: 0,
        }
    }

    /// Begins a frame of so many pixels.
    pub fn begin(&mut self, width: usize, pixels: usize, has_occlusion: bool) {
        self.has_occlusion = has_occlusion;
        self.occlusion.begin(pixels);
        self.found.resize(2 * BAND * width, Found::NOTHING);
        self.found_rows = 0;
    }

    /// Makes room for pixels up to this one: for all of them before [`Shading::advance`].
    pub fn make_room(&mut self, pixels: usize) {
        self.occlusion.make_room(pixels);
    }

    /// Goes on from a row, which is the first or that which was answered before, for about the work of so many;
    /// answers with the next one. `keep` is told the normal of each pixel where a body is.
    pub fn advance(
        &mut self,
        studio: Studio,
        from: usize,
        rows: usize,
        rgba: &mut [u8],
        mut keep: impl FnMut(usize, Vec3),
    ) -> usize {
        let height = studio.sight.view().size[1];
        // Finding what is met and shading it are half of the work each.
        let (mut row, mut left) = (from, 2 * rows);
        while row < height && left > 0 {
            let end = height.min(row + BAND);
            if self.found_rows < height.min(end + BAND) {
                self.find(studio, &mut keep);
            } else {
                if self.has_occlusion {
                    (row..end).for_each(|y| self.occlusion.average(studio.sight, y));
                }
                self.shade(studio, row..end, rgba);
                row = end;
            }
            left = left.saturating_sub(BAND);
        }
        row
    }

    /// Finds what is met in the next rows.
    fn find(&mut self, studio: Studio, keep: &mut impl FnMut(usize, Vec3)) {
        let [width, height] = studio.sight.view().size;
        let rows = self.found_rows..height.min(self.found_rows + BAND);
        for from in (0..width).step_by(BAND) {
            let columns = from..width.min(from + BAND);
            self.find_square(studio, [&columns, &rows], keep);
        }
        self.found_rows = rows.end;
        if self.has_occlusion {
            for y in rows {
                let normal = |x: usize| self.found[slot(width, x, y)].normal;
                self.occlusion
                    .look(studio.sight, normal, studio.scene.reach, y);
            }
        }
    }

    /// Each loop looks up what the next one works with: the processor goes on to the next pixels while it waits for
    /// memory, which takes longest of all here.
    fn find_square(
        &mut self,
        studio: Studio,
        [columns, rows]: [&Range<usize>; 2],
        keep: &mut impl FnMut(usize, Vec3),
    ) {
        let Studio {
            scene,
            sight,
            light,
            ..
        } = studio;
        let width = sight.view().size[0];
        let pixels = || square(columns, rows).map(|[x, y]| ([x, y], y * width + x));
        let mut parts = [Part::NONE; BAND * BAND];
        for ((_, at), part) in pixels().zip(&mut parts) {
            if sight.owner[at] < FLOOR {
                *part = Part::at(sight, scene, at);
            }
        }
        let mut spots = [Spot::BESIDE; BAND * BAND];
        let mut last = Corners::NONE;
        for ((([x, y], at), part), spot) in pixels().zip(&parts).zip(&mut spots) {
            let found = &mut self.found[slot(width, x, y)];
            *found = Found::NOTHING;
            if sight.owner[at] == NOTHING {
                continue;
            }
            let ray = studio.ray(x, y);
            let mut met = Met::floor(FLOOR_COLOUR);
            if sight.owner[at] < FLOOR {
                met = Met::new(sight, scene, at, ray, part, &mut last);
                keep(at, met.normal);
            }
            (found.normal, found.colour) = (met.normal, met.colour);
            match light.spot(studio.position(at, ray), &met) {
                Some(there) => *spot = there,
                None => found.seen = 0.0,
            }
        }
        for (([x, y], _), spot) in pixels().zip(&spots) {
            let found = &mut self.found[slot(width, x, y)];
            // What faces away has no place to be looked up.
            found.seen *= light.seen(spot);
        }
    }

    fn shade(&self, studio: Studio, rows: Range<usize>, rgba: &mut [u8]) {
        let width = studio.sight.view().size[0];
        for from in (0..width).step_by(BAND) {
            for [x, y] in square(&(from..width.min(from + BAND)), &rows) {
                let at = y * width + x;
                let open = f32::from(self.occlusion.open[at]) * (1.0 / 255.0);
                let found = &self.found[slot(width, x, y)];
                rgba[4 * at..][..4].copy_from_slice(&studio.pixel([x, y], found, open));
            }
        }
    }
}

/// What is found at a pixel.
#[derive(Clone, Copy)]
struct Found {
    normal: Vec3,
    colour: [f32; 3],
    /// How much of the lamp is seen from there.
    seen: f32,
}

impl Found {
    const NOTHING: Self = Self {
        normal: Vec3::Y,
        colour: FLOOR_COLOUR,
        seen: 1.0,
    };
}

/// The place of a pixel in the list of what is met.
fn slot(width: usize, x: usize, y: usize) -> usize {
    y % (2 * BAND) * width + x
}

/// The pixels of a square.
#[inline(always)]
fn square(columns: &Range<usize>, rows: &Range<usize>) -> impl Iterator<Item = [usize; 2]> {
    rows.clone()
        .flat_map(|y| columns.clone().map(move |x| [x, y]))
}

impl Studio<'_> {
    #[inline(always)]
    fn ray(&self, x: usize, y: usize) -> Vec3 {
        self.sight.view().ray(x as f32 + 0.5, y as f32 + 0.5)
    }

    /// Where what is seen at a pixel is.
    #[inline(always)]
    fn position(&self, at: usize, ray: Vec3) -> Vec3 {
        self.sight.view().eye + ray * (1.0 / self.sight.inverse[at])
    }

    #[inline(always)]
    fn pixel(&self, [x, y]: [usize; 2], found: &Found, open: f32) -> [u8; 4] {
        let view = self.sight.view();
        let at = y * view.size[0] + x;
        let ray = self.ray(x, y);
        let way = ray.normalize_or(Vec3::NEG_Y);
        let owner = self.sight.owner[at];
        if owner == NOTHING {
            let [r, g, b] = behind(self.backdrop, way, self.far).map(|v| (v + 0.5) as u8);
            let alpha = if self.backdrop == Backdrop::Nothing {
                0
            } else {
                255
            };
            return [r, g, b, alpha];
        }
        let depth = 1.0 / self.sight.inverse[at];
        let mut surfel = Surfel {
            position: self.position(at, ray),
            normal: found.normal,
            colour: found.colour,
            material: 0,
            open: 1.0,
        };
        let tone = self.light.tone();
        if owner == FLOOR {
            let lit = self.light.light(&surfel, found.seen, -way, open);
            let part = self.floor_part(surfel.position);
            let back = behind(Backdrop::Floor, way, self.far);
            let [r, g, b] = std::array::from_fn(|k| {
                let floor = f32::from(tone.screen(lit[k]));
                (back[k] + (floor - back[k]) * part + 0.5) as u8
            });
            return [r, g, b, 255];
        }
        let instance = &self.scene.instances[owner as usize];
        surfel.material = self.scene.bodies[instance.body as usize].material;
        if let Some(detail) = &self.scene.detail {
            detail.refine(&mut surfel, instance.id, depth / view.focal);
        }
        let open = if surfel.open < open {
            surfel.open
        } else {
            open
        };
        let [r, g, b] = self
            .light
            .light(&surfel, found.seen, -way, open)
            .map(|v| tone.screen(v));
        [r, g, b, 255]
    }

    fn floor_part(&self, at: Vec3) -> f32 {
        floor_part((at - self.ground.middle).length(), self.ground.radius)
    }
}

/// The colour on the screen of the floor where it fades, straight ahead, as the lamp lights it there.
pub(super) fn far_floor(light: &Lighting, view: &View, ground: &Ground) -> [f32; 3] {
    let flat = |v: Vec3, y: f32| Vec3::new(v.x, y, v.z);
    let away = flat(view.ahead, 0.0).normalize_or(Vec3::NEG_Z);
    let position = flat(ground.middle, ground.height) + away * end_of_floor(ground.radius);
    let surfel = Surfel {
        position,
        normal: Vec3::Y,
        colour: FLOOR_COLOUR,
        material: 0,
        open: 1.0,
    };
    let to_eye = (view.eye - position).normalize_or(Vec3::Y);
    let lit = light.light(&surfel, 1.0, to_eye, 1.0);
    lit.map(|v| f32::from(light.tone().screen(v)))
}

/// Finds where in a row the floor is seen.
pub(super) fn find_floor(sight: &mut Sight, ground: Ground, y: usize) {
    let view = *sight.view();
    for x in 0..view.size[0] {
        let at = y * view.size[0] + x;
        if sight.owner[at] != NOTHING {
            continue;
        }
        let ray = view.ray(x as f32 + 0.5, y as f32 + 0.5);
        let depth = (ground.height - view.eye.y) / ray.y;
        let met = view.eye + ray * depth;
        let is_near = || floor_part((met - ground.middle).length(), ground.radius) > 0.0;
        // Seen from below there is no floor.
        if ray.y < 0.0 && depth > view.near && is_near() {
            sight.owner[at] = FLOOR;
            sight.inverse[at] = 1.0 / depth;
        }
    }
}
