//! The scene of a wall on its ground, in its weather. It shares the bodies of wall and ground, so that a change of
//! weather lays no block again.

use super::grain::WallGrain;
use super::kept::KeptBlocks;
use super::params::LookParams;
use super::site::BuildingSite;
use super::weather::Weather;
use crate::scene::{Instance, Scene};

/// The reach of ambient occlusion (metres).
const REACH: f64 = 0.09;

/// A scene that grows with a wall.
pub(crate) struct WallScene {
    scene: Scene,
    /// The number of bodies before those of the wall, and the number of instances of the ground.
    ground: [usize; 2],
    /// The number of bodies of the ground. Bodies of kept blocks follow them.
    of_ground: usize,
    /// The number of instances at the end that are kept blocks.
    kept: usize,
}

impl WallScene {
    /// The ground alone. `marks` are those of all blocks that will be added, in their order; `kept` are blocks of the
    /// last wall that may stand in for those not laid yet.
    pub(super) fn new(
        site: &BuildingSite,
        ground: &Scene,
        look: &LookParams,
        (marks, kept): (Vec<u32>, &KeptBlocks),
    ) -> Self {
        let weather = Weather::new(look.weather, site);
        let grain = WallGrain::new((look.seed, site.fit.scale), weather, look.ground, marks);
        let bodies = [&ground.bodies, kept.bodies()].concat();
        Self {
            ground: [bodies.len(), ground.instances.len()],
            of_ground: ground.bodies.len(),
            kept: 0,
            scene: Scene {
                bodies,
                instances: ground.instances.clone(),
                detail: Some(Box::new(grain)),
                reach: (REACH * site.fit.scale) as f32,
                ..Scene::default()
            },
        }
    }

    /// Adds the bodies and blocks of the wall that are new since the last call. `kept` replaces the kept blocks shown
    /// so far.
    pub(super) fn follow(&mut self, wall: &Scene, kept: &[Instance]) {
        let [bodies, instances] = self.ground;
        let shown = self.scene.instances.len() - self.kept;
        self.scene.instances.truncate(shown);
        let known = [self.scene.bodies.len() - bodies, shown - instances];
        self.scene
            .bodies
            .extend_from_slice(&wall.bodies[known[0]..]);
        let placed = wall.instances[known[1]..].iter();
        let placed = placed.map(|block| (block, bodies));
        let stood = kept.iter().map(|block| (block, self.of_ground));
        let all = placed.chain(stood).map(|(block, first)| Instance {
            body: block.body + first as u32,
            ..*block
        });
        self.scene.instances.extend(all);
        self.kept = kept.len();
    }

    /// The scene so far.
    pub(super) fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The scene, to keep.
    pub(super) fn finish(self) -> Scene {
        self.scene
    }
}
