//! The stages of masonry, as a table of tasks.

use super::MASONRY;
use super::blocks::Wall;
use super::ground::GroundWork;
use super::params::{
    BlockParams, BuildingParams, GroundParams, LookParams, MasonryParams, PatternParams,
};
use super::sentences;
use super::setting::WallScene;
use super::site::{BuildingSite, SiteBuild};
use crate::generators::scene_picture::{
    MadeScene, ModelFiles, SceneStages, StillNode, StillParams, StillRender,
};
use crate::graph::{Node, Task, Wiring, task};
use crate::masonry::laying::{Laying, MasonryCell};
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

/// The steps in which all blocks are laid, about, ...
const STEPS: usize = 160;
/// ... and the most blocks in one step.
const MOST: usize = 60;
/// Words of a scene that are hashed in a slice, about.
const WORDS_IN_A_SLICE: usize = 400_000;

/// The finished scene, while its digest is made.
type BlocksWork = (Rc<Scene>, SceneDigest);

/// The nodes of the stages, and the files given for them.
pub(crate) struct MasonryStages {
    files: ModelFiles,
    pub(super) site: Node<BuildingParams, SiteBuild, BuildingSite>,
    pub(super) cells: Node<PatternParams, Laying, Laying>,
    pub(super) ground: Node<GroundParams, GroundWork, Scene>,
    /// The bodies of the wall alone.
    pub(super) laid: Node<BlockParams, Wall, Scene>,
    pub(super) blocks: Node<LookParams, BlocksWork, MadeScene>,
    pub(super) still: StillNode,
}

impl Wiring for MasonryStages {
    type Stage = usize;

    const TASKS: &'static [Task<Self>] = &[
        task!(0, files.loaded, |all| all.files.inputs(), |all| all
            .files
            .wait()),
        task!(0, site, [files.loaded], Self::make_site),
        task!(1, cells, [site], Self::make_cells),
        task!(LAYING, ground, [site], Self::make_ground),
        task!(LAYING, laid, [site, cells], Self::lay),
        task!(BLOCKS, blocks, [ground, laid], Self::make_blocks),
        task!(4, still, [blocks], Self::make_still),
    ];
}

/// Camera and light of the picture.
fn still(params: &MasonryParams) -> StillParams {
    StillParams {
        camera: MASONRY.camera(),
        light: params.light(),
        yaw: params.yaw,
        side: params.side,
    }
}

impl SceneStages for MasonryStages {
    const FINISHER: usize = BLOCKS;

    fn ask(&mut self, recipe: &Recipe) {
        let params = MasonryParams::new(recipe);
        self.still.ask(still(&params));
        self.files.loaded.ask(params.files);
        self.site.ask(params.building);
        self.cells.ask(params.cells);
        self.ground.ask(params.look.ground());
        self.laid.ask(params.blocks);
        self.blocks.ask(params.look);
    }

    fn forget(&mut self) {
        self.site.forget();
    }

    fn remarks(&self) -> Vec<Notice> {
        let (Some(site), Some(laying)) = (self.site.made(), self.cells.made()) else {
            return Vec::new();
        };
        let gone = self.cells.params().flips.gone(&site.building);
        let laid = sentences::remarks(laying, (gone, site.is_given));
        [site.remarks.clone(), laid].concat()
    }

    fn files(&self) -> &ModelFiles {
        &self.files
    }

    fn files_mut(&mut self) -> &mut ModelFiles {
        &mut self.files
    }

    fn still(&self) -> &StillNode {
        &self.still
    }

    fn is_moving(&self) -> bool {
        self.at() == Some(LAYING) && self.is_fresh(&self.ground)
    }

    fn digest(&self) -> String {
        let blocks = self.blocks.made();
        blocks.map_or(String::new(), |blocks| blocks.digest.clone())
    }
}

impl MasonryStages {
    /// Starts with nothing made.
    pub(super) fn new(params: &MasonryParams) -> Self {
        Self {
            files: ModelFiles::new(params.files.clone()),
            site: Node::new(params.building.clone()),
            cells: Node::new(params.cells.clone()),
            ground: Node::new(params.look.ground()),
            laid: Node::new(params.blocks),
            blocks: Node::new(params.look),
            still: Node::new(still(params)),
        }
    }

    fn make_site(&mut self) -> Option<()> {
        let files = &self.files;
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
            if work.is_none() {
                let tree = params.tree.tree();
                let thickness = |face: crate::building::FaceId| site.thickness[face.index()];
                let flips = &params.flips;
                let building = Arc::new(site.building.flipped(&flips.corners, &flips.edges));
                let laying = Laying::new(building, tree, params.laying, thickness);
                *work = Some(
                    laying
                        .map_err(|fault| sentences::refusal(&fault, params.laying.module.half))?,
                );
                return Ok(None);
            }
            let done = work.as_mut().is_some_and(|laying| laying.advance(1));
            Ok(if done { work.take() } else { None })
        })
    }

    fn make_ground(&mut self) -> Option<()> {
        let site = self.site.made()?;
        self.ground.advance(|params, work| {
            let work = work.get_or_insert_with(|| GroundWork::new(site, params));
            Ok(work.advance(site))
        })
    }

    /// Lays some blocks of one pass, so that each pass ends with a step.
    fn lay(&mut self) -> Option<()> {
        let (site, cells) = (self.site.made()?, self.cells.made()?.cells());
        self.laid.advance(|params, work| {
            let wall = work.get_or_insert_with(|| Wall::new(site, params));
            let step = (cells.len() / STEPS).clamp(1, MOST);
            let left = cells.get(wall.shown()..).unwrap_or_default();
            let pass = left.first().map(MasonryCell::pass);
            let own = left.iter().take_while(|cell| Some(cell.pass()) == pass);
            let end = wall.shown() + own.take(step).count();
            wall.lay(cells, end);
            let is_done = end >= cells.len();
            let finished = if is_done { work.take() } else { None };
            Ok(finished.map(Wall::finish))
        })
    }

    fn make_blocks(&mut self) -> Option<()> {
        let (site, ground) = (self.site.made()?, self.ground.made()?);
        let wall = self.laid.made()?;
        let revision = self.laid.revision();
        self.blocks.advance(|look, work| {
            let Some((scene, digest)) = work else {
                let mut scene = WallScene::new(site, ground, look);
                scene.follow(wall);
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

    fn make_still(&mut self) -> Option<()> {
        let scene = &self.blocks.made()?.scene;
        StillRender::draw(&mut self.still, scene)
    }

    /// The passes of the work on blocks and on the ground.
    pub(super) fn pass(&self) -> [u64; 2] {
        [self.laid.passes(), self.ground.passes()]
    }

    /// Whether there is a scene of the present blocks, even if another look is wanted.
    pub(super) fn has_blocks(&self) -> bool {
        let is_laid = self.is_fresh(&self.laid);
        let blocks = self.blocks.made().filter(|_| is_laid);
        blocks.is_some_and(|blocks| blocks.shows == self.laid.revision())
    }

    /// The number of finished blocks.
    pub(super) fn finished(&self) -> usize {
        match (self.at(), self.begun(&self.laid)) {
            (Some(at), _) if at < LAYING => 0,
            (_, Some(wall)) => wall.shown(),
            _ if !self.is_fresh(&self.laid) => 0,
            _ => self.cells.made().map_or(0, |laying| laying.cells().len()),
        }
    }
}
