//! How the stages of a pavement hang together, and what is due next.

use super::params::{CellParams, CoatParams, FlowParams, Params};
use super::slices::{Packed, Packs, Shaping};
use super::stage::Stage;
use super::terrain::Terrain;
use crate::cells::{Cell, Graph};
use crate::generators::height_field::{Bodies, Finish, HeightField, Revisions};
use crate::graph::{Node, State};
use crate::material::{Coat, Coats};
use crate::mesh::{Mesh, Meshing};
use crate::notice::Notice;
use crate::packing::{Packing, PackingParams};
use crate::solid::oriented;

/// Cells whose neighbours are found, or whose coats are made, in one slice.
const CELLS: usize = 500;

/// The stages.
pub(super) struct Stages {
    pub terrain: Terrain,
    pub(super) packing: Node<PackingParams, Packs, Packing>,
    pub(super) mesh: Node<(), Meshing, Mesh>,
    pub(super) cells: Node<CellParams, Shaping, Vec<Cell>>,
    /// Of skin, the cells in which the axes have one sense; none of stones.
    pub(super) flow: Node<Option<FlowParams>, Graph, Vec<Cell>>,
    pub(super) coats: Node<CoatParams, Coats, Vec<Coat>>,
    pub finish: HeightField,
    /// Of which packing the picture is.
    pub(super) pictured: u64,
}

/// A piece of the work. A stage has several where it needs more than one product.
#[derive(Clone, Copy)]
enum Task {
    Terrain(Stage),
    Pack,
    Mesh,
    Cells,
    Flow,
    Coats,
    Finish(Finish),
}

impl Task {
    fn stage(self) -> Stage {
        match self {
            Task::Terrain(stage) => stage,
            Task::Finish(stage) => stage.into(),
            Task::Pack => Stage::Packing,
            Task::Mesh => Stage::Mesh,
            Task::Cells => Stage::Cells,
            Task::Flow | Task::Coats => Stage::Planes,
        }
    }
}

impl Stages {
    /// Nothing made yet.
    pub fn new(params: Params) -> Self {
        Self {
            terrain: Terrain::new(params.terrain),
            packing: Node::new(params.packing),
            mesh: Node::new(()),
            cells: Node::new(params.cells),
            flow: Node::new(params.flow),
            coats: Node::new(params.coats),
            finish: HeightField::new(params.finish),
            pictured: 0,
        }
    }

    /// What the stages are to be made by from now on.
    pub fn want(&mut self, params: Params) {
        self.terrain.want(params.terrain);
        self.packing.want(params.packing);
        self.cells.want(params.cells);
        self.flow.want(params.flow);
        self.coats.want(params.coats);
        self.finish.want(params.finish);
    }

    /// All stages are to run again.
    pub fn forget(&mut self) {
        self.terrain.domain.forget();
    }

    fn packed_inputs(&self) -> u64 {
        self.terrain.revision() + self.packing.revision()
    }

    pub(super) fn cell_inputs(&self) -> u64 {
        self.terrain.domain.revision() + self.cells.revision()
    }

    pub(super) fn finish_inputs(&self) -> Revisions {
        Revisions {
            domain: self.terrain.domain.revision(),
            cells: self.cells.revision() + self.flow.revision() + self.coats.revision(),
        }
    }

    /// The first piece of the work that is not fresh.
    fn due(&self) -> Option<(Task, State)> {
        let middle = || {
            let states = [
                (Task::Pack, self.packing.state(self.terrain.revision())),
                (Task::Mesh, self.mesh.state(self.packed_inputs())),
                (Task::Cells, self.cells.state(self.packed_inputs())),
                (Task::Flow, self.flow.state(self.cell_inputs())),
                (Task::Coats, self.coats.state(self.cell_inputs())),
            ];
            let mut states = states.into_iter();
            states.find(|&(_, state)| state != State::Fresh)
        };
        let first = self.terrain.due();
        let first = first.map(|(stage, state)| (Task::Terrain(stage), state));
        let last = || {
            let last = self.finish.due(self.finish_inputs());
            last.map(|(stage, state)| (Task::Finish(stage), state))
        };
        first.or_else(middle).or_else(last)
    }

    /// The stage that is not fresh; none where all is done.
    pub fn at(&self) -> Option<Stage> {
        self.due().map(|(task, _)| task.stage())
    }

    /// Why the stage at work cannot go on.
    pub fn failure(&self) -> Option<&Notice> {
        let (task, _) = self.due().filter(|&(_, state)| state == State::Failed)?;
        match task {
            Task::Terrain(_) => None,
            Task::Pack => self.packing.failure(),
            Task::Mesh => self.mesh.failure(),
            Task::Cells => self.cells.failure(),
            Task::Flow => self.flow.failure(),
            Task::Coats => self.coats.failure(),
            Task::Finish(_) => self.finish.failure(),
        }
    }

    /// One slice of the first piece that is not fresh.
    pub fn advance(&mut self) {
        match self.due() {
            None | Some((_, State::Failed)) => {}
            Some((Task::Terrain(stage), _)) => self.terrain.advance(stage),
            Some((Task::Pack, _)) => self.make_packing(),
            Some((Task::Mesh, _)) => self.make_mesh(),
            Some((Task::Cells, _)) => self.make_cells(),
            Some((Task::Flow, _)) => self.make_flow(),
            Some((Task::Coats, _)) => self.make_coats(),
            Some((Task::Finish(stage), _)) => self.make_picture(stage),
        }
    }

    fn make_packing(&mut self) {
        let Some((domain, fields)) = self.terrain.made() else {
            return;
        };
        let inputs = self.terrain.revision();
        self.packing.advance(inputs, |params, work| {
            Packs::advance(params, work, domain, fields)
        });
    }

    fn make_mesh(&mut self) {
        let (Some(domain), Some(packing)) = (self.terrain.domain.made(), self.packing.made())
        else {
            return;
        };
        let inputs = self.terrain.revision() + self.packing.revision();
        self.mesh.advance(inputs, |(), work| {
            let new = || Meshing::new(domain, packing.particles());
            Ok(work.get_or_insert_with(new).advance(domain))
        });
    }

    fn make_cells(&mut self) {
        let (Some((domain, fields)), Some(packing)) = (self.terrain.made(), self.packing.made())
        else {
            return;
        };
        let inputs = self.terrain.revision() + self.packing.revision();
        let from = Packed {
            domain,
            fields,
            packing,
        };
        self.cells
            .advance(inputs, |params, work| Shaping::advance(params, work, from));
    }

    fn make_flow(&mut self) {
        let (Some(domain), Some(cells)) = (self.terrain.domain.made(), self.cells.made()) else {
            return;
        };
        let inputs = self.terrain.domain.revision() + self.cells.revision();
        self.flow.advance(inputs, |params, work| {
            let Some(flow) = params else {
                return Ok(Some(Vec::new()));
            };
            work.get_or_insert_with(|| Graph::new(domain, cells));
            let over = work.take_if(|graph| graph.advance(domain, CELLS));
            Ok(over.map(|graph| oriented(cells, &graph.finish(), |cell| flow.at(cell))))
        });
    }

    fn make_coats(&mut self) {
        let (Some(domain), Some(cells)) = (self.terrain.domain.made(), self.cells.made()) else {
            return;
        };
        let inputs = self.terrain.domain.revision() + self.cells.revision();
        self.coats.advance(inputs, |params, work| {
            work.get_or_insert_with(|| Coats::new(params.colour, params.seed, params.side));
            let over = work.take_if(|coats| coats.advance(domain, cells, CELLS));
            Ok(over.map(|coats| coats.finish(domain, cells)))
        });
    }

    fn make_picture(&mut self, stage: Finish) {
        let inputs = self.finish_inputs();
        let (Some(domain), Some(cells)) = (self.terrain.domain.made(), self.cells.made()) else {
            return;
        };
        let oriented = self.flow.made().filter(|cells| !cells.is_empty());
        let bodies = Bodies {
            domain,
            cells: oriented.unwrap_or(cells),
            coats: self.coats.made().map_or(&[], Vec::as_slice),
        };
        self.finish.advance(stage, bodies, inputs);
        if self.at().is_none() {
            self.pictured = self.packing.revision();
        }
    }
}
