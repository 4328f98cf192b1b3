//! How the stages of a surface hang together, and what is due next.

use super::SURFACE;
use super::build::{Building, Built};
use super::fields::{Fielded, Fielding};
use super::params::{CellParams, FieldParams, Params, Source, StoneLook, SurfaceParams};
use super::paving::{Meshed, Paved, Paves};
use super::schema::keys;
use crate::generators::MissingFile;
use crate::generators::scene_picture::{
    AskedFile, GivenFiles, Loaded, Loading, Still, StillParams,
};
use crate::graph::{Node, State};
use crate::notice::{Code, Notice};
use crate::packing::PackingParams;
use crate::scene::Scene;
use crate::surface_cells::SurfaceCell;
use crate::surface_cells::{Polish, SurfaceMesh, SurfaceMeshing};
use crate::surface_packing::{Site, SurfacePacking, SurfacePlacing};
use crate::surface_stones::{Stones, StonesParams};
use std::rc::Rc;

/// The words of the stages.
pub(super) const WORDS: [&str; 7] = [
    "surface", "fields", "packing", "mesh", "cells", "stones", "light",
];

/// The places of some of them.
pub(super) const PACKING: usize = 2;
/// Stones, the first stage of the finisher.
pub(super) const STONES: usize = 5;

/// The bodies on the surface.
pub(super) struct Bodies {
    pub scene: Rc<Scene>,
    /// Of all that the scene is made of.
    pub digest: String,
    /// Of which packing they are.
    pub packing: u64,
}

/// A packing on its way.
pub(super) enum Packs {
    Placing(Box<SurfacePlacing>),
    Moving(Box<SurfacePacking>),
}

/// The stages.
pub(super) struct Stages {
    pub files: GivenFiles,
    pub(super) loaded: Node<Vec<AskedFile>, Loading, Loaded>,
    pub(super) built: Node<SurfaceParams, Building, Built>,
    pub(super) fields: Node<FieldParams, Fielding, Fielded>,
    pub(super) site: Node<(), (), Site>,
    pub(super) packing: Node<PackingParams, Packs, SurfacePacking>,
    pub(super) mesh: Node<(), SurfaceMeshing, SurfaceMesh>,
    pub(super) paved: Node<CellParams, Paves, Paved>,
    pub(super) stones: Node<StoneLook, Stones, Bodies>,
    pub(super) still: Node<StillParams, Still, Vec<u8>>,
}

/// A piece of the work, in their order.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Task {
    Load,
    Build,
    Fields,
    Site,
    Pack,
    Mesh,
    Pave,
    Stones,
    Still,
}

impl Task {
    fn stage(self) -> usize {
        match self {
            Task::Load | Task::Build => 0,
            Task::Fields => 1,
            Task::Site | Task::Pack => PACKING,
            Task::Mesh => 3,
            Task::Pave => 4,
            Task::Stones => STONES,
            Task::Still => 6,
        }
    }
}

/// The files that a surface needs.
fn asked(params: &SurfaceParams) -> Vec<AskedFile> {
    match &params.source {
        Source::Shape(..) => Vec::new(),
        Source::Model(file, is_z_up) => vec![AskedFile {
            role: keys::MODEL.0,
            file: file.clone(),
            is_z_up: *is_z_up,
        }],
    }
}

/// How the picture is seen and lit.
pub(super) fn still(params: &Params) -> StillParams {
    StillParams {
        camera: SURFACE.camera(),
        light: params.light.clone(),
        yaw: params.yaw,
        side: params.side,
    }
}

impl Stages {
    /// Nothing made yet.
    pub fn new(params: &Params) -> Self {
        Self {
            files: GivenFiles::default(),
            loaded: Node::new(asked(&params.surface)),
            built: Node::new(params.surface.clone()),
            fields: Node::new(params.fields.clone()),
            site: Node::new(()),
            packing: Node::new(params.packing),
            mesh: Node::new(()),
            paved: Node::new(params.cells),
            stones: Node::new(params.stones),
            still: Node::new(still(params)),
        }
    }

    /// From now on all is to be made by these.
    pub fn want(&mut self, params: &Params) {
        self.loaded.want(asked(&params.surface));
        self.built.want(params.surface.clone());
        self.fields.want(params.fields.clone());
        self.packing.want(params.packing);
        self.paved.want(params.cells);
        self.stones.want(params.stones);
        self.still.want(still(params));
    }

    /// Marks all stages as stale.
    pub fn forget(&mut self) {
        self.built.forget();
    }

    /// Takes a file.
    pub fn give(&mut self, digest: u64, bytes: Vec<u8>) {
        self.files.give(digest, bytes, self.loaded.params());
    }

    /// The revisions that a piece of the work hangs on, summed.
    pub(super) fn inputs(&self, task: Task) -> u64 {
        let built = || self.built.revision();
        let fields = || built() + self.fields.revision();
        let packed = || fields() + self.packing.revision();
        let meshed = || packed() + self.mesh.revision();
        let paved = || meshed() + self.paved.revision();
        match task {
            Task::Load => self.files.count(self.loaded.params()),
            Task::Build => self.loaded.revision(),
            Task::Fields => built(),
            Task::Site => fields(),
            Task::Pack => fields() + self.site.revision(),
            Task::Mesh => packed(),
            Task::Pave => meshed(),
            Task::Stones => paved(),
            Task::Still => paved() + self.stones.revision(),
        }
    }

    fn state(&self, task: Task) -> State {
        let inputs = self.inputs(task);
        match task {
            Task::Load => self.loaded.state(inputs),
            Task::Build => self.built.state(inputs),
            Task::Fields => self.fields.state(inputs),
            Task::Site => self.site.state(inputs),
            Task::Pack => self.packing.state(inputs),
            Task::Mesh => self.mesh.state(inputs),
            Task::Pave => self.paved.state(inputs),
            Task::Stones => self.stones.state(inputs),
            Task::Still => self.still.state(inputs),
        }
    }

    /// The first piece of the work that is not fresh.
    pub(super) fn due(&self) -> Option<Task> {
        let all = [
            Task::Load,
            Task::Build,
            Task::Fields,
            Task::Site,
            Task::Pack,
            Task::Mesh,
            Task::Pave,
            Task::Stones,
            Task::Still,
        ];
        all.into_iter()
            .find(|&task| self.state(task) != State::Fresh)
    }

    /// The stage that is not fresh; none where all is done.
    pub fn at(&self) -> Option<usize> {
        self.due().map(Task::stage)
    }

    /// Why the stage at work cannot go on.
    pub fn failure(&self) -> Option<&Notice> {
        let task = self
            .due()
            .filter(|&task| self.state(task) == State::Failed)?;
        match task {
            Task::Load => self.loaded.failure(),
            Task::Build => self.built.failure(),
            Task::Fields => self.fields.failure(),
            Task::Pack => self.packing.failure(),
            Task::Mesh | Task::Site => None,
            Task::Pave => self.paved.failure(),
            Task::Stones => self.stones.failure(),
            Task::Still => self.still.failure(),
        }
    }

    /// The files that are missing, also before any work has found that.
    pub fn missing(&self) -> Vec<MissingFile> {
        let asked = match self.due() {
            Some(Task::Load) => &self.loaded.params()[..],
            _ => &[],
        };
        self.files.missing(asked).collect()
    }

    /// What was done to the surface, or is to be said of cells on it.
    pub fn remarks(&self) -> Vec<Notice> {
        let built = self.built().map_or(&[][..], |built| &built.notices);
        let fields = self.fields.made_of(self.inputs(Task::Fields));
        let fields = fields.map_or(&[][..], |fielded| &fielded.notices);
        [built, fields].concat()
    }

    /// One slice of the first piece that is not fresh.
    pub fn advance(&mut self) {
        let Some(task) = self.due().filter(|&task| self.state(task) != State::Failed) else {
            return;
        };
        let inputs = self.inputs(task);
        match task {
            Task::Load => {
                let files = &self.files;
                self.loaded
                    .advance(inputs, |asked, work| Loading::advance(asked, work, files));
            }
            Task::Build => {
                let Some(loaded) = self.loaded.made() else {
                    return;
                };
                self.built.advance(inputs, |params, work| {
                    Building::advance(params, work, loaded)
                });
            }
            Task::Fields => {
                let Some(built) = self.built.made() else {
                    return;
                };
                self.fields.advance(inputs, |params, work| {
                    Fielding::advance(params, work, built)
                });
            }
            Task::Site => self.make_site(inputs),
            Task::Pack => self.make_packing(inputs),
            Task::Mesh => self.make_mesh(inputs),
            Task::Pave => self.make_cells(inputs),
            Task::Stones => self.make_stones(inputs),
            Task::Still => {
                let Some(Bodies { scene, .. }) = self.stones.made() else {
                    return;
                };
                self.still.advance(inputs, |params, work| {
                    work.get_or_insert_with(|| Still::new(params, scene.clone()))
                        .advance()
                });
            }
        }
    }

    fn make_site(&mut self, inputs: u64) {
        let Some(Fielded { fields, .. }) = self.fields.made() else {
            return;
        };
        self.site.advance(inputs, |(), _| {
            let longest = fields.size_range().1 * fields.aspect_range().1.sqrt();
            Ok(Some(Site::new(fields.mesh().clone(), longest)))
        });
    }

    fn make_packing(&mut self, inputs: u64) {
        let (Some(Fielded { fields, .. }), Some(site)) = (self.fields.made(), self.site.made())
        else {
            return;
        };
        self.packing.advance(inputs, |params, work| {
            let mut placing = match work.take() {
                Some(Packs::Moving(mut packing)) => {
                    if packing.advance(site, fields) {
                        return Ok(Some(*packing));
                    }
                    *work = Some(Packs::Moving(packing));
                    return Ok(None);
                }
                Some(Packs::Placing(placing)) => placing,
                None => Box::new(SurfacePlacing::new(site, fields, *params)),
            };
            if !placing.advance(site, fields) {
                *work = Some(Packs::Placing(placing));
                return Ok(None);
            }
            let packing = placing.finish(site, fields);
            if packing.report().cells == 0 {
                return Err(Code::NoCells.into());
            }
            *work = Some(Packs::Moving(Box::new(packing)));
            Ok(None)
        });
    }

    fn make_mesh(&mut self, inputs: u64) {
        let (Some(site), Some(packing)) = (self.site.made(), self.packing.made()) else {
            return;
        };
        self.mesh.advance(inputs, |(), work| {
            let new = || SurfaceMeshing::new(packing.particles(), Polish::default());
            Ok(work.get_or_insert_with(new).advance(site.mesh()))
        });
    }

    fn make_cells(&mut self, inputs: u64) {
        let (Some(mesh), Some(built), Some(Fielded { fields, .. })) =
            (self.mesh.made(), self.built.made(), self.fields.made())
        else {
            return;
        };
        self.paved.advance(inputs, |params, work| {
            let from = Meshed {
                mesh,
                built,
                fields,
            };
            Ok(Paves::advance(params, work, from))
        });
    }

    fn make_stones(&mut self, inputs: u64) {
        let (Some(built), Some(paved)) = (self.built.made(), self.paved.made()) else {
            return;
        };
        let packing = self.packing.revision();
        self.stones.advance(inputs, |look, work| {
            let new = || {
                Stones::new(
                    stones_params(look, &paved.cells),
                    &built.whole,
                    &paved.cells,
                )
            };
            let stones = work.get_or_insert_with(new);
            if !stones.advance(&built.whole, paved.paving()) {
                return Ok(None);
            }
            Ok(work.take().map(|stones| {
                let scene = stones.finish();
                Bodies {
                    digest: scene.digest(),
                    packing,
                    scene: Rc::new(scene),
                }
            }))
        });
    }
}

/// What stones on these cells are made by.
pub(super) fn stones_params(look: &StoneLook, cells: &[SurfaceCell]) -> StonesParams {
    StonesParams {
        open: look.open,
        ..StonesParams::new(look.texture, look.weather, cells)
    }
}
