//! The stages of a surface, as a table of tasks.

use super::build::{Building, Built};
use super::fields::{Fielding, FieldsWithRemarks};
use super::params::{CellParams, FieldParams, MeshSource, Params, StoneLook, SurfaceParams};
use super::paving::{PavedCells, PavingInputs, PavingProgress};
use super::views;
use crate::export::ModelFile;
use crate::generators::held::{Held, Origin};
use crate::generators::packs::{PackingNode, PackingProgress};
use crate::generators::scene_picture::{AskedFile, MadeScene, Saving, SceneStages, SharedNodes};
use crate::generators::{Clock, Rewind};
use crate::graph::{Node, Task, Wiring, task};
use crate::notice::{Code, Notice};
use crate::packing::Kept;
use crate::recipe::Recipe;
use crate::surface_cells::SurfaceCell;
use crate::surface_cells::{Polish, SurfaceMesh, SurfaceMeshing};
use crate::surface_field::SurfaceFields;
use crate::surface_packing::{PackingMesh, PackingMeshMaking, SurfacePacking, SurfacePlacing};
use crate::surface_stones::{Stones, StonesParams};
use crate::surface_views::BareSurface;
use std::rc::Rc;

/// The words of the stages.
pub(super) const WORDS: [&str; 7] = [
    "surface", "fields", "packing", "mesh", "cells", "stones", "light",
];

/// The index of the packing.
pub(super) const PACKING: usize = 2;
/// The index of the stones, the first stage of the finisher.
pub(super) const STONES: usize = 5;

/// No notice is given if the number of cells differs from the wanted number by less than this factor.
const COUNT: f64 = 4.0;

/// The nodes of the stages, and the files given for them.
pub(crate) struct Stages {
    pub(super) shared: SharedNodes<StoneLook, Stones>,
    pub(super) built: Node<SurfaceParams, Building, Built>,
    pub(super) fields: Node<FieldParams, Fielding, FieldsWithRemarks>,
    pub(super) site: Node<(), PackingMeshMaking, PackingMesh>,
    /// The packing, held at one of its steps.
    held: Option<Held<SurfacePlacing, SurfacePacking>>,
    pub(super) packing: PackingNode<SurfacePlacing, SurfacePacking>,
    pub(super) mesh: Node<(), SurfaceMeshing, SurfaceMesh>,
    pub(super) paved: Node<CellParams, PavingProgress, PavedCells>,
    /// The bare surface that views share, and its revision.
    pub(super) bare: Option<(u64, BareSurface)>,
}

impl Wiring for Stages {
    type Stage = usize;

    const TASKS: &'static [Task<Self>] = &[
        task!(
            0,
            shared.files.loaded,
            |all| all.shared.files.inputs(),
            |all| all.shared.files.load()
        ),
        task!(0, built, [shared.files.loaded], Self::build),
        task!(1, fields, [built], Self::make_fields),
        task!(PACKING, site, [fields], Self::make_site),
        task!(PACKING, packing, [fields, site], Self::make_packing),
        task!(3, mesh, [site, packing], Self::make_mesh),
        task!(4, paved, [built, fields, mesh], Self::make_cells),
        task!(STONES, shared.bodies, [built, paved], Self::make_stones),
        task!(6, shared.still, [shared.bodies], |all| all.shared.draw()),
    ];
}

/// The files that a surface needs.
fn asked(params: &SurfaceParams) -> Vec<AskedFile> {
    match &params.source {
        MeshSource::Shape(..) => Vec::new(),
        MeshSource::Model(file) => vec![file.clone()],
    }
}

impl SceneStages for Stages {
    type Look = StoneLook;
    type Finishing = Stones;
    type Saving = Option<Saving<ModelFile>>;

    const FINISHER: usize = STONES;
    const VIEWS: &'static [&'static str] = &views::WORDS;

    fn new(recipe: &Recipe) -> Self {
        let params = Params::new(recipe);
        let files = asked(&params.surface);
        Self {
            shared: SharedNodes::new(files, params.stones, params.still),
            built: Node::new(params.surface),
            fields: Node::new(params.fields),
            site: Node::new(()),
            held: None,
            packing: Node::new(params.packing),
            mesh: Node::new(()),
            paved: Node::new(params.cells),
            bare: None,
        }
    }

    fn shared(&self) -> &SharedNodes<StoneLook, Stones> {
        &self.shared
    }

    fn shared_mut(&mut self) -> &mut SharedNodes<StoneLook, Stones> {
        &mut self.shared
    }

    fn ask(&mut self, recipe: &Recipe) {
        let params = Params::new(recipe);
        let files = asked(&params.surface);
        self.shared.ask(files, params.stones, params.still);
        self.built.ask(params.surface);
        self.fields.ask(params.fields);
        self.packing.ask(params.packing);
        self.paved.ask(params.cells);
    }

    fn forget_steps(&mut self) {
        let of = self.origin();
        let from = self.held.as_ref().and_then(|held| held.going_on(&of));
        self.packing.forget();
        if let Some(packing) = from {
            self.packing.go_on(PackingProgress::Moving(packing));
        }
    }

    fn rewind(&mut self) -> Option<&mut dyn Rewind> {
        Some(self)
    }

    fn remarks(&self) -> Vec<Notice> {
        let built = self.built().map_or(&[][..], |built| &built.notices);
        let fields = self
            .fresh_fields()
            .map_or(&[][..], |fielded| &fielded.notices);
        let count = self
            .current(&self.paved)
            .and_then(|paved| self.count(paved));
        built.iter().chain(fields).cloned().chain(count).collect()
    }

    fn is_moving(&self) -> bool {
        let moving = self.begun(&self.packing).and_then(PackingProgress::moving);
        self.at() == Some(PACKING) && moving.is_some_and(|packing| !packing.is_in_a_step())
    }
}

impl Stages {
    /// A notice if there are far fewer or more cells than the recipe asks for. For example, parts that are narrower
    /// than a cell get cells, too.
    fn count(&self, paved: &PavedCells) -> Option<Notice> {
        let (n, wanted) = (paved.cells.len(), self.fields.params().sizes.count);
        let share = n as f64 / wanted;
        let told = Notice::new(Code::SurfaceCount);
        let told = told.with("n", n).with("wanted", wanted.round() as usize);
        (!(1.0 / COUNT..=COUNT).contains(&share)).then_some(told)
    }

    fn build(&mut self) -> Option<()> {
        let loaded = self.shared.files.loaded.made()?;
        self.built
            .advance(|params, work| Building::advance(params, work, loaded))
    }

    fn make_fields(&mut self) -> Option<()> {
        let built = self.built.made()?;
        self.fields
            .advance(|params, work| Fielding::advance(params, work, built))
    }

    fn make_site(&mut self) -> Option<()> {
        let FieldsWithRemarks { fields, .. } = self.fields.made()?;
        self.site.advance(|(), work| {
            let longest = fields.size_range().1 * fields.aspect_range().1.sqrt();
            let new = || PackingMeshMaking::new(fields.mesh().clone());
            Ok(work.get_or_insert_with(new).advance(longest))
        })
    }

    /// The present surface to pack on, once it is made.
    fn ground(&self) -> Option<(&PackingMesh, &SurfaceFields)> {
        Some((self.current(&self.site)?, &self.fresh_fields()?.fields))
    }

    fn origin(&self) -> Origin {
        let revisions = [self.fields.revision(), self.site.revision()];
        (self.packing.params().clone(), revisions)
    }

    fn make_packing(&mut self) -> Option<()> {
        let ground = (self.site.made()?, &self.fields.made()?.fields);
        self.packing
            .advance(|params, work| PackingProgress::advance(params, work, ground))
    }

    fn make_mesh(&mut self) -> Option<()> {
        let (site, packing) = (self.site.made()?, self.packing.made()?);
        self.mesh.advance(|(), work| {
            let new = || SurfaceMeshing::new(packing.particles(), Polish::default());
            Ok(work.get_or_insert_with(new).advance(site.mesh()))
        })
    }

    fn make_cells(&mut self) -> Option<()> {
        let from = PavingInputs {
            mesh: self.mesh.made()?,
            built: self.built.made()?,
            fields: &self.fields.made()?.fields,
        };
        self.paved
            .advance(|params, work| PavingProgress::advance(params, work, from))
    }

    fn make_stones(&mut self) -> Option<()> {
        let (built, paved) = (self.built.made()?, self.paved.made()?);
        let packing = self.packing.revision();
        self.shared.bodies.advance(|look, work| {
            let new = || {
                let params = stones_params(look, &paved.cells);
                Stones::new(params, &built.whole, &paved.cells)
            };
            let stones = work.get_or_insert_with(new);
            if !stones.advance(&built.whole, paved.paving()) {
                return Ok(None);
            }
            let done = work.take();
            Ok(done.map(|stones| MadeScene::new(Rc::new(stones.finish()), packing)))
        })
    }
}

impl Rewind for Stages {
    fn hold(&mut self, step: Option<u32>) {
        let of = self.origin();
        Held::ask(&mut self.held, step, of);
    }

    fn reach(&mut self, clock: Clock, budget: f64) -> bool {
        let mut held = self.held.take();
        let is_there = Held::reach(&mut held, self.ground(), self.origin(), clock, budget);
        self.held = held;
        is_there
    }
}

/// The parameters of stones on these cells.
pub(super) fn stones_params(look: &StoneLook, cells: &[SurfaceCell]) -> StonesParams {
    StonesParams {
        open: look.open,
        ..StonesParams::new(look.texture, look.weather, cells)
    }
}
