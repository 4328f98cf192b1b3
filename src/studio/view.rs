//! What can be looked at, as pictures of the recipe's size.

use super::look::{Base, View};
use super::{Position, Studio, translate};
use crate::cells::Cell;
use crate::export::{MapKind, maps};
use crate::order;
use crate::recipe::Stage;
use crate::render::overlay::{Board, Paper};
use crate::render::overlay_tones::{SHEET, Tones};
use crate::render::{
    overlay_field, overlay_planes, overlay_potential, overlay_size, overlay_stages, row_slopes,
};
use crate::texture::Planes;
use glam::DVec2;

/// The frame last drawn, and what the next one can be made from.
#[derive(Default)]
pub(super) struct Gallery {
    frame: Option<Board>,
    drawn: Option<(Base, u64)>,
    preview: Preview,
    /// The frame with overlays.
    over: Option<Board>,
    drawn_over: Option<(View, u64)>,
    veil: overlay_size::Veil,
}

/// Stones in a simple light over the cells, while the picture is not there.
#[derive(Default)]
struct Preview {
    board: Option<Board>,
    /// Which pass over the stones it shows.
    pass: u64,
    stones: usize,
}

impl Studio {
    /// The picture of a view: opaque RGBA, [`Studio::side`] pixels a side, row after row from the
    /// top. While a stage has nothing to show yet, what was there before, or the bare outline.
    pub fn view(&mut self, view: View) -> &[u8] {
        let stamp: u64 = self.changes.iter().sum();
        let mut gallery = std::mem::take(&mut self.gallery);
        let side = self.side();
        gallery.frame = gallery.frame.filter(|board| board.fits(side));
        if gallery.drawn != Some((view.base, stamp)) || gallery.frame.is_none() {
            self.draw(view.base, &mut gallery);
            gallery.drawn = Some((view.base, stamp));
            gallery.drawn_over = None;
        }
        if view.is_plain() {
            (gallery.over, gallery.drawn_over) = (None, None);
        } else if gallery.drawn_over != Some((view, stamp)) {
            let mut board = gallery.frame.clone();
            if let Some(board) = &mut board {
                self.draw_over(view, board, &mut gallery.veil);
            }
            gallery.over = board;
            gallery.drawn_over = Some((view, stamp));
        }
        self.gallery = gallery;
        let shown = self.gallery.over.as_ref().or(self.gallery.frame.as_ref());
        shown.map_or(&[], Board::rgba)
    }

    /// Draws a new frame, or leaves the last one where it should stay.
    fn draw(&self, base: Base, gallery: &mut Gallery) {
        let made = &self.made;
        let planes = self.planes_to_show();
        let of_planes = |draw: fn(&Planes) -> Vec<u8>| {
            let mut board = Board::new(self.side(), SHEET.surround);
            match planes {
                Some(planes) => board.show(&draw(planes)),
                None => return self.bare(),
            }
            board
        };
        gallery.frame = Some(match base {
            Base::Auto | Base::Picture => return self.unfold(base, gallery),
            Base::Paper => self.on_paper(&SHEET, |_| {}),
            Base::Packed => self.packed(),
            Base::Cells | Base::Mesh if self.draft().is_some() => self.packed(),
            Base::Cells => {
                let tones = self.tones();
                self.on_paper(&tones.paper, |board| {
                    overlay_stages::cells(board, &made.cells, &tones);
                    self.lines(board);
                })
            }
            Base::Mesh => self.on_paper(&SHEET, |board| {
                if let (Some(mesh), Some(fields)) = (&made.mesh, &made.fields) {
                    overlay_stages::mesh(board, mesh, fields);
                }
                self.lines(board);
            }),
            Base::Direction => self.on_paper(&SHEET, |board| {
                let shown = self.shown();
                if let (Some(domain), Some(fields)) = (shown.domain, shown.fields) {
                    overlay_field::direction(board, domain, fields, self.side() as f64);
                }
            }),
            Base::Potential => {
                let mut board = Board::new(self.side(), SHEET.bed);
                let (kind, aspect) = translate::kind(&self.working);
                overlay_potential::potential(&mut board, kind, aspect, self.side() as f64);
                board
            }
            Base::Height => of_planes(overlay_planes::height),
            Base::Normals => of_planes(overlay_planes::normals),
            Base::Ids => of_planes(overlay_planes::ids),
            Base::Albedo => self.map_shown(MapKind::Albedo),
            Base::Roughness => self.map_shown(MapKind::Roughness),
            Base::Occlusion => self.map_shown(MapKind::Occlusion),
        });
    }

    /// A map as it is handed out, of the planes there are.
    fn map_shown(&self, kind: MapKind) -> Board {
        let Some(planes) = self.planes_to_show() else {
            return self.bare();
        };
        let mut board = Board::new(self.side(), SHEET.surround);
        let optics = translate::optics(&self.working);
        let shininess = translate::shading(&self.working).shininess;
        let map = maps::map(kind, planes, &optics, shininess);
        board.show(&map.rgba());
        board
    }

    /// The planes to look at: the finished ones unless they are of another pavement.
    fn planes_to_show(&self) -> Option<&Planes> {
        let finished = self.made.planes.as_ref();
        let finished = finished.filter(|p| p.side == self.side());
        let coming = self.made.painter.as_ref().map(|p| p.planes());
        if self.made.forming {
            coming.or(finished)
        } else {
            finished.or(coming)
        }
    }

    /// The way from the packing to the picture.
    fn unfold(&self, base: Base, gallery: &mut Gallery) {
        let made = &self.made;
        let side = self.side();
        if base == Base::Auto && self.draft().is_some() {
            gallery.frame = Some(self.packed());
            return;
        }
        let picture = made.picture.len() == 4 * side * side;
        let settled = !made.forming || matches!(self.at, Position::Failed(..));
        if picture && (settled || base == Base::Picture) {
            let frame = gallery.frame.take();
            let mut board = frame.unwrap_or_else(|| Board::new(side, SHEET.surround));
            board.show(&made.picture);
            gallery.frame = Some(board);
            return;
        }
        match self.at {
            Position::At(stage) if stage >= Stage::Solids => {
                gallery.frame = Some(self.stones_coming(&mut gallery.preview));
            }
            _ if made.packing_begun => gallery.frame = Some(self.packed()),
            // Nothing new to see for a moment: what was there stays.
            _ if gallery.frame.is_some() => {}
            _ => gallery.frame = Some(self.bare()),
        }
    }

    pub(super) fn tones(&self) -> Tones {
        if let Some(draft) = self.draft() {
            return draft.tones.clone();
        }
        let made = &self.made;
        Tones::new(&translate::texture(&self.working)).wearing(&made.cells, &made.coats)
    }

    fn on_paper(&self, paper: &Paper, draw: impl FnOnce(&mut Board)) -> Board {
        let mut board = Board::new(self.side(), paper.surround);
        self.bed(&mut board, paper);
        draw(&mut board);
        board
    }

    /// The area to pave: the outline, or all of a tile.
    fn bed(&self, board: &mut Board, paper: &Paper) {
        if self.working.is_tile() {
            board.repeat();
            let side = self.side() as f64;
            let all = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|p| side * p);
            board.fill(&[&all], paper.bed, 0.0);
        } else {
            board.outline(&self.shown().rings, paper);
        }
    }

    fn lines(&self, board: &mut Board) {
        if let Some(domain) = self.shown().domain {
            overlay_stages::lines(board, domain, self.side() as f64);
        }
    }

    fn bare(&self) -> Board {
        self.on_paper(&self.tones().paper, |_| {})
    }

    fn packed(&self) -> Board {
        let shown = self.shown();
        let (Some(packing), Some(domain)) = (shown.packing, shown.domain) else {
            return self.bare();
        };
        let tones = self.tones();
        self.on_paper(&tones.paper, |board| {
            overlay_stages::packed(board, domain, &packing.particles(), &tones);
            self.lines(board);
        })
    }

    /// The cells with the stones so far on them.
    fn stones_coming(&self, preview: &mut Preview) -> Board {
        let made = &self.made;
        let tones = self.tones();
        let planes = self.planes_to_show().filter(|_| made.bedded);
        let Some(planes) = planes else {
            return self.on_paper(&tones.paper, |board| {
                overlay_stages::cells(board, &made.cells, &tones);
            });
        };
        let old = preview.board.take().filter(|b| b.fits(planes.side));
        let mut board = match old {
            Some(board) if preview.pass == made.pass => board,
            _ => {
                preview.stones = 0;
                let mut board = Board::new(planes.side, tones.paper.surround);
                light_ground(planes, board.rgba_mut());
                self.bed(&mut board, &tones.paper);
                overlay_stages::cells(&mut board, &made.cells, &tones);
                board
            }
        };
        preview.pass = made.pass;
        for k in preview.stones..made.stones {
            light_stone(planes, &made.cells[k], k, board.rgba_mut());
        }
        preview.stones = made.stones;
        preview.board = Some(board.clone());
        board
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
    let clip = |v: f64| order::within(v, 0.0, side as f64) as usize;
    let (lo, hi) = (lo - reach, hi + reach);
    for y in clip(lo.y)..clip(hi.y) {
        for x in clip(lo.x)..clip(hi.x) {
            if planes.id[y * side + x] == index as u32 + 1 {
                let at = y * side + x;
                let normal = overlay_planes::normal(planes, x, y);
                light_pixel(planes.colour[at], normal, &mut rgba[4 * at..]);
            }
        }
    }
}

/// Light from the upper left, as strong on level ground as in a finished picture.
fn light_pixel(colour: [u8; 3], n: [f32; 3], pixel: &mut [u8]) {
    let facing = order::greater(-0.42 * n[0] - 0.48 * n[1] + 0.77 * n[2], 0.0);
    let light = 0.42 + 0.80 * facing;
    for (shown, colour) in pixel.iter_mut().zip(colour) {
        *shown = order::lesser(f32::from(colour) * light, 255.0) as u8;
    }
}
