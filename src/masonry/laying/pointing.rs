//! Which way the bricks of upright edges point, for drawing (Legakis, Dorsey, Gortler 2001, section 5.2).

use super::Laying;
use super::run::Run;
use crate::building::{EdgeId, FaceId};
use crate::masonry::footprint::Footprint;
use crate::masonry::plan::is_wall;

/// A row of an upright edge between two walls.
#[derive(Clone, Debug, PartialEq)]
pub struct Pointing {
    /// The edge.
    pub edge: EdgeId,
    /// The two walls, each with the place of the row's brick on it. The first one shows the stretcher.
    pub sides: [(FaceId, Footprint); 2],
}

impl Laying {
    /// The rows of all upright convex edges between two walls, edge by edge: a stretcher of two columns on one wall,
    /// and a header of one column on the other.
    pub fn pointings(&self) -> Vec<Pointing> {
        let edges = self.building().edge_ids();
        edges
            .flat_map(|edge| self.site.runs(edge))
            .filter(|run| {
                let faces = run.sides.iter().map(|side| self.site.face(side.face));
                run.is_upright && faces.clone().all(is_wall)
            })
            .flat_map(|run| self.rows(&run))
            .collect()
    }

    fn rows(&self, run: &Run) -> Vec<Pointing> {
        let rows = self.site.intervals(run).into_iter();
        rows.filter_map(|(row, span)| {
            let long = self.site.long_side(run, row, self.params.is_by_hand);
            let place = |k: usize, count: usize| {
                let side = &run.sides[k];
                let middle = 0.5 * (span[0] + span[1]);
                let off = side.inwards * self.site.limited_reach(run, k, count, middle);
                let [a, b] = span.map(|along| side.at(along));
                Some((side.face, Footprint::hull(&[a, b, b + off, a + off])?))
            };
            Some(Pointing {
                edge: run.edge,
                sides: [place(long, 2)?, place(1 - long, 1)?],
            })
        })
        .collect()
    }
}
