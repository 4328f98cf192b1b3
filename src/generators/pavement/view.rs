//! Views as pictures of the recipe's size, and drawings with more pixels.

use super::files::map_of;
use super::look::{Base, Overlay, PavementView};
use super::preview::Preview;
use super::{Pavement, Stage};
use crate::draw::{self, Board, Layer, Paper, SHEET, Sketch, Tones};
use crate::export::MapKind;
use crate::generators::{Budget, Clock, Engine};
use crate::graph::Wiring;
use crate::heightfield::Planes;
use glam::DVec2;

/// Most pixels along the side of a drawing that is larger than the recipe's picture. Two such drawings take 32 MiB.
const MOST_SIDE: usize = 2048;

/// Pixels along a unit, the base, and the state of the pavement that it is drawn from.
type DrawnKey = (usize, Base, u64);

/// The last frame, and the data for the next one.
#[derive(Default)]
pub(super) struct Gallery {
    frame: Option<Board>,
    drawn: Option<DrawnKey>,
    /// The unfinished drawing of the next frame, with its key.
    begun: Option<((DrawnKey, ProgressView), Sketch)>,
    preview: Preview,
    /// The frame with overlays. `begun_over` is an unfinished one; each has a key of view and stamp.
    over: Option<Board>,
    begun_over: Option<((PavementView, u64), Sketch)>,
    drawn_over: Option<(PavementView, u64)>,
    heat: draw::size::HeatMap,
}

/// The content of the view between the packing and the picture.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ProgressView {
    /// Only the outline so far.
    Bare,
    Packed,
    /// Nothing new for a moment: the last frame stays.
    Stays,
    /// The cells' polygons, before the ground is laid.
    Cells,
    /// The stones painted so far, over the cells.
    Stones,
    Picture,
}

impl Pavement {
    /// The picture of a view. While a stage has nothing to show yet, the last picture stays, or the bare outline is
    /// shown. A drawing has the pixels that are asked for, up to a limit. A picture has the recipe's pixels; it is
    /// enlarged if overlays with more pixels lie over it.
    pub(super) fn look_at(&mut self, view: PavementView) -> &[u8] {
        let of = (view, self.stamp());
        let mut gallery = std::mem::take(&mut self.gallery);
        self.draw_base(self.key(view), &mut gallery);
        if view.is_plain() {
            (gallery.over, gallery.begun_over, gallery.drawn_over) = (None, None, None);
        } else if gallery.drawn_over != Some(of) {
            let sketch = self.begin_over(of, &mut gallery);
            gallery.over = sketch.map(Sketch::finish);
            gallery.drawn_over = Some(of);
        }
        self.gallery = gallery;
        let shown = self.gallery.over.as_ref().or(self.gallery.frame.as_ref());
        shown.map_or(&[], Board::rgba)
    }

    /// Draws the base, unless the frame shows it already.
    fn draw_base(&self, key: DrawnKey, gallery: &mut Gallery) {
        let side = self.side();
        let fits = |board: &Board| board.fits(side) && key.0.is_multiple_of(board.scale());
        gallery.frame = gallery.frame.take().filter(fits);
        if gallery.drawn != Some(key) || gallery.frame.is_none() {
            let sketch = self.sketch(key, gallery);
            self.draw(key, gallery, sketch);
            gallery.drawn = Some(key);
            gallery.drawn_over = None;
        }
    }

    /// The drawing of a view's overlays on its base: the one begun with this key, or a new one.
    fn begin_over(&mut self, of: (PavementView, u64), gallery: &mut Gallery) -> Option<Sketch> {
        match gallery.begun_over.take() {
            Some((begun, sketch)) if begun == of => Some(sketch),
            _ => {
                let board = gallery.frame.as_ref()?.enlarged(self.key(of.0).0);
                Some(self.sketch_over(of.0, board, &mut gallery.heat))
            }
        }
    }

    /// Draws pieces of the base in advance, then of the overlays; true when both are ready. If the pavement changes in
    /// between, the drawing starts again.
    pub(super) fn draw_beforehand(
        &mut self,
        view: PavementView,
        clock: Clock,
        budget: f64,
    ) -> bool {
        let budget = Budget::new(clock, budget);
        let mut gallery = std::mem::take(&mut self.gallery);
        let key = self.key(view);
        let way = self.way(view.base, &gallery);
        let mut sketch = match gallery.drawn == Some(key) {
            true => None,
            false => self.sketch(key, &mut gallery),
        };
        let mut ready = sketch
            .as_mut()
            .is_none_or(|sketch| budget.until(clock, || sketch.advance()));
        gallery.begun = sketch.map(|sketch| ((key, way), sketch));
        let of = (view, key.2);
        if ready && !view.is_plain() && gallery.drawn_over != Some(of) {
            self.draw_base(key, &mut gallery);
            let sketch = self.begin_over(of, &mut gallery);
            gallery.begun_over = sketch.map(|mut sketch| {
                ready = budget.until(clock, || sketch.advance());
                (of, sketch)
            });
        }
        self.gallery = gallery;
        ready
    }

    /// Changes whenever views may change.
    pub(super) fn stamp(&self) -> u64 {
        self.changes + self.made.slices()
    }

    /// The key of a view's base. Views with sizes have the recipe's pixels only. A potential is computed in one slice,
    /// which must be short, so it has at most 2 pixels along a unit.
    fn key(&self, view: PavementView) -> DrawnKey {
        let most = match view.base {
            _ if view.has(Overlay::Size) => 1,
            Base::Potential => 2,
            _ => (MOST_SIDE / self.side()).max(1),
        };
        (most.min(view.scale.into()), view.base, self.stamp())
    }

    /// The drawing of a base: the one begun with this key, or a new one; `None` if the base is not a drawing.
    fn sketch(&self, key: DrawnKey, gallery: &mut Gallery) -> Option<Sketch> {
        let way = self.way(key.1, gallery);
        match gallery.begun.take() {
            Some((of, sketch)) if of == (key, way) => Some(sketch),
            _ => self.new_sketch(key, gallery),
        }
    }

    fn new_sketch(&self, (scale, base, _): DrawnKey, gallery: &Gallery) -> Option<Sketch> {
        let made = &self.made;
        Some(match base {
            Base::Auto | Base::Picture => match self.way(base, gallery) {
                ProgressView::Bare => self.bare(scale),
                ProgressView::Packed => self.packed(scale),
                ProgressView::Cells => {
                    let tones = self.tones();
                    let cells = draw::stages::cells(made.cells(), &tones);
                    self.on_paper(scale, &tones.paper, vec![cells])
                }
                ProgressView::Stones if !self.goes_on(&gallery.preview) => self.bedded()?,
                ProgressView::Stones | ProgressView::Stays | ProgressView::Picture => return None,
            },
            Base::Paper => self.on_paper(scale, &SHEET, Vec::new()),
            Base::Packed => self.packed(scale),
            Base::Cells | Base::Mesh if self.draft().is_some() => self.packed(scale),
            Base::Cells => {
                let tones = self.tones();
                let mut layers = vec![draw::stages::cells(made.cells(), &tones)];
                layers.extend(self.lines());
                self.on_paper(scale, &tones.paper, layers)
            }
            Base::Mesh => {
                let both = made.mesh().zip(made.fields.made());
                let mesh = both.map(|(mesh, fields)| draw::stages::mesh(mesh, fields));
                let mut layers = Vec::from_iter(mesh);
                layers.extend(self.lines());
                self.on_paper(scale, &SHEET, layers)
            }
            _ => return None,
        })
    }

    /// Draws a new frame, or keeps the last one if it should stay.
    fn draw(&self, (scale, base, _): DrawnKey, gallery: &mut Gallery, sketch: Option<Sketch>) {
        let planes = self.planes_to_show();
        let of_planes = |draw: fn(&Planes) -> Vec<u8>| {
            let mut board = Board::new(self.side(), SHEET.surround);
            match planes {
                Some(planes) => board.show(&draw(planes)),
                None => return self.bare(scale).finish(),
            }
            board
        };
        let sketched = sketch.map(Sketch::finish);
        gallery.frame = match base {
            Base::Auto | Base::Picture => match self.way(base, gallery) {
                ProgressView::Picture => Some(self.picture_on(gallery.frame.take())),
                ProgressView::Stones => self.stones_coming(&mut gallery.preview, sketched),
                ProgressView::Stays => return,
                ProgressView::Bare | ProgressView::Packed | ProgressView::Cells => sketched,
            },
            Base::Paper | Base::Packed | Base::Cells | Base::Mesh => sketched,
            Base::Direction => {
                let mut board = self.on_paper(scale, &SHEET, Vec::new()).finish();
                let shown = self.shown();
                if let (Some(domain), Some(fields)) = (shown.domain, shown.fields) {
                    let side = self.side() as f64;
                    board.draw(&draw::field::direction(domain, fields, side));
                }
                Some(board)
            }
            Base::Potential => {
                let mut board = Board::scaled(self.side(), scale, SHEET.bed);
                let asked = self.made.fields.params();
                draw::potential::potential(
                    &mut board,
                    asked.kind,
                    asked.aspect,
                    (
                        self.made.packing.params().physics.corners,
                        self.side() as f64,
                    ),
                );
                Some(board)
            }
            Base::Height => Some(of_planes(draw::planes::height)),
            Base::Normals => Some(of_planes(draw::planes::normals)),
            Base::Ids => Some(of_planes(draw::planes::ids)),
            Base::Albedo => Some(self.map_shown(MapKind::Albedo)),
            Base::Roughness => Some(self.map_shown(MapKind::Roughness)),
            Base::Occlusion => Some(self.map_shown(MapKind::Occlusion)),
        };
    }

    /// A map of the present planes.
    fn map_shown(&self, kind: MapKind) -> Board {
        let Some(planes) = self.planes_to_show() else {
            return self.bare(1).finish();
        };
        let mut board = Board::new(self.side(), SHEET.surround);
        let map = map_of(kind, planes, self.light());
        board.show(&map.rgba());
        board
    }

    /// The planes to show: the finished ones; but while another pavement forms, the unfinished ones, if any exist.
    pub(super) fn planes_to_show(&self) -> Option<&Planes> {
        let finished = self.made.planes();
        let finished = finished.filter(|p| p.side == self.side());
        let coming = self.made.planes_coming();
        if self.made.is_forming() {
            coming.or(finished)
        } else {
            finished.or(coming)
        }
    }

    /// The content of the view between the packing and the picture.
    fn way(&self, base: Base, gallery: &Gallery) -> ProgressView {
        let made = &self.made;
        if base == Base::Auto && self.draft().is_some() {
            return ProgressView::Packed;
        }
        let picture = made.picture().len() == 4 * self.side() * self.side();
        let settled = !made.is_forming() || made.failure().is_some();
        if picture && (settled || base == Base::Picture) {
            return ProgressView::Picture;
        }
        match self.made.at().filter(|_| made.failure().is_none()) {
            Some(stage) if stage >= Stage::Planes => match self.ground_shown() {
                Some(_) => ProgressView::Stones,
                None => ProgressView::Cells,
            },
            _ if made.is_packing() => ProgressView::Packed,
            _ if gallery.frame.is_some() => ProgressView::Stays,
            _ => ProgressView::Bare,
        }
    }

    fn picture_on(&self, frame: Option<Board>) -> Board {
        let frame = frame.filter(|board| board.scale() == 1);
        let mut board = frame.unwrap_or_else(|| Board::new(self.side(), SHEET.surround));
        board.show(self.made.picture());
        board
    }

    /// The planes in progress, once the ground is laid.
    pub(super) fn ground_shown(&self) -> Option<&Planes> {
        self.planes_to_show().filter(|_| self.made.is_bedded())
    }

    pub(super) fn tones(&self) -> Tones {
        if let Some(draft) = self.draft() {
            return draft.tones.clone();
        }
        let made = &self.made;
        let texture = self.texture();
        Tones::new(texture).wearing(made.cells(), made.coats())
    }

    /// Layers over the area to pave: the outline, or the whole of a tile.
    fn on_paper(&self, scale: usize, paper: &Paper, layers: Vec<Layer>) -> Sketch {
        let board = Board::scaled(self.side(), scale, paper.surround);
        self.on_board(board, paper, layers)
    }

    pub(super) fn on_board(&self, mut board: Board, paper: &Paper, layers: Vec<Layer>) -> Sketch {
        let mut all = Vec::with_capacity(layers.len() + 2);
        if self.texture().tile {
            board.repeat();
            let side = self.side() as f64;
            let ring = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|p| side * p);
            all.push(Layer::fill(vec![ring.to_vec()], paper.bed, 0.0));
        } else {
            all.push(draw::stages::bed(&self.shown().rings, paper));
        }
        all.extend(layers);
        Sketch::new(board, all)
    }

    fn lines(&self) -> Option<Layer> {
        let domain = self.shown().domain?;
        Some(draw::stages::lines(domain, self.side() as f64))
    }

    fn bare(&self, scale: usize) -> Sketch {
        self.on_paper(scale, &self.tones().paper, Vec::new())
    }

    fn packed(&self, scale: usize) -> Sketch {
        let shown = self.shown();
        let (Some(packing), Some(domain)) = (shown.packing, shown.domain) else {
            return self.bare(scale);
        };
        let tones = self.tones();
        let packed = draw::stages::packed(domain, &packing.particles(), &tones, scale);
        let mut layers = vec![packed];
        layers.extend(self.lines());
        self.on_paper(scale, &tones.paper, layers)
    }
}
