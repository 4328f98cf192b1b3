//! The scene of a wall on its ground, in its weather. It shares the bodies of both, so that another weather lays no
//! block again.

use super::grain::WallGrain;
use super::params::LookParams;
use super::site::BuildingSite;
use super::weather::Weather;
use crate::scene::{Instance, Scene};

/// The reach of ambient occlusion (metres).
const REACH: f64 = 0.09;

/// A scene that grows with a wall.
pub(crate) struct WallScene {
    scene: Scene,
    /// How many bodies and instances are the ground's; those of the wall follow.
    ground: [usize; 2],
}

impl WallScene {
    /// The ground alone.
    pub(super) fn new(site: &BuildingSite, ground: &Scene, look: &LookParams) -> Self {
        let weather = Weather::new(look.weather, site);
        let grain = WallGrain::new(look.seed, site.fit.scale, weather, look.ground);
        Self {
            scene: Scene {
                bodies: ground.bodies.clone(),
                instances: ground.instances.clone(),
                detail: Some(Box::new(grain)),
                reach: (REACH * site.fit.scale) as f32,
                ..Scene::default()
            },
            ground: [ground.bodies.len(), ground.instances.len()],
        }
    }

    /// Adds what the wall has and this scene has not.
    pub(super) fn follow(&mut self, wall: &Scene) {
        let [bodies, instances] = self.ground;
        let known = [
            self.scene.bodies.len() - bodies,
            self.scene.instances.len() - instances,
        ];
        self.scene
            .bodies
            .extend_from_slice(&wall.bodies[known[0]..]);
        let placed = wall.instances[known[1]..].iter();
        self.scene.instances.extend(placed.map(|instance| Instance {
            body: instance.body + bodies as u32,
            ..*instance
        }));
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
