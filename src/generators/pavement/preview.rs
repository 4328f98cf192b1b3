//! The view of stones in progress. Until the picture is finished, stones are drawn over the cells in a plain light.

use super::Pavement;
use crate::cells::Cell;
use crate::draw::{self, Board, Sketch};
use crate::generators::Engine;
use crate::heightfield::{Planes, row_slopes};
use crate::order;
use glam::DVec2;

/// Stones in a simple light over the cells, until the picture is finished.
#[derive(Default)]
pub(super) struct Preview {
    board: Option<Board>,
    /// The pass of the planes' stage whose stones the board shows.
    pass: u64,
    stones: usize,
}

impl Pavement {
    /// Whether the preview already shows stones of the present pass.
    pub(super) fn goes_on(&self, preview: &Preview) -> bool {
        let board = preview.board.as_ref().filter(|b| b.fits(self.side()));
        board.is_some() && preview.pass == self.made.finish.planes.passes()
    }

    /// The cells on the ground, before there are stones.
    pub(super) fn bedded(&self) -> Option<Sketch> {
        let (planes, tones) = (self.ground_shown()?, self.tones());
        let mut board = Board::new(planes.side, tones.paper.surround);
        light_ground(planes, board.rgba_mut());
        let cells = draw::stages::cells(self.made.cells(), &tones);
        Some(self.on_board(board, &tones.paper, vec![cells]))
    }

    /// The cells with the stones painted so far. `bedded` is the board on which a new preview begins.
    pub(super) fn stones_coming(
        &self,
        preview: &mut Preview,
        bedded: Option<Board>,
    ) -> Option<Board> {
        let made = &self.made;
        let planes = self.ground_shown()?;
        if !self.goes_on(preview) {
            (preview.board, preview.stones) = (bedded, 0);
            preview.pass = made.finish.planes.passes();
        }
        let board = preview.board.as_mut()?;
        let stones = made.stones();
        for k in preview.stones..stones {
            light_stone(planes, &made.cells()[k], k, board.rgba_mut());
        }
        preview.stones = stones;
        Some(board.clone())
    }
}

/// Shows the ground in a plain light.
fn light_ground(planes: &Planes, rgba: &mut [u8]) {
    let side = planes.side;
    let mut slopes = [(); 2].map(|()| vec![0.0; side]);
    for (y, row) in rgba.chunks_exact_mut(4 * side).enumerate() {
        row_slopes(planes, y, &mut slopes);
        let [across, fall] = &slopes;
        let places = planes.colour[y * side..].iter().zip(across).zip(fall);
        for (pixel, ((&colour, &dx), &dy)) in row.chunks_exact_mut(4).zip(places) {
            let scale = 1.0 / (dx * dx + dy * dy + 1.0).sqrt();
            light_pixel(colour, [-dx * scale, -dy * scale, scale], pixel);
        }
    }
}

/// Shows one stone in a plain light.
fn light_stone(planes: &Planes, cell: &Cell, index: usize, rgba: &mut [u8]) {
    let side = planes.side;
    let reach = DVec2::splat(0.25 * cell.size + 1.0);
    let first = cell.ring.first().copied().unwrap_or(cell.centre);
    let (lo, hi) = cell
        .ring
        .iter()
        .fold((first, first), |(lo, hi), &p| (lo.min(p), hi.max(p)));
    let clip = |v: f64| v.clamp(0.0, side as f64) as usize;
    let (lo, hi) = (lo - reach, hi + reach);
    for y in clip(lo.y)..clip(hi.y) {
        for x in clip(lo.x)..clip(hi.x) {
            if planes.id[y * side + x] == index as u32 + 1 {
                let at = y * side + x;
                let normal = draw::planes::normal(planes, x, y);
                light_pixel(planes.colour[at], normal, &mut rgba[4 * at..]);
            }
        }
    }
}

/// Light from the upper left. On level ground it is as strong as in a finished picture.
fn light_pixel(colour: [u8; 3], n: [f32; 3], pixel: &mut [u8]) {
    let facing = order::greater(-0.42 * n[0] - 0.48 * n[1] + 0.77 * n[2], 0.0);
    let light = 0.42 + 0.80 * facing;
    for (shown, colour) in pixel.iter_mut().zip(colour) {
        *shown = order::lesser(f32::from(colour) * light, 255.0) as u8;
    }
}
