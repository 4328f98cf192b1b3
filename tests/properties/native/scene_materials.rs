//! Brass, damp rice, a leaf and glass side by side: the materials that piles and walls need.

use super::scene_rays::*;
use bubblestone::light::ShadeParams;
use bubblestone::material::Material;
use bubblestone::scene::{Backdrop, Frame, Lighting, Order, Scene, Sharpness};
use bubblestone::solid::Surface;
use glam::Vec3;

const SIZE: [usize; 2] = [480, 240];
/// The materials with their colours, from left to right.
const MADE_OF: [(Material, [u8; 3]); 4] = [
    (Material::BRASS, [214, 168, 82]),
    (Material::DAMP_RICE, [236, 230, 214]),
    (Material::LEAF, [92, 132, 44]),
    (Material::GLASS, [40, 74, 62]),
];

/// A ball, grains, a leaf that stands up bent, and a ball.
fn still_life() -> Scene {
    let leaf = place([0.0, 1.0, 0.0], 25.0, 0.3, [0.35, 0.33, 0.0]);
    let grain = |turn: f64, at: [f32; 3]| (1, place([0.2, 1.0, 0.3], turn, 0.13, at));
    let stands = [
        (0, place([0.0, 1.0, 0.0], 0.0, 0.26, [-1.1, 0.26, 0.0])),
        grain(10.0, [-0.45, 0.1, 0.1]),
        grain(80.0, [-0.2, 0.1, 0.0]),
        grain(150.0, [-0.35, 0.1, -0.25]),
        grain(40.0, [-0.33, 0.26, -0.02]),
        (2, leaf),
        (3, place([0.0, 1.0, 0.0], 0.0, 0.26, [1.1, 0.26, 0.0])),
    ];
    let shape = |kind: usize| match kind {
        1 => stretched(ball(24), Vec3::new(1.3, 0.7, 0.7)),
        2 => stretched(ball(32), Vec3::new(0.7, 1.1, 0.03)),
        _ => ball(48),
    };
    let parts = stands.map(|(kind, place)| {
        let mut surface = shape(kind);
        surface.colours.fill(MADE_OF[kind].1);
        (surface, place)
    });
    let mut scene = scene(parts.into());
    for (body, (kind, _)) in scene.bodies.iter_mut().zip(stands) {
        body.material = kind as u8;
    }
    scene
}

fn stretched(mut surface: Surface, by: Vec3) -> Surface {
    for p in &mut surface.positions {
        *p *= by;
    }
    for n in &mut surface.normals {
        *n = (*n / by).normalize();
    }
    surface
}

fn picture(change: impl Fn(Material) -> Material, lamp: [f32; 3]) -> Frame {
    let scene = still_life();
    let materials = MADE_OF.map(|(material, _)| change(material));
    let [x, y, z] = lamp;
    let params: &ShadeParams = &PARAMS;
    let mut light = Lighting::new(&scene, sun(x, y, z), (params, &materials), Sharpness::Small);
    while !light.advance(&scene, 100_000) {}
    let order = Order {
        backdrop: Backdrop::Floor,
        ..order(camera(0.0, 14.0, 4.6, 20.0), SIZE)
    };
    frame(&scene, &light, order, 100_000)
}

/// The pixels that show a body of this kind.
fn pixels(frame: &Frame, kind: usize) -> impl Iterator<Item = [i32; 3]> + '_ {
    let ids = match kind {
        0 => 1..=1,
        1 => 2..=5,
        2 => 6..=6,
        _ => 7..=7,
    };
    let rgb = |at: usize| [0, 1, 2].map(|k| i32::from(frame.rgba()[4 * at + k]));
    let is_it = move |at: &usize| ids.contains(&frame.ids()[*at]);
    (0..SIZE[0] * SIZE[1]).filter(is_it).map(rgb)
}

fn write(name: &str, frame: &Frame) {
    let path = format!("{}/{name}.png", env!("CARGO_TARGET_TMPDIR"));
    let file = std::fs::File::create(path).expect("a file");
    let mut encoder = png::Encoder::new(file, SIZE[0] as u32, SIZE[1] as u32);
    encoder.set_color(png::ColorType::Rgba);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(frame.rgba()).expect("pixels");
}

/// Writes materials.png and materials-behind.png to the folder of the tests' files.
#[test]
fn brass_rice_leaf_and_glass_look_like_themselves() {
    let own = |material: Material| material;
    let front = picture(own, [-0.6, 0.7, 0.6]);
    let behind = picture(own, [-0.4, 0.5, -0.9]);
    write("materials", &front);
    write("materials-behind", &behind);
    // The brightest place of brass has its colour, that of glass is white.
    let brightest = |kind: usize| pixels(&front, kind).max_by_key(|rgb| rgb.iter().sum::<i32>());
    let [brass, glass] = [0, 3].map(|kind| brightest(kind).expect("pixels"));
    assert!(brass[0] > brass[2] + 25, "{brass:?}");
    assert!(glass[0] > 200 && glass[0] < glass[2] + 20, "{glass:?}");
    // A leaf against the light is lighter and greener than one that lets no light through.
    let dense = |material: Material| Material {
        thin: 0.0,
        ..material
    };
    let dark = picture(dense, [-0.4, 0.5, -0.9]);
    let sum = |frame: &Frame, kind: usize| pixels(frame, kind).map(|rgb| rgb[1]).sum::<i32>();
    assert!(4 * sum(&behind, 2) > 5 * sum(&dark, 2));
    // Without mirrored surroundings glass is darker, most of all at its edge.
    let dull = |material: Material| Material {
        mirror: 0.0,
        ..material
    };
    let dull = picture(dull, [-0.6, 0.7, 0.6]);
    assert!(5 * sum(&front, 3) > 6 * sum(&dull, 3));
    assert!(sum(&front, 1) > sum(&dull, 1));
}
