//! Tests of the finisher with a generator of plain boxes that has no other stages.

use super::picture::ScenePicture;
use super::still::StillRender;
use super::*;
use crate::generators::lighting::LightParams;
use crate::generators::{FrameSlice, TurnOrder};
use crate::light::{Light, ShadeParams};
use crate::material::{Gloss, material_table};
use crate::scene::{Body, Camera, Frame, Instance, Paint, Place, SAMPLES, Scene};
use crate::solid::Surface;
use glam::Vec3;
use std::ops::Range;
use std::rc::Rc;

const SIDE: usize = 64;
const LAMP: Light = Light::Point {
    x: -0.2,
    y: 0.4,
    z: 0.9,
};
pub(super) const RED: Paint = Paint {
    tint: [230, 40, 30],
    material: 1,
};
pub(super) const GREEN: Paint = Paint {
    tint: [30, 200, 60],
    material: 2,
};

/// Two boxes of one mesh, beside each other.
struct Boxes {
    scene: Rc<Scene>,
    picture: ScenePicture<Rc<Scene>>,
    yaw: f64,
    lamp: Light,
}

/// A box of side 2 around the origin, in one colour.
fn cube(colour: [u8; 3]) -> Surface {
    let mut surface = Surface::default();
    let sides = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| [axis, -axis]);
    for normal in sides.into_iter().flatten() {
        let across = Vec3::new(normal.y, normal.z, normal.x);
        let up = normal.cross(across);
        let first = surface.positions.len() as u32;
        for [a, b] in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
            surface.positions.push(normal + across * a + up * b);
            surface.normals.push(normal);
            surface.colours.push(colour);
        }
        surface.triangles.push([first, first + 1, first + 2]);
        surface.triangles.push([first, first + 2, first + 3]);
    }
    surface
}

pub(super) fn scene(paints: [Option<Paint>; 2]) -> Scene {
    let at = |k: usize| Vec3::new(0.6 * k as f32 - 0.3, 0.2, 0.0);
    let instance = |k: usize| Instance {
        body: 0,
        place: Place {
            axes: [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| axis * 0.2),
            origin: at(k),
        },
        id: k as u32 + 1,
        paint: paints[k],
    };
    Scene {
        bodies: vec![Body::new(vec![cube([255; 3])], 1)],
        instances: vec![instance(0), instance(1)],
        reach: 0.2,
        ..Scene::default()
    }
}

fn boxes(paints: [Option<Paint>; 2]) -> Boxes {
    Boxes {
        scene: Rc::new(scene(paints)),
        picture: ScenePicture::default(),
        yaw: 0.0,
        lamp: ShadeParams::default().light,
    }
}

impl SceneSource for Rc<Scene> {
    type View = ();
    type Subject = Rc<Scene>;
    type Making = ();

    fn key(&self, _: &str) -> Option<SceneKey<()>> {
        Some(SceneKey {
            view: (),
            is_live: false,
            site: 1,
            revision: 1,
        })
    }

    fn begin(&self, _: Option<Rc<Scene>>) {}

    fn make(&mut self, _: SceneKey<()>, (): &mut ()) -> Option<Rc<Scene>> {
        Some(self.clone())
    }
}

impl Boxes {
    fn still(&self) -> StillParams {
        StillParams {
            camera: Camera::default().read("0,20,2.5,28").0,
            light: LightParams {
                shade: ShadeParams {
                    light: self.lamp,
                    ..ShadeParams::default()
                },
                materials: material_table("granite", "sand", Gloss::default()),
            },
            yaw: self.yaw,
            side: SIDE,
        }
    }

    fn order(&self, how: &str) -> TurnOrder {
        TurnOrder {
            subject: String::new(),
            camera: self.still().camera,
            size: [SIDE; 2],
            how: how.to_owned(),
        }
    }

    fn turn(&mut self, order: &TurnOrder, budget: f64) -> FrameSlice {
        let still = self.still();
        let of = (&mut self.scene, &still);
        let slice = self.picture.turn(of, order, &mut || 0.0, budget);
        slice.unwrap()
    }

    fn frame(&mut self, how: &str) -> &Frame {
        let order = self.order(how);
        while !self.turn(&order, 0.0).done {}
        self.picture.frame().unwrap()
    }
}

/// The mean colour of the pixels of a body.
fn mean(frame: &Frame, id: u32) -> [f64; 3] {
    let pixels = frame.rgba().chunks(4).zip(frame.ids());
    let own: Vec<&[u8]> = pixels
        .filter(|(_, of)| **of == id)
        .map(|(p, _)| p)
        .collect();
    assert!(own.len() > 50, "{id}: {}", own.len());
    [0, 1, 2].map(|k| own.iter().map(|p| f64::from(p[k])).sum::<f64>() / own.len() as f64)
}

#[test]
fn bodies_of_one_mesh_differ_in_colour() {
    let mut painted = boxes([Some(RED), Some(GREEN)]);
    let frame = painted.frame("still");
    let [red, green] = [1, 2].map(|id| mean(frame, id));
    assert!(
        red[0] > 2.0 * red[1] && green[1] > 1.5 * green[0],
        "{red:?} {green:?}"
    );
    let seen = (0..SIDE).find_map(|x| painted.picture.body_at(0.0, x, SIDE / 2));
    assert_eq!(seen.unwrap().id, 1);
}

#[test]
fn a_view_is_the_still_and_a_frame_from_its_camera() {
    let mut source = boxes([Some(RED), None]);
    let still = source.still();
    let of = (&mut source.scene, &still);
    let picture = source.picture.view(of, "auto", None).to_vec();
    let mut still = StillRender::new(&still, source.scene.clone());
    let made = std::iter::from_fn(|| Some(still.advance().unwrap())).find_map(|done| done);
    let fine = source.frame("fine").rgba().to_vec();
    assert_eq!(made.unwrap(), fine);
    assert_eq!(picture, source.frame("auto").rgba());
    source.yaw = 90.0;
    assert_ne!(source.frame("fine").rgba(), fine);
}

/// The number of pixels of the floor that are neither in light nor in shadow: the borders of shadows.
fn borders(frame: &Frame) -> usize {
    let pixels = frame.rgba().chunks(4).zip(frame.ids());
    let floor = pixels.filter(|(_, id)| **id == 0).map(|(p, _)| p[0]);
    let floor: Vec<u8> = floor.collect();
    let (dark, light) = (floor.iter().min().unwrap(), floor.iter().max().unwrap());
    let quarter = (light - dark) / 4;
    let between = dark + quarter..light - quarter;
    floor.iter().filter(|v| between.contains(v)).count()
}

#[test]
fn a_frame_is_refined_sample_by_sample() {
    for lamp in [ShadeParams::default().light, LAMP] {
        let mut source = boxes([Some(RED), Some(GREEN)]);
        source.lamp = lamp;
        let still = source.frame("still");
        let (first, sharp) = (still.rgba().to_vec(), borders(still));
        let ids = still.ids().to_vec();
        // The floor has soft shadows from the first sample on.
        let of_bodies = |rgba: &[u8]| -> Vec<u8> {
            let pixels = rgba.chunks(4).zip(&ids);
            let of_bodies = pixels.filter(|(_, id)| **id > 0);
            of_bodies.flat_map(|(pixel, _)| pixel.to_vec()).collect()
        };
        let order = source.order("fine");
        let mut shown = Vec::new();
        loop {
            let slice = source.turn(&order, 0.0);
            let frame = source.picture.frame();
            // Bodies can be found from the first sample on.
            assert_eq!(frame.is_some(), slice.refined || !shown.is_empty());
            if slice.refined {
                shown.push(frame.unwrap().rgba().to_vec());
                let found = (0..SIDE).find_map(|x| source.picture.body_at(0.0, x, SIDE / 2));
                assert_eq!(found.unwrap().id, 1);
            }
            if slice.done {
                break;
            }
        }
        assert_eq!(shown.len(), SAMPLES);
        assert!(of_bodies(&shown[0]) == of_bodies(&first), "{lamp:?}");
        assert!(shown.windows(2).all(|two| two[0] != two[1]));
        let soft = borders(source.picture.frame().unwrap());
        // The light of a lamp at a place varies over the whole floor, so borders of its shadows cannot be counted.
        assert!(lamp == LAMP || soft > sharp, "{soft} {sharp}");
        // Neither the division into slices nor the frame before has an effect.
        source.frame("moving+sky");
        let turned = source.turn(&order, f64::INFINITY);
        assert!(turned.refined);
        assert!(
            source.picture.frame().unwrap().rgba() == shown[0],
            "{lamp:?}"
        );
        assert!(
            source.frame("fine").rgba() == shown[SAMPLES - 1],
            "{lamp:?}"
        );
        assert!(source.frame("still").rgba() == first, "{lamp:?}");
    }
}

/// The sum of the differences between pixels beside each other, in an upright strip.
fn contrast(frame: &Frame, strip: Range<usize>) -> u32 {
    let at = |x: usize, y: usize| frame.rgba()[4 * (y * SIDE + x)];
    let rows = (0..SIDE).flat_map(|y| strip.clone().map(move |x| (x, y)));
    rows.map(|(x, y)| u32::from(at(x, y).abs_diff(at(x + 1, y))))
        .sum()
}

#[test]
fn a_lens_blurs_what_is_not_in_focus() {
    let mut source = boxes([None, None]);
    // The left box stays in the middle of the frame, the other one moves away from the eye.
    let mut apart = scene([None, None]);
    apart.instances[0].place.origin = Vec3::new(0.0, 0.1, 0.0);
    apart.instances[1].place.origin = Vec3::new(0.75, 0.1, -1.6);
    source.scene = Rc::new(apart);
    let (near, far) = (16..40, 43..SIDE - 1);
    let mut seen = |how: &str| {
        let frame = source.frame(how);
        [&near, &far].map(|strip| contrast(frame, strip.clone()))
    };
    let (sharp, blurred) = (seen("samples=32"), seen("samples=32+aperture=0.2"));
    assert!(blurred[0] * 5 > sharp[0] * 4, "{blurred:?} {sharp:?}");
    assert!(blurred[1] * 10 < sharp[1] * 9, "{blurred:?} {sharp:?}");
    // A number that is no aperture changes nothing.
    let plain = seen("samples=32+aperture=nan");
    assert_eq!(plain, sharp);
}

#[test]
fn the_digest_has_paints() {
    let digest = |paints| scene(paints).digest();
    let plain = digest([None, None]);
    let other = Paint { material: 3, ..RED };
    let all = [
        plain,
        digest([Some(RED), None]),
        digest([Some(GREEN), None]),
        digest([Some(other), None]),
        digest([None, Some(RED)]),
    ];
    for (k, one) in all.iter().enumerate() {
        assert!(!all[..k].contains(one), "{k}");
    }
}

/// The number of pixels that show a body.
fn count(frame: &Frame, id: u32) -> usize {
    frame.ids().iter().filter(|of| **of == id).count()
}

#[test]
fn a_plane_cuts_bodies_away() {
    let mut source = boxes([Some(RED), Some(GREEN)]);
    let all = [1, 2].map(|id| count(source.frame("still"), id));
    // The plane cuts away the right box, but not the left one.
    let frame = source.frame("still+whole=1,0,0,0");
    assert_eq!([1, 2].map(|id| count(frame, id)), [all[0], 0]);
    // The middles of both boxes are on the kept side of this plane.
    let frame = source.frame("still+whole=1,0,0,0.35");
    assert_eq!([1, 2].map(|id| count(frame, id)), all);
    // The upper halves of both are cut away; the caps lie in the plane and face up.
    let frame = source.frame("still+through=0,2,0,0.2");
    let left = [1, 2].map(|id| count(frame, id));
    assert!(
        left[0] < all[0] && left[1] < all[1] && left[0] > all[0] / 3,
        "{left:?} {all:?}"
    );
    let view = frame.order().camera.view(SIDE, SIDE);
    let mut highest = f32::MIN;
    for (at, &id) in frame.ids().iter().enumerate().filter(|(_, id)| **id > 0) {
        let ray = view.ray((at % SIDE) as f32 + 0.5, (at / SIDE) as f32 + 0.5);
        let place = view.eye + ray * frame.depths()[at];
        highest = highest.max(place.y);
        if frame.normals()[at].y > 0.9 {
            assert!((place.y - 0.2).abs() < 1e-3, "{id}: {place}");
        }
    }
    assert!((highest - 0.2).abs() < 1e-3, "{highest}");
}

#[test]
fn what_is_cut_away_casts_no_shadow() {
    let mut source = boxes([None, None]);
    let floor = |frame: &Frame| -> Vec<u8> {
        let pixels = frame.rgba().chunks(4).zip(frame.ids());
        pixels
            .filter(|(_, id)| **id == 0)
            .map(|(p, _)| p[0])
            .collect()
    };
    let darkest = |pixels: Vec<u8>| pixels.into_iter().min().unwrap();
    let shadowed = darkest(floor(source.frame("still")));
    let cut = darkest(floor(source.frame("still+whole=0,1,0,-1")));
    assert!(cut > shadowed, "{cut} {shadowed}");
    // Half a box still casts a shadow.
    let half = darkest(floor(source.frame("still+through=0,1,0,0.2")));
    assert!(half < cut, "{half} {cut}");
}

#[test]
fn a_plane_that_cannot_be_read_cuts_nothing() {
    let mut source = boxes([None, None]);
    let plain = source.frame("still").hash();
    for word in [
        "through",
        "through=",
        "through=0,0,0,1",
        "whole=1,2,x,4",
        "whole=nan,0,0,0",
        "cut=1,0,0,0",
    ] {
        assert_eq!(
            source.frame(&format!("still+{word}")).hash(),
            plain,
            "{word}"
        );
    }
}
