//! Lays the cells of a building: corners, then edges, then faces.
//!
//! Legakis, Dorsey, Gortler (2001), section 4.2: cells of corners are the most constrained, and those of faces the
//! least, so corners come first and faces last. Each feature is passed down the pattern tree, and each generator that
//! it reaches lays cells where its occupancy map is free. A cell claims its space on all features that it touches.

mod answers;
mod arches;
mod ashlar;
#[cfg(test)]
mod ashlar_tests;
mod bond;
mod bricks;
mod cell;
mod cement;
mod chords;
mod coping;
mod corners;
mod cuts;
#[cfg(test)]
mod drawn_tests;
mod faces;
#[cfg(test)]
mod invariance_tests;
#[cfg(test)]
mod joint_tests;
mod joints;
mod measures;
mod mitre;
mod overhang;
mod panels;
mod phases;
mod pointing;
mod quoins;
mod raking;
#[cfg(test)]
mod random_tests;
mod rectangles;
mod rim;
#[cfg(test)]
mod roof_tests;
mod run;
mod seen;
mod site;
#[cfg(test)]
mod step_tests;
#[cfg(test)]
mod tests;
mod tiles;
mod tops;
mod weave;
mod work;

pub use cell::{CellSort, Feature, LayingPass, MasonryCell};
pub use measures::Measures;
pub use pointing::Pointing;
pub use seen::view;

use super::plan::{Plan, PlanFault};
use super::tree::{GeneratorNode, PatternGenerator, PatternTree};
use crate::building::{Building, EdgeId, FaceId, Module};
use ashlar::AshlarWork;
use bricks::BrickBond;
use faces::BrickWork;
use phases::PhaseWork;
use site::{PIXELS, Site};
use std::sync::Arc;
use tiles::TileWork;
use work::{MapWork, SiteWork};

/// The parameters of the laying.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LayingParams {
    /// The pattern's unit.
    pub module: Module,
    /// If true, only the bits that the building stores with corners and edges decide which way bricks point, as in the
    /// paper (section 5.2). If false, phases are solved for, and a bit turns the bricks of its own edge.
    pub is_by_hand: bool,
    /// The seed.
    pub seed: u64,
}

/// Something in the pattern tree that did not work.
#[derive(Clone, Debug, PartialEq)]
pub enum LayingWarning {
    /// A feature came to a generator that does not lay cells on its type.
    Unexpected {
        /// The feature.
        feature: Feature,
        /// The path of the generator's node.
        path: String,
    },
    /// A feature came to a generator that is not implemented for its type.
    NotLaid {
        /// The feature.
        feature: Feature,
        /// The generator.
        generator: PatternGenerator,
    },
    /// A panel does not fit on a face, which goes on down the tree without it.
    NoRoom {
        /// The face.
        face: FaceId,
    },
}

/// Cells that are laid feature by feature.
pub struct Laying {
    tree: PatternTree,
    params: LayingParams,
    site: Site,
    order: Vec<Feature>,
    /// The number of the next turn. Faces have a second turn after the first ones of all features.
    next: usize,
    /// Work that is not finished, the next one last.
    open: Vec<Box<dyn SiteWork>>,
    /// The nodes that the current feature has reached and whose turn has not come, the next one last. Each stands with
    /// the feature, and with its number among the nodes reached.
    nodes: Vec<(Feature, usize, GeneratorNode)>,
    /// The features that some generator has reached.
    textured: Vec<Feature>,
    warnings: Vec<LayingWarning>,
}

impl Laying {
    /// Begins. `thickness` gives the thickness of the wall behind each face (metres); cells take half of it at most.
    ///
    /// # Errors
    /// If the module does not suit the building.
    pub fn new(
        building: Arc<Building>,
        tree: PatternTree,
        params: LayingParams,
        thickness: impl Fn(FaceId) -> f64,
    ) -> Result<Self, PlanFault> {
        let plan = Plan::new(&building, params.module, |face| 0.5 * thickness(face))?;
        Ok(Self::planned(building, tree, params, plan))
    }

    /// Begins with a plan for the module of `params`.
    pub fn planned(
        building: Arc<Building>,
        tree: PatternTree,
        params: LayingParams,
        plan: Plan,
    ) -> Self {
        let corners = building.corner_ids().map(Feature::Corner);
        let edges = building.edge_ids().map(Feature::Edge);
        let faces = building.face_ids().map(Feature::Face);
        let order = corners.chain(edges).chain(faces).collect();
        let site = Site::new(building, plan, PIXELS);
        let phases = PhaseWork::new(&site);
        Self {
            order,
            site,
            open: vec![Box::new(phases), Box::new(MapWork::default())],
            nodes: Vec::new(),
            tree,
            params,
            next: 0,
            textured: Vec::new(),
            warnings: Vec::new(),
        }
    }

    /// Does `amount` parts of the work, at least one: each makes a face's map, or lays an edge, a corner, or a row of a
    /// face. Returns whether nothing is left.
    pub fn advance(&mut self, amount: usize) -> bool {
        for _ in 0..amount.max(1) {
            self.advance_part();
        }
        self.open.is_empty() && self.nodes.is_empty() && self.turn(self.next).is_none()
    }

    fn advance_part(&mut self) {
        if let Some(mut work) = self.open.pop() {
            if !work.advance(&mut self.site) {
                self.open.push(work);
            }
        } else if let Some((feature, number, node)) = self.nodes.pop() {
            self.site.reached = number;
            self.generate(feature, &node);
        } else if let Some((feature, pass)) = self.turn(self.next) {
            self.next += 1;
            self.pass_down(feature, pass);
        }
    }

    /// The feature of a turn, and the pass in which it lays cells. Faces lay only their panels in their first turn, and
    /// have another turn at the end.
    fn turn(&self, turn: usize) -> Option<(Feature, LayingPass)> {
        let Some(&feature) = self.order.get(turn) else {
            let again = turn - self.building().faces().len();
            let feature = self.order.get(again)?;
            return Some((*feature, LayingPass::Faces));
        };
        let pass = match feature {
            Feature::Corner(_) => LayingPass::Corners,
            Feature::Edge(_) => LayingPass::Edges,
            Feature::Face(_) => LayingPass::Panels,
        };
        Some((feature, pass))
    }

    /// All features, in the order of their first turns.
    pub fn order(&self) -> &[Feature] {
        &self.order
    }

    /// The cells so far, in the order in which they were laid.
    pub fn cells(&self) -> &[MasonryCell] {
        &self.site.cells
    }

    /// The plan.
    pub fn plan(&self) -> &Plan {
        &self.site.plan
    }

    /// The building.
    pub fn building(&self) -> &Building {
        &self.site.building
    }

    /// The warnings so far.
    pub fn warnings(&self) -> &[LayingWarning] {
        &self.warnings
    }

    /// The occupancy map of a face.
    pub fn face_map(&self, face: FaceId) -> &super::occupancy::FaceMap {
        &self.site.faces[face.index()]
    }

    /// The occupancy map of an edge.
    pub fn edge_map(&self, edge: EdgeId) -> &super::occupancy::EdgeMap {
        &self.site.edges[edge.index()]
    }

    /// The faces that some generator has reached.
    pub fn textured_faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        self.textured.iter().filter_map(|&feature| match feature {
            Feature::Face(face) => Some(face),
            _ => None,
        })
    }

    /// Passes a feature down the tree, and keeps those of the nodes reached that lay their cells in this pass.
    fn pass_down(&mut self, feature: Feature, pass: LayingPass) {
        let building = self.site.building.clone();
        let walk = self.tree.walk(&view(&building, feature));
        if pass != LayingPass::Faces {
            let mut reached = walk.reached.iter();
            if reached.any(|reached| self.covers(feature, reached.node)) {
                self.textured.push(feature);
            }
            let told = walk.unexpected.iter().map(|at| LayingWarning::Unexpected {
                feature,
                path: at.path.clone(),
            });
            self.warnings.extend(told);
        }
        let nodes = walk.reached.iter().enumerate();
        let own = nodes.filter(|(_, at)| LayingPass::of(feature, at.node.generator) == pass);
        let own = own.map(|(number, at)| (feature, number, at.node.clone()));
        self.nodes = own.rev().collect();
    }

    /// Whether a generator covers a feature: tiles leave the undersides and the ends of a roof bare.
    fn covers(&self, feature: Feature, node: &GeneratorNode) -> bool {
        match feature {
            Feature::Face(id) => node.generator != PatternGenerator::Tiles || self.site.is_roof(id),
            _ => true,
        }
    }

    fn generate(&mut self, feature: Feature, node: &GeneratorNode) {
        use PatternGenerator::{
            ArchBricks, ArchStones, Bricks, CementStones, Coping, Panel, Quoins, Raking,
            RandomAshlar, RgbBlocks, StepCorners, Tiles, WindowBottomBricks,
        };
        let is_by_hand = self.params.is_by_hand;
        let bricks = BrickBond {
            is_by_hand,
            ..BrickBond::BRICKS
        };
        let (site, seed) = (&mut self.site, self.params.seed);
        let open = &mut self.open;
        match (node.generator, feature) {
            (Bricks, Feature::Corner(id)) => site.brick_corner(id, node, &bricks),
            (Bricks, Feature::Edge(id)) => site.brick_edge(id, node, &bricks),
            (Bricks, Feature::Face(id)) => {
                open.push(Box::new(BrickWork::new(site, id, node, bricks)));
            }
            (RgbBlocks, Feature::Corner(id)) => site.brick_corner(id, node, &BrickBond::BLOCKS),
            (RgbBlocks, Feature::Edge(id)) => site.brick_edge(id, node, &BrickBond::BLOCKS),
            (RgbBlocks, Feature::Face(id)) => {
                let blocks = BrickWork::new(site, id, node, BrickBond::BLOCKS);
                open.push(Box::new(blocks));
            }
            (RandomAshlar, Feature::Corner(id)) => site.ashlar_corner(id, node),
            (RandomAshlar, Feature::Edge(id)) => site.ashlar_edge(id, node, seed),
            (RandomAshlar, Feature::Face(id)) => {
                open.push(Box::new(AshlarWork::new(site, id, node, seed)));
            }
            (WindowBottomBricks, Feature::Corner(id)) => {
                let bond = BrickBond {
                    extrude: node.number("extrude"),
                    ..bricks
                };
                site.brick_corner(id, node, &bond);
            }
            (ArchBricks, Feature::Edge(id)) => site.arch_bricks(id, node, &bricks),
            (ArchStones, Feature::Edge(id)) => site.arch_stones(id, node),
            (WindowBottomBricks, Feature::Edge(id)) => site.sill_edge(id, node),
            (Panel, Feature::Face(id)) if site.panel(id, node) => (),
            (Panel, Feature::Face(face)) => self.warnings.push(LayingWarning::NoRoom { face }),
            (StepCorners, Feature::Corner(id)) => site.step_corner(id, node, &bricks),
            (CementStones, Feature::Corner(id)) => site.cement_corner(id, node),
            (CementStones, Feature::Edge(id)) => site.cement_edge(id, node),
            (Quoins, Feature::Corner(id)) => site.quoin_corner(id, node),
            (Quoins, Feature::Edge(id)) => site.quoin_edge(id, node),
            (Raking, Feature::Edge(id)) => site.raking_bricks(id, node),
            (Coping, Feature::Edge(id)) => site.coping_edge(id, node),
            (Tiles, Feature::Edge(id)) => site.ridge_tiles(id, node),
            (Tiles, Feature::Face(id)) => {
                let tiles = TileWork::new(site, id, node);
                open.extend(tiles.map(|tiles| Box::new(tiles) as _));
            }
            (generator, _) => self
                .warnings
                .push(LayingWarning::NotLaid { feature, generator }),
        }
    }
}
