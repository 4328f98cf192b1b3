//! The stages of a pavement, as a table of tasks.

use super::params::{CellParams, CoatParams, DomainParams, FlowParams, Params};
use super::shaping::{CellsProgress, Packed};
use super::stage::Stage;
use crate::cells::{Cell, Graph};
use crate::domain::Domain;
use crate::field::{FieldBuilder, FieldParams, Fields};
use crate::generators::height_field::{Bodies, HeightField, HeightFieldParams};
use crate::generators::packs::{PackingNode, PackingProgress};
use crate::graph::{Node, Task, Wiring, task};
use crate::material::{Coat, Coats};
use crate::mesh::{Mesh, Meshing};
use crate::packing::{Packing, Placing};
use crate::solid::oriented;
use glam::DVec2;

/// The number of cells in one slice, when neighbours are found or coats are made.
const CELLS: usize = 500;

/// The nodes of the stages.
pub(super) struct Stages {
    pub(super) domain: Node<DomainParams, (), Domain>,
    pub(super) fields: Node<FieldParams, FieldBuilder, Fields>,
    pub(super) packing: PackingNode<Placing, Packing>,
    pub(super) mesh: Node<(), Meshing, Mesh>,
    pub(super) cells: Node<CellParams, CellsProgress, Vec<Cell>>,
    /// The cells of skin, with axes that agree in sense; empty for stones that are not skin.
    pub(super) flow: Node<Option<FlowParams>, Graph, Vec<Cell>>,
    pub(super) coats: Node<CoatParams, Coats, Vec<Coat>>,
    pub(super) finish: HeightField,
    /// The revision of the packing that the picture shows.
    pub(super) pictured: u64,
    /// The rings of the latest recipe's outline.
    rings: Vec<Vec<DVec2>>,
}

impl Wiring for Stages {
    type Stage = Stage;

    const TASKS: &'static [Task<Self>] = &[
        task!(Stage::Domain, domain, [], Self::make_domain),
        task!(Stage::Fields, fields, [domain], Self::make_fields),
        task!(
            Stage::Packing,
            packing,
            [domain, fields],
            Self::make_packing
        ),
        task!(Stage::Mesh, mesh, [domain, packing], Self::make_mesh),
        task!(
            Stage::Cells,
            cells,
            [domain, fields, packing],
            Self::make_cells
        ),
        task!(Stage::Planes, flow, [domain, cells], Self::make_flow),
        task!(Stage::Planes, coats, [domain, cells], Self::make_coats),
        task!(
            Stage::Planes,
            finish.planes,
            [cells, flow, coats],
            Self::make_planes
        ),
        task!(
            Stage::Weather,
            finish.weather,
            [domain, finish.planes],
            Self::make_weather
        ),
        task!(
            Stage::Shading,
            finish.light,
            [finish.weather],
            Self::make_light
        ),
    ];
}

impl Stages {
    /// Starts with nothing made.
    pub fn new(params: Params) -> Self {
        Self {
            domain: Node::new(params.domain),
            fields: Node::new(params.fields),
            packing: Node::new(params.packing),
            mesh: Node::new(()),
            cells: Node::new(params.cells),
            flow: Node::new(params.flow),
            coats: Node::new(params.coats),
            finish: HeightField::new(params.finish),
            pictured: 0,
            rings: params.rings,
        }
    }

    /// Notes the parameters of the latest recipe.
    pub fn ask(&mut self, params: Params) {
        self.rings = params.rings;
        self.domain.ask(params.domain);
        self.fields.ask(params.fields);
        self.packing.ask(params.packing);
        self.cells.ask(params.cells);
        self.flow.ask(params.flow);
        self.coats.ask(params.coats);
        self.finish.ask(params.finish);
    }

    /// The parameters of the latest recipe.
    pub fn latest(&self) -> Params {
        Params {
            rings: self.rings.clone(),
            domain: self.domain.latest().clone(),
            fields: self.fields.latest().clone(),
            packing: self.packing.latest().clone(),
            cells: *self.cells.latest(),
            flow: self.flow.latest().clone(),
            coats: *self.coats.latest(),
            finish: HeightFieldParams {
                planes: *self.finish.planes.latest(),
                weather: *self.finish.weather.latest(),
                light: self.finish.light.latest().clone(),
            },
        }
    }

    /// The rings of the present outline. A tile ignores its outline and has the rings of the latest recipe.
    pub fn rings(&self) -> &[Vec<DVec2>] {
        match self.domain.params() {
            DomainParams::Plane(outline) => &outline.rings,
            DomainParams::Tile { .. } => &self.rings,
        }
    }

    fn make_domain(&mut self) -> Option<()> {
        self.domain.advance(|params, _| {
            Ok(Some(match params {
                DomainParams::Plane(outline) => Domain::from_checked(outline),
                DomainParams::Tile { side, lines } => Domain::torus(*side, lines),
            }))
        })
    }

    fn make_fields(&mut self) -> Option<()> {
        let domain = self.domain.made()?;
        self.fields.advance(|params, work| {
            work.get_or_insert_with(|| FieldBuilder::new(domain, params.clone()));
            let over = work.take_if(|builder| builder.advance(domain));
            Ok(over.map(FieldBuilder::finish))
        })
    }

    fn make_packing(&mut self) -> Option<()> {
        let ground = (self.domain.made()?, self.fields.made()?);
        self.packing
            .advance(|params, work| PackingProgress::advance(params, work, ground))
    }

    fn make_mesh(&mut self) -> Option<()> {
        let (domain, packing) = (self.domain.made()?, self.packing.made()?);
        self.mesh.advance(|(), work| {
            let new = || Meshing::new(domain, packing.particles_within(domain));
            Ok(work.get_or_insert_with(new).advance(domain))
        })
    }

    fn make_cells(&mut self) -> Option<()> {
        let from = Packed {
            domain: self.domain.made()?,
            fields: self.fields.made()?,
            packing: self.packing.made()?,
        };
        self.cells
            .advance(|params, work| CellsProgress::advance(params, work, from))
    }

    fn make_flow(&mut self) -> Option<()> {
        let (domain, cells) = (self.domain.made()?, self.cells.made()?);
        self.flow.advance(|params, work| {
            let Some(flow) = params else {
                return Ok(Some(Vec::new()));
            };
            work.get_or_insert_with(|| Graph::new(domain, cells));
            let over = work.take_if(|graph| graph.advance(domain, CELLS));
            Ok(over.map(|graph| oriented(cells, &graph.finish(), |cell| flow.at(cell))))
        })
    }

    fn make_coats(&mut self) -> Option<()> {
        let (domain, cells) = (self.domain.made()?, self.cells.made()?);
        self.coats.advance(|params, work| {
            work.get_or_insert_with(|| Coats::new(params.colour, params.seed, params.side));
            let over = work.take_if(|coats| coats.advance(domain, cells, CELLS));
            Ok(over.map(|coats| coats.finish(domain, cells)))
        })
    }

    fn make_planes(&mut self) -> Option<()> {
        let oriented = self.flow.made().filter(|cells| !cells.is_empty());
        let bodies = Bodies {
            domain: self.domain.made()?,
            cells: oriented.or(self.cells.made())?,
            coats: self.coats.made()?,
        };
        self.finish.paint(bodies)
    }

    fn make_weather(&mut self) -> Option<()> {
        self.finish.weather(self.domain.made()?)
    }

    fn make_light(&mut self) -> Option<()> {
        self.finish.shade()?;
        if self.at().is_none() {
            self.pictured = self.packing.revision();
        }
        Some(())
    }
}
