//! The cells placed so far, before any motion.

use super::cell_fields::CellFields;
use super::packing_domain::{MetricSpace, PackingDomain, SpatialHash};
use super::shape::CellShape;
use glam::DVec2;

/// The front takes a place if its nearest cell is at least this far, in stable distances.
pub(crate) const FRONT_GAP: f64 = 0.75;

/// The cells, with the spatial hash that finds them.
pub(crate) struct Placed<P, B> {
    pub cells: Vec<P>,
    shapes: Vec<CellShape>,
    grid: B,
    longest: f64,
}

impl<P: Copy, B: SpatialHash<P>> Placed<P, B> {
    pub fn new<G: PackingDomain<Place = P, Metric: MetricSpace<Hash = B>>>(ground: G) -> Self {
        Self {
            cells: Vec::new(),
            shapes: Vec::new(),
            grid: ground.metric().grid(ground.fields().mean_size()),
            longest: 0.0,
        }
    }

    pub fn push<A: CellFields<Place = P>>(&mut self, asked: A, p: P) {
        let shape = CellShape::metric_at(asked, p);
        self.cells.push(p);
        self.shapes.push(shape);
        self.grid.push(p);
        self.longest = self.longest.max(shape.length());
    }

    /// Puts a cell at the centre of each part that has none.
    pub fn fill_empty_parts<G: PackingDomain<Place = P, Metric: MetricSpace<Hash = B>>>(
        &mut self,
        ground: G,
    ) {
        for p in ground.empty_parts(&self.cells) {
            self.push(ground.fields(), p);
        }
    }

    /// The cells that may be nearer to a place than `far` stable distances, as offsets and shapes
    /// in its frame.
    pub fn beside<G: PackingDomain<Place = P, Metric: MetricSpace<Hash = B>>>(
        &self,
        ground: G,
        p: P,
        shape: &CellShape,
        far: f64,
    ) -> Vec<(DVec2, CellShape)> {
        let reach = far * 0.5 * (shape.length() + self.longest);
        let mut beside = Vec::with_capacity(8);
        ground.metric().any_near(&self.grid, p, reach, |k| {
            if let Some((r, turn)) = ground.metric().log_within(p, self.cells[k], reach) {
                beside.push((r, self.shapes[k].seen(turn)));
            }
            false
        });
        beside
    }

    /// Whether every cell is at least `gap` stable distances away from this place.
    pub fn is_free<G: PackingDomain<Place = P, Metric: MetricSpace<Hash = B>>>(
        &self,
        ground: G,
        p: P,
        gap: f64,
    ) -> bool {
        let shape = CellShape::metric_at(ground.fields(), p);
        let reach = gap * 0.5 * (shape.length() + self.longest);
        !ground.metric().any_near(&self.grid, p, reach, |k| {
            let Some((r, turn)) = ground.metric().log_within(p, self.cells[k], reach) else {
                return false;
            };
            shape.is_closer(&self.shapes[k].seen(turn), r, gap) && !ground.metric().is_parted(p, r)
        })
    }
}
