//! The stages of a pile, as a table of tasks.

use super::components::{Components, ComponentsMaking};
use super::darting::{Placed, Placing, room, sparse};
use super::dress::{Dressed, Dressing};
use super::heap::{Heap, HeapParts};
use super::params::{
    BodyParams, ComponentParams, DartParams, DressParams, PileParams, RoomParams, SiteParams,
};
use super::site::{Site, SiteMaking};
use super::views;
use crate::export::SceneFile;
use crate::generators::scene_picture::{MadeScene, Saving, SceneStages, SharedNodes};
use crate::graph::{Node, Task, Wiring, task};
use crate::notice::Notice;
use crate::pile::{Body, RefineParams, Refining};
use crate::recipe::Recipe;
use crate::surface_views::BareSurface;
use std::rc::Rc;

/// The words of the stages.
pub(super) const WORDS: [&str; 6] = ["components", "shape", "darts", "refine", "bodies", "light"];

/// The index of the stage that lets bodies settle.
pub(super) const REFINE: usize = 3;
/// The index of the bodies, the first stage of the finisher.
pub(super) const BODIES: usize = 4;

/// The approximate number of steps in which all bodies settle.
const STEPS: usize = 160;
/// The most bodies in one step.
const MOST: usize = 12;

/// The nodes of the stages, and the files given for them.
pub(crate) struct PileStages {
    pub(super) shared: SharedNodes<BodyParams, Heap>,
    /// The last components: types that do not change take theirs from here.
    kept: Components,
    pub(super) components: Node<ComponentParams, ComponentsMaking, Components>,
    pub(super) dressed: Node<DressParams, Dressing, Rc<Dressed>>,
    pub(super) site: Node<SiteParams, SiteMaking, Site>,
    pub(super) ground: Node<RoomParams, BareSurface, BareSurface>,
    pub(super) placed: Node<DartParams, Placing, Placed>,
    pub(super) settled: Node<RefineParams, Refining, Refining>,
    /// The bodies of the last finished run whose steps were made again, and what that run was made from.
    pub(super) known: Option<(SettledFrom, Rc<[Body]>)>,
}

/// The inputs of settling: the revisions of darts and shape, and the parameters.
pub(super) type SettledFrom = ([u64; 2], RefineParams);

impl Wiring for PileStages {
    type Stage = usize;

    const TASKS: &'static [Task<Self>] = &[
        task!(
            0,
            shared.files.loaded,
            |all| all.shared.files.inputs(),
            |all| all.shared.files.load()
        ),
        task!(0, components, [shared.files.loaded], Self::make_components),
        task!(1, site, [shared.files.loaded], Self::make_site),
        task!(1, ground, [components, site], Self::make_ground),
        task!(2, placed, [components, site], Self::make_darts),
        task!(REFINE, dressed, [components], Self::make_dressed),
        task!(REFINE, settled, [placed, site], Self::refine),
        task!(
            BODIES,
            shared.bodies,
            [settled, ground, dressed],
            Self::make_bodies
        ),
        task!(5, shared.still, [shared.bodies], |all| all.shared.draw()),
    ];
}

impl SceneStages for PileStages {
    type Look = BodyParams;
    type Finishing = Heap;
    type Saving = Option<Saving<SceneFile>>;

    const FINISHER: usize = BODIES;
    const VIEWS: &'static [&'static str] = &views::WORDS;

    fn new(recipe: &Recipe) -> Self {
        let params = PileParams::new(recipe);
        Self {
            shared: SharedNodes::new(params.files, params.bodies, params.still),
            kept: Components::default(),
            components: Node::new(params.components),
            dressed: Node::new(params.dress),
            site: Node::new(params.site),
            ground: Node::new(params.room),
            placed: Node::new(params.darts),
            settled: Node::new(params.refine),
            known: None,
        }
    }

    fn shared(&self) -> &SharedNodes<BodyParams, Heap> {
        &self.shared
    }

    fn shared_mut(&mut self) -> &mut SharedNodes<BodyParams, Heap> {
        &mut self.shared
    }

    fn ask(&mut self, recipe: &Recipe) {
        let params = PileParams::new(recipe);
        self.shared.ask(params.files, params.bodies, params.still);
        self.components.ask(params.components);
        self.dressed.ask(params.dress);
        self.site.ask(params.site);
        self.ground.ask(params.room);
        self.placed.ask(params.darts);
        self.settled.ask(params.refine);
    }

    fn forget_steps(&mut self) {
        let run = self.settled.made();
        let run = run.filter(|_| self.is_fresh(&self.settled));
        let known = run.map(|run| (self.settled_from(), run.bodies().into()));
        self.known = known.or(self.known.take());
        self.settled.forget();
    }

    fn remarks(&self) -> Vec<Notice> {
        let components = self.current(&self.components);
        let of_files = components
            .into_iter()
            .flatten()
            .flat_map(|one| &one.notices);
        let placed = self.current(&self.placed);
        let of_sizes = placed.into_iter().flat_map(|placed| &placed.remarks);
        let settled = self.current(&self.settled);
        let of_count = settled.and_then(|settled| sparse(settled.bodies()));
        of_files.chain(of_sizes).cloned().chain(of_count).collect()
    }

    fn is_moving(&self) -> bool {
        self.at() == Some(REFINE) && self.is_fresh(&self.dressed)
    }
}

impl PileStages {
    fn make_components(&mut self) -> Option<()> {
        let (loaded, kept) = (self.shared.files.loaded.made()?, &mut self.kept);
        self.components
            .advance(|params, work| ComponentsMaking::advance(params, work, loaded, kept))
    }

    fn make_dressed(&mut self) -> Option<()> {
        let components = self.components.made()?;
        self.dressed
            .advance(|params, work| Dressing::advance(params, work, components))
    }

    fn make_site(&mut self) -> Option<()> {
        let loaded = self.shared.files.loaded.made()?;
        self.site
            .advance(|params, work| SiteMaking::advance(params, work, loaded))
    }

    fn make_ground(&mut self) -> Option<()> {
        let (components, site) = (self.components.made()?, self.site.made()?);
        self.ground.advance(|params, work| {
            let new = || BareSurface::new(&site.mesh, site.fit(room(params, components)));
            let ground = work.get_or_insert_with(new);
            let done = ground.advance(&site.mesh);
            Ok(if done { work.take() } else { None })
        })
    }

    fn make_darts(&mut self) -> Option<()> {
        let from = (self.components.made()?, self.site.made()?);
        self.placed
            .advance(|params, work| Placing::advance(params, work, from))
    }

    fn settled_from(&self) -> SettledFrom {
        let inputs = [self.placed.revision(), self.site.revision()];
        (inputs, *self.settled.params())
    }

    fn refine(&mut self) -> Option<()> {
        let from = self.settled_from();
        let known = self.known.as_ref().filter(|(of, _)| *of == from);
        let known = known.map(|(_, bodies)| bodies.clone());
        let (placed, site) = (self.placed.made()?, self.site.made()?);
        self.settled.advance(|&params, work| {
            let new = || {
                let walls = site.walls.clone();
                let Placed {
                    kinds,
                    darts,
                    stays,
                    ..
                } = placed;
                let run = Refining::new(&site.mesh, darts, stays, kinds.clone(), walls, params);
                run.recalling(known)
            };
            let refining = work.get_or_insert_with(new);
            let step = (placed.darts.len() / STEPS).clamp(1, MOST);
            let done = refining.advance(&site.mesh, &site.search, step);
            Ok(if done { work.take() } else { None })
        })
    }

    /// The parts of this pile's scene, once all of them are there.
    pub(super) fn parts(&self) -> Option<HeapParts<'_>> {
        Some(HeapParts {
            site: self.site.made()?,
            ground: self.ground.made()?,
            kinds: &self.placed.made()?.kinds,
            dressed: self.dressed.made()?,
            dress: self.dressed.params(),
            look: self.shared.bodies.params(),
        })
    }

    fn make_bodies(&mut self) -> Option<()> {
        let settled = self.settled.made()?;
        let parts = HeapParts {
            site: self.site.made()?,
            ground: self.ground.made()?,
            kinds: &self.placed.made()?.kinds,
            dressed: self.dressed.made()?,
            dress: self.dressed.params(),
            look: &self.shared.bodies.params().clone(),
        };
        let revision = self.settled.revision();
        self.shared.bodies.advance(|_, work| {
            let Some(mut heap) = work.take() else {
                *work = Some(Heap::new(parts));
                return Ok(None);
            };
            heap.update(parts, settled.bodies(), settled.history());
            Ok(Some(MadeScene::new(Rc::new(heap.finish()), revision)))
        })
    }
}
