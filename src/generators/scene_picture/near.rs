//! A part of a scene, turned and enlarged so that some of its bodies are seen from near.

use crate::scene::{Detail, Instance, Place, Scene, Surfel};
use glam::Vec3;
use std::rc::Rc;

/// The instances that `is_shown` accepts, and all lines, moved by `place`, whose axes have the length `scale`. Their
/// details stay those of the whole scene.
pub(crate) fn seen_near(
    all: &Rc<Scene>,
    (place, scale): (Place, f32),
    is_shown: impl Fn(&Instance) -> bool,
) -> Scene {
    let mut scene = Scene {
        lines: all
            .lines
            .iter()
            .map(|ends| ends.map(|p| place.of(p)))
            .collect(),
        detail: Some(Box::new(Moved {
            scene: all.clone(),
            place,
            scale,
        })),
        reach: all.reach * scale,
        ..Scene::default()
    };
    for instance in all.instances.iter().filter(|instance| is_shown(instance)) {
        let body = scene.bodies.len() as u32;
        scene
            .bodies
            .push(all.bodies[instance.body as usize].clone());
        scene.instances.push(Instance {
            body,
            place: Place {
                axes: instance.place.axes.map(|axis| place.turned(axis)),
                origin: place.of(instance.place.origin),
            },
            ..*instance
        });
    }
    scene
}

/// The details of a scene that is turned, scaled and moved.
struct Moved {
    scene: Rc<Scene>,
    place: Place,
    scale: f32,
}

impl Detail for Moved {
    fn refine(&self, surfel: &mut Surfel, id: u32, spread: f32) {
        let Some(detail) = &self.scene.detail else {
            return;
        };
        let Place { axes, origin } = self.place;
        let unit = axes.map(|axis| axis / self.scale);
        let back = |v: Vec3| Vec3::from(unit.map(|axis| axis.dot(v)));
        let mut own = *surfel;
        own.position = back(surfel.position - origin) / self.scale;
        own.normal = back(surfel.normal);
        detail.refine(&mut own, id, spread / self.scale);
        let [x, y, z] = unit;
        *surfel = Surfel {
            position: surfel.position,
            normal: x * own.normal.x + y * own.normal.y + z * own.normal.z,
            ..own
        };
    }
}
