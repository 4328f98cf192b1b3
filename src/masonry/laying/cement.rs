//! Cast stones of cement along the top edges of steps, with bricks between them (Legakis, Dorsey, Gortler 2001,
//! section 5.5, fig. 8b). Their upright sides are rough, their treads smooth.

use super::bricks::BrickBond;
use super::cell::{CellDraft, CellSort, Feature};
use super::run::Run;
use super::site::Site;
use crate::building::{CornerId, EdgeId};
use crate::masonry::block::Polyhedron;
use crate::masonry::plan::pieces;
use crate::masonry::tree::GeneratorNode;
use glam::{DVec2, DVec3};

/// The columns that a corner's stone reaches along both walls.
const CORNER: usize = 3;
/// How far stones reach behind the edge, in modules.
const DEEP: f64 = 2.0;

/// The bond of single blocks, for upright edges and for corners without a cast stone.
const BLOCK: BrickBond = BrickBond {
    sort: CellSort::Stone,
    ..BrickBond::BRICKS
};

impl Site {
    /// Lays the stone of a corner, which shows three sides. Corners that are no free top corners get a single block.
    pub fn cement_corner(&mut self, id: CornerId, node: &GeneratorNode) {
        let top = self
            .top_corner(id, false)
            .map(|top| (top.reaches(CORNER), top));
        let Some(([a, b], top)) = top.filter(|(reaches, top)| self.is_top_free(top, *reaches))
        else {
            return self.brick_corner(id, node, &BLOCK);
        };
        let corners = [[0.0, 0.0], [a, 0.0], [a, b], [0.0, b]].map(DVec2::from);
        let fronts = top.fronts();
        let mut draft = cast(node, top.body(&corners), fronts[0]);
        draft.fronts = fronts;
        self.place(Feature::Corner(id), node, draft);
    }

    /// Lays the stones of an edge: long ones where it is level, one in each course where it is upright.
    pub fn cement_edge(&mut self, id: EdgeId, node: &GeneratorNode) {
        self.upright_bricks(id, node, &BLOCK);
        let module = self.plan.module.half;
        let length = module * node.number("length");
        for run in self.runs(id).into_iter().filter(|run| !run.is_upright) {
            for span in self.level_spans(&run, length) {
                let (body, front) = self.level_body(&run, span, DEEP * module);
                self.place(Feature::Edge(id), node, cast(node, body, front));
            }
        }
    }

    /// The body on a part of a level run, a row high on its first face and at most `deepest` deep (metres), and the
    /// direction in which that face looks.
    pub fn level_body(&self, run: &Run, span: [f64; 2], deepest: f64) -> (Polyhedron, DVec3) {
        let middle = 0.5 * (span[0] + span[1]);
        let height = self.limited_reach(run, 0, 1, middle);
        let depth = self.limited_depth(run, deepest, middle);
        let body = self.edge_body(run, span, [height, depth]);
        let front = &run.sides[0];
        (body, self.normal(front.face, front.at(middle)))
    }

    /// The free parts of a run in pieces of equal length, as near as possible to the wanted one (metres).
    pub fn level_spans(&self, run: &Run, length: f64) -> Vec<[f64; 2]> {
        let free = self.free(run).into_iter();
        let spans = free.flat_map(|[from, to]| {
            let count = pieces(to - from, length);
            let at = move |k: usize| from + (to - from) * k as f64 / count as f64;
            (0..count).map(move |k| [at(k), at(k + 1)])
        });
        spans.collect()
    }
}

/// A cast stone: the polygons of its upright sides are marked as rough.
fn cast(node: &GeneratorNode, body: Polyhedron, front: DVec3) -> CellDraft {
    let roughness = node.number("roughness");
    let body = body.with_roughness(|plane| match plane.normal.y.abs() < 0.5 {
        true => roughness,
        false => 0.0,
    });
    let mut draft = CellDraft::new(CellSort::Stone, body, front);
    draft.extrude = node.number("extrude");
    draft
}
