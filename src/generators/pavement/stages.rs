//! The stages of a pavement: what each has made, and how they hang together.

use super::params::{CellParams, CoatParams, Params};
use super::terrain::Terrain;
use crate::cells::{self, Cell, Fitting, Graph, Scatter, ScatterParams};
use crate::domain::Domain;
use crate::generators::height_field::{Bodies, Finish, HeightField, Passes, Revisions};
use crate::graph::{Node, State};
use crate::mesh::{Mesh, Meshing};
use crate::notice::{Code, Notice};
use crate::packing::{Packing, PackingParams, Placing};
use crate::solid::oriented;
use crate::texture::{Coat, Coats, Planes};

/// The stages of a pavement, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// The outline with its distances.
    Domain,
    /// Size and direction of the cells.
    Fields,
    /// The relaxation of the cells.
    Packing,
    /// The mesh that joins neighbouring cells.
    Mesh,
    /// One polygon per cell.
    Cells,
    /// Stones, painted as they are made into planes of bump, colour, optics and id.
    Planes,
    /// What years and weather do to the planes, and how much of the sky each place sees.
    Weather,
    /// The picture.
    Shading,
}

impl Stage {
    /// All stages in their order.
    pub const ALL: [Stage; 8] = [
        Stage::Domain,
        Stage::Fields,
        Stage::Packing,
        Stage::Mesh,
        Stage::Cells,
        Stage::Planes,
        Stage::Weather,
        Stage::Shading,
    ];
}

/// Their words.
pub const WORDS: [&str; 8] = [
    "domain", "fields", "packing", "mesh", "cells", "planes", "weather", "shading",
];

impl From<Finish> for Stage {
    fn from(finish: Finish) -> Self {
        match finish {
            Finish::Planes => Stage::Planes,
            Finish::Weather => Stage::Weather,
            Finish::Shading => Stage::Shading,
        }
    }
}

/// Cells whose neighbours are found, or whose coats are made, in one slice.
const CELLS: usize = 500;

/// A packing on its way.
pub(super) enum Packs {
    /// Its first cells are being placed.
    Placing(Box<Placing>),
    /// They move.
    Moving(Box<Packing>),
}

/// Cells on their way.
pub(super) enum Shaping {
    Scatter(Box<Scatter>),
    Fitting(Box<Fitting>),
}

/// The stages.
pub(super) struct Stages {
    pub terrain: Terrain,
    packing: Node<PackingParams, Packs, Packing>,
    mesh: Node<(), Meshing, Mesh>,
    cells: Node<CellParams, Shaping, Vec<Cell>>,
    /// Of skin, the cells in which the axes have one sense; none of stones.
    flow: Node<bool, Graph, Vec<Cell>>,
    coats: Node<CoatParams, Coats, Vec<Coat>>,
    pub finish: HeightField,
    /// Of which packing the picture is.
    pictured: u64,
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
            flow: Node::new(params.is_skin),
            coats: Node::new(params.coats),
            finish: HeightField::new(params.finish, Passes::Many, usize::MAX),
            pictured: 0,
        }
    }

    /// What the stages are to be made by from now on.
    pub fn want(&mut self, params: Params) {
        self.terrain.want(params.terrain);
        self.packing.want(params.packing);
        self.cells.want(params.cells);
        self.flow.want(params.is_skin);
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

    fn cell_inputs(&self) -> u64 {
        self.terrain.domain.revision() + self.cells.revision()
    }

    fn finish_inputs(&self) -> Revisions {
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
            let mut placing = match work.take() {
                Some(Packs::Moving(mut packing)) => {
                    if packing.step(domain, fields).done {
                        return Ok(Some(*packing));
                    }
                    *work = Some(Packs::Moving(packing));
                    return Ok(None);
                }
                Some(Packs::Placing(placing)) => placing,
                None => Box::new(Placing::new(domain, fields, *params)?),
            };
            if !placing.advance(domain, fields) {
                *work = Some(Packs::Placing(placing));
                return Ok(None);
            }
            let packing = placing.finish(domain, fields);
            if packing.report().cells == 0 {
                return Err(Code::NoCells.into());
            }
            *work = Some(Packs::Moving(Box::new(packing)));
            Ok(None)
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
        self.cells.advance(inputs, |params, work| {
            let cells = match (params, work.take()) {
                (CellParams::Packed, _) => cells::packed(&packing.particles()),
                (_, Some(Shaping::Fitting(mut fitting))) => {
                    if !fitting.advance(domain) {
                        *work = Some(Shaping::Fitting(fitting));
                        return Ok(None);
                    }
                    fitting.finish()
                }
                (CellParams::Fitted, _) => {
                    *work = Some(Shaping::fit(Fitting::new(packing.particles())));
                    return Ok(None);
                }
                (&CellParams::Scattered { rounds, seed }, scatter) => {
                    let mut scatter = match scatter {
                        Some(Shaping::Scatter(scatter)) => scatter,
                        _ => Box::new(Scatter::new(
                            domain,
                            ScatterParams {
                                count: packing.report().cells,
                                rounds,
                                seed,
                            },
                        )),
                    };
                    *work = Some(match scatter.advance(domain) {
                        true => Shaping::fit(Fitting::voronoi(scatter.particles(fields))),
                        false => Shaping::Scatter(scatter),
                    });
                    return Ok(None);
                }
            };
            if cells.is_empty() {
                return Err(Code::NoCells.into());
            }
            Ok(Some(cells))
        });
    }

    fn make_flow(&mut self) {
        let (Some(domain), Some(cells)) = (self.terrain.domain.made(), self.cells.made()) else {
            return;
        };
        let inputs = self.terrain.domain.revision() + self.cells.revision();
        self.flow.advance(inputs, |&is_skin, work| {
            if !is_skin {
                return Ok(Some(Vec::new()));
            }
            work.get_or_insert_with(|| Graph::new(domain, cells));
            let over = work.take_if(|graph| graph.advance(domain, CELLS));
            Ok(over.map(|graph| oriented(cells, &graph.finish())))
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

impl Shaping {
    fn fit(fitting: Fitting) -> Self {
        Shaping::Fitting(Box::new(fitting))
    }
}

/// What there is to be seen: where nothing else is said, what was made last, stale or not.
impl Stages {
    /// The packing at work, or the last one.
    pub fn packing(&self) -> Option<&Packing> {
        match self.packing.work() {
            Some(Packs::Moving(packing)) => Some(packing),
            _ => self.packing.made(),
        }
    }

    /// The packing at work, or the last one, and the domain: it keeps what it works out of itself.
    pub fn packing_mut(&mut self) -> Option<(&mut Packing, &Domain)> {
        let is_moving = matches!(self.packing.work(), Some(Packs::Moving(_)));
        let packing = match is_moving {
            true => self.packing.work_mut().and_then(|packs| match packs {
                Packs::Moving(packing) => Some(&mut **packing),
                Packs::Placing(_) => None,
            }),
            false => self.packing.made_mut(),
        };
        packing.zip(self.terrain.domain.made())
    }

    /// Are there cells of the packing at work, or of one that is over and fresh?
    pub fn is_packing(&self) -> bool {
        match self.at() {
            Some(Stage::Packing) => {
                let work = self.packing.work_of(self.terrain.revision());
                matches!(work, Some(Packs::Moving(_)))
            }
            at => at.is_none_or(|stage| stage > Stage::Packing),
        }
    }

    /// Is the pavement forming anew, so that older pictures are of another one?
    pub fn is_forming(&self) -> bool {
        let packs = self.at().is_some_and(|stage| stage <= Stage::Packing);
        packs || self.pictured != self.packing.revision()
    }

    /// The mesh of the last packing that ended.
    pub fn mesh(&self) -> Option<&Mesh> {
        self.mesh.made()
    }

    /// The cells of the last packing that ended.
    pub fn cells(&self) -> &[Cell] {
        self.cells.made().map_or(&[], Vec::as_slice)
    }

    /// Of the cells.
    pub fn cells_revision(&self) -> u64 {
        self.cells.revision()
    }

    /// The cells that stones are made of: of skin, those in which the axes have one sense.
    pub fn scales(&self) -> &[Cell] {
        let oriented = self.flow.made_of(self.cell_inputs());
        let oriented = oriented.filter(|cells| !cells.is_empty());
        oriented.map_or_else(|| self.cells(), Vec::as_slice)
    }

    /// What the cells wear by rule; none while other cells form.
    pub fn coats(&self) -> &[Coat] {
        let forms = self.at().is_some_and(|stage| stage < Stage::Planes);
        let coats = self.coats.made_of(self.cell_inputs());
        coats.filter(|_| !forms).map_or(&[], Vec::as_slice)
    }

    /// Stones painted by now.
    pub fn stones(&self) -> usize {
        match self.at() {
            Some(stage) if stage <= Stage::Planes => {
                self.finish.stones_coming(self.finish_inputs())
            }
            _ => self.scales().len(),
        }
    }

    /// Is the ground laid that the stones at work come on?
    pub fn is_bedded(&self) -> bool {
        match self.at() {
            Some(stage) if stage <= Stage::Planes => self.finish.is_bedded(self.finish_inputs()),
            _ => true,
        }
    }

    /// The planes last finished.
    pub fn planes(&self) -> Option<&Planes> {
        self.finish.weather.made()
    }

    /// The planes on their way.
    pub fn planes_coming(&self) -> Option<&Planes> {
        let stage = match self.at()? {
            Stage::Planes => Finish::Planes,
            Stage::Weather => Finish::Weather,
            _ => return None,
        };
        self.finish.planes_coming(stage, self.finish_inputs())
    }

    /// The picture last finished, empty before there is one.
    pub fn picture(&self) -> &[u8] {
        self.finish.light.made().map_or(&[], Vec::as_slice)
    }

    /// Grows whenever something else may be seen.
    pub fn slices(&self) -> u64 {
        let packing = self.packing.slices() + self.mesh.slices() + self.cells.slices();
        let before = self.terrain.slices() + packing;
        before + self.flow.slices() + self.coats.slices() + self.finish.slices()
    }

    /// How often each stage has finished, in their order.
    pub fn runs(&self) -> [u64; 8] {
        [
            self.terrain.domain.revision(),
            self.terrain.fields.revision(),
            self.packing.revision(),
            self.mesh.revision(),
            self.cells.revision(),
            self.finish.planes.revision(),
            self.finish.weather.revision(),
            self.finish.light.revision(),
        ]
    }
}
