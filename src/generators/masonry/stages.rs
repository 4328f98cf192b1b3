//! The stages of masonry, as a table of tasks.

use super::blocks::Wall;
use super::files::BuildingSaving;
use super::ground::GroundWork;
use super::kept::{KeptBlocks, LastWall, marks};
use super::params::{
    BlockParams, BuildingParams, GroundParams, LookParams, MasonryParams, PatternParams,
};
use super::setting::WallScene;
use super::shapes::WallShapes;
use super::site::{BuildingSite, SiteBuild};
use super::{sentences, views};
use crate::building::Building;
use crate::generators::scene_picture::{MadeScene, SceneStages, SharedNodes};
use crate::graph::{Node, Task, Wiring, task};
use crate::masonry::laying::{Laying, MasonryCell};
use crate::masonry::plan::{PlanFault, PlanMaking};
use crate::notice::Notice;
use crate::recipe::Recipe;
use crate::scene::{Scene, SceneDigest};
use std::rc::Rc;
use std::sync::Arc;

/// The words of the stages.
pub(super) const WORDS: [&str; 5] = ["building", "cells", "laying", "bodies", "light"];

/// The index of the stage that lays blocks.
pub(super) const LAYING: usize = 2;
/// The index of the finished blocks, the first stage of the finisher.
pub(super) const BLOCKS: usize = 3;

/// The approximate number of steps in which all blocks are laid.
const STEPS: usize = 160;
/// The most blocks in one step.
const MOST: usize = 60;
/// Blocks that look as they did before an edit are laid this many times faster.
const KEPT: usize = 8;
/// About this many words of a scene are hashed in a slice.
const WORDS_IN_A_SLICE: usize = 400_000;

/// The finished scene, while its digest is made.
pub(crate) type BlocksWork = (Rc<Scene>, SceneDigest);

/// Cells in the making.
pub(super) enum CellsWork {
    /// The plan of this building is being made.
    Plan(Arc<Building>, Box<PlanMaking>),
    /// The cells themselves are being laid.
    Cells(Box<Laying>),
}

impl CellsWork {
    /// Begins with the plan of the building, after the flips of corners and edges.
    fn begun(site: &BuildingSite, params: &PatternParams) -> Self {
        let flips = &params.flips;
        let building = Arc::new(site.building.flipped(&flips.corners, &flips.edges));
        let depths = site.thickness.iter().map(|thickness| 0.5 * thickness);
        let plan = PlanMaking::new(building.clone(), params.laying.module, depths.collect());
        Self::Plan(building, Box::new(plan))
    }

    /// Goes on with a plan. Once the plan is whole, begins with the cells.
    fn plan(
        building: Arc<Building>,
        mut plan: Box<PlanMaking>,
        params: &PatternParams,
    ) -> Result<Self, PlanFault> {
        Ok(match plan.advance()? {
            Some(plan) => {
                let tree = params.tree.tree();
                let laying = Laying::planned(building, tree, params.laying, plan);
                Self::Cells(Box::new(laying))
            }
            None => Self::Plan(building, plan),
        })
    }
}

/// The nodes of the stages, and the files given for them.
pub(crate) struct MasonryStages {
    pub(super) shared: SharedNodes<LookParams, BlocksWork>,
    pub(super) site: Node<BuildingParams, SiteBuild, BuildingSite>,
    pub(super) cells: Node<PatternParams, CellsWork, Laying>,
    pub(super) ground: Node<GroundParams, GroundWork, Scene>,
    /// The scene of the wall, without its ground.
    pub(super) laid: Node<BlockParams, Wall, Scene>,
    /// The last finished wall. `None` before the first one, and when the steps are made again without an edit.
    last: Option<LastWall>,
    /// The shapes of the last finished wall's blocks, also when the steps are made again: that takes no stonecutting.
    shapes: Option<Rc<WallShapes>>,
    /// Blocks of the last wall that stay in sight while the new wall is laid.
    pub(super) kept: KeptBlocks,
}

impl Wiring for MasonryStages {
    type Stage = usize;

    const TASKS: &'static [Task<Self>] = &[
        task!(
            0,
            shared.files.loaded,
            |all| all.shared.files.inputs(),
            |all| all.shared.files.wait()
        ),
        task!(0, site, [shared.files.loaded], Self::make_site),
        task!(1, cells, [site], Self::make_cells),
        task!(LAYING, ground, [site], Self::make_ground),
        task!(LAYING, laid, [site, cells], Self::lay),
        task!(BLOCKS, shared.bodies, [ground, laid], Self::make_blocks),
        task!(4, shared.still, [shared.bodies], |all| all.shared.draw()),
    ];
}

impl SceneStages for MasonryStages {
    type Look = LookParams;
    type Finishing = BlocksWork;
    type Saving = BuildingSaving;

    const FINISHER: usize = BLOCKS;
    const VIEWS: &'static [&'static str] = &views::WORDS;

    fn new(recipe: &Recipe) -> Self {
        let params = MasonryParams::new(recipe);
        Self {
            site: Node::new(params.building),
            cells: Node::new(params.cells),
            ground: Node::new(params.look.ground()),
            laid: Node::new(params.blocks),
            shared: SharedNodes::new(params.files, params.look, params.still),
            last: None,
            shapes: None,
            kept: KeptBlocks::default(),
        }
    }

    fn shared(&self) -> &SharedNodes<LookParams, BlocksWork> {
        &self.shared
    }

    fn shared_mut(&mut self) -> &mut SharedNodes<LookParams, BlocksWork> {
        &mut self.shared
    }

    fn ask(&mut self, recipe: &Recipe) {
        let params = MasonryParams::new(recipe);
        self.site.ask(params.building);
        self.cells.ask(params.cells);
        self.ground.ask(params.look.ground());
        self.laid.ask(params.blocks);
        self.shared.ask(params.files, params.look, params.still);
    }

    fn forget_steps(&mut self) {
        self.laid.forget();
        self.last = None;
    }

    fn remarks(&self) -> Vec<Notice> {
        let (Some(site), Some(laying)) = (self.site.made(), self.laying()) else {
            return Vec::new();
        };
        let gone = self.cells.params().flips.gone(&site.building);
        let laid = sentences::remarks(laying, (gone, site.is_given));
        [site.remarks.clone(), laid].concat()
    }

    fn is_moving(&self) -> bool {
        self.at() == Some(LAYING) && self.is_fresh(&self.ground)
    }
}

impl MasonryStages {
    fn make_site(&mut self) -> Option<()> {
        let files = &self.shared.files;
        self.site.advance(|params, work| {
            let bytes = match params.rule {
                Some(_) => None,
                None => Some(files.bytes(0)?),
            };
            let bytes = bytes.as_ref().map(|bytes| bytes.as_slice());
            SiteBuild::advance(params, work, bytes)
        })
    }

    fn make_cells(&mut self) -> Option<()> {
        let site = self.site.made()?;
        self.cells.advance(|params, work| {
            let next = match work.take() {
                None => CellsWork::begun(site, params),
                Some(CellsWork::Plan(building, plan)) => CellsWork::plan(building, plan, params)
                    .map_err(|fault| sentences::refusal(&fault, params.laying.module.half))?,
                Some(CellsWork::Cells(mut laying)) => {
                    if laying.advance(1) {
                        return Ok(Some(*laying));
                    }
                    CellsWork::Cells(laying)
                }
            };
            *work = Some(next);
            Ok(None)
        })
    }

    fn make_ground(&mut self) -> Option<()> {
        let site = self.site.made()?;
        self.ground.advance(|params, work| {
            let work = work.get_or_insert_with(|| GroundWork::new(site, params));
            Ok(work.advance(site))
        })
    }

    /// Lays some blocks of one pass, so that each pass ends with a step. After an edit, blocks that look as before
    /// hardly count towards a step.
    fn lay(&mut self) -> Option<()> {
        let (site, cells) = (self.site.made()?, self.cells.made()?.cells());
        if self.begun(&self.laid).is_none() {
            self.kept = self.standing().unwrap_or_default();
        }
        let kept = &self.kept;
        let known = &self.shapes;
        let mut finished = None;
        self.laid.advance(|params, work| {
            let wall = work.get_or_insert_with(|| Wall::new(site, params, cells, known.clone()));
            let end = wall.shown() + in_a_step(cells, wall.shown(), kept);
            wall.lay(cells, end);
            if end < cells.len() {
                return Ok(None);
            }
            let Some((scene, shapes)) = work.take().map(Wall::finish) else {
                return Ok(None);
            };
            let last = LastWall {
                marks: marks(cells),
                params: *params,
                fit: site.fit,
            };
            finished = Some((last, shapes));
            Ok(Some(scene))
        })?;
        if let Some((last, shapes)) = finished {
            (self.last, self.shapes) = (Some(last), Some(shapes));
        }
        Some(())
    }

    /// The blocks of the last wall that stand where new ones will.
    fn standing(&self) -> Option<KeptBlocks> {
        let (site, cells) = (self.site.made()?, self.cells.made()?.cells());
        let last = (self.last.as_ref()?, self.laid.made()?);
        let look = (self.laid.params(), site.fit);
        Some(KeptBlocks::new(last, cells, look))
    }

    /// The cells of the present building. Those of an earlier one name faces that the present one may not have.
    pub(super) fn laying(&self) -> Option<&Laying> {
        self.current(&self.cells)
    }

    /// The wall that is being laid, or the laid one.
    pub(super) fn wall(&self) -> Option<&Scene> {
        let laid = self.current(&self.laid);
        let laid = laid.filter(|_| self.is_fresh(&self.laid));
        self.begun(&self.laid).map(Wall::scene).or(laid)
    }

    /// Whether the last finished blocks may stand in for those to be laid.
    pub(super) fn has_last(&self) -> bool {
        self.last.is_some() && self.shared.scene().is_some()
    }

    fn make_blocks(&mut self) -> Option<()> {
        let (site, ground) = (self.site.made()?, self.ground.made()?);
        let (wall, cells) = (self.laid.made()?, self.cells.made()?.cells());
        let revision = self.laid.revision();
        self.shared.bodies.advance(|look, work| {
            let Some((scene, digest)) = work else {
                let none = KeptBlocks::default();
                let mut scene = WallScene::new(site, ground, look, (marks(cells), &none));
                scene.follow(wall, &[]);
                *work = Some((Rc::new(scene.finish()), SceneDigest::new()));
                return Ok(None);
            };
            let done = digest.advance(scene, WORDS_IN_A_SLICE);
            Ok(done.map(|digest| MadeScene {
                scene: scene.clone(),
                digest,
                shows: revision,
            }))
        })
    }

    /// How often work on the blocks, and on the ground, was begun.
    pub(super) fn pass(&self) -> [u64; 2] {
        [self.laid.passes(), self.ground.passes()]
    }

    /// The number of finished blocks.
    pub(super) fn finished(&self) -> usize {
        match (self.at(), self.begun(&self.laid)) {
            (Some(at), _) if at < LAYING => 0,
            (_, Some(wall)) => wall.shown(),
            _ if !self.is_fresh(&self.laid) => 0,
            _ => self.laying().map_or(0, |laying| laying.cells().len()),
        }
    }
}

/// The number of cells after the first `shown` that are laid in the next step. All belong to one pass.
fn in_a_step(cells: &[MasonryCell], shown: usize, kept: &KeptBlocks) -> usize {
    let most = (cells.len() / STEPS).clamp(1, MOST);
    let left = cells.get(shown..).unwrap_or_default();
    let pass = left.first().map(MasonryCell::pass);
    let own = left.iter().take_while(|cell| Some(cell.pass()) == pass);
    let mut seen = 0;
    let laid = own
        .zip(shown..)
        .take(KEPT * most)
        .take_while(|(_, number)| {
            seen += usize::from(!kept.has(*number));
            seen <= most
        });
    laid.count()
}
