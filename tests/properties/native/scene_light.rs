//! Light and shadows of bodies, compared with rays to the lamp.

use super::scene_rays::*;
use bubblestone::heightfield::{Planes, Shader};
use bubblestone::light::{Light, ShadeParams};
use bubblestone::material::Material;
use bubblestone::scene::{
    Backdrop, Body, Camera, Frame, Instance, Lamp, Lighting, Order, Place, SAMPLES, Scene,
    Sharpness, SoftLight,
};
use glam::{DVec3, Vec3};

/// Texels along the side of the sun's map. Each side of the cube around a lamp has half as many.
const SIDES: [(Sharpness, f64); 2] = [(Sharpness::Small, 1024.0), (Sharpness::Large, 2048.0)];
/// The softest shadow edge, in texels to each side.
const BAND: f64 = 2.0;

/// A place on a surface, with the normal of its triangle.
struct Spot {
    point: DVec3,
    normal: DVec3,
}

/// Random places on the triangles of all bodies, weighted by area.
fn spots(scene: &Scene, count: usize) -> Vec<Spot> {
    let mut chance = Chance(3);
    let mut corners = Vec::new();
    for instance in &scene.instances {
        let surface = &scene.bodies[instance.body as usize].levels[0];
        for triangle in &surface.triangles {
            corners.push(
                triangle.map(|v| instance.place.of(surface.positions[v as usize]).as_dvec3()),
            );
        }
    }
    let area = |[a, b, c]: [DVec3; 3]| (b - a).cross(c - a);
    let all: f64 = corners.iter().map(|&t| area(t).length()).sum();
    let mut spots = Vec::new();
    for triangle in corners {
        let normal = area(triangle);
        let wanted = count as f64 * normal.length() / all + f64::from(chance.next());
        for _ in 0..wanted as usize {
            let (mut u, mut v) = (f64::from(chance.next()), f64::from(chance.next()));
            if u + v > 1.0 {
                (u, v) = (1.0 - u, 1.0 - v);
            }
            let [a, b, c] = triangle;
            spots.push(Spot {
                point: a + (b - a) * u + (c - a) * v,
                normal: normal.normalize(),
            });
        }
    }
    spots
}

/// Places on the plane through a spot that are BAND texels away on the lamp's map, with their directions to the
/// lamp. Empty if the light grazes that plane.
fn near_spots(lamp: Lamp, [radius, side]: [f64; 2], spot: &Spot) -> Vec<(DVec3, DVec3)> {
    let offsets = (0..9).map(|k| [f64::from(k % 3 - 1), f64::from(k / 3 - 1)].map(|v| v * BAND));
    match lamp {
        Lamp::Sun(to) => {
            let texel = 2.0 * 1.02 * radius / side;
            let (u, to) = (to.any_orthonormal_vector().as_dvec3(), to.as_dvec3());
            let beside = offsets.map(|[x, y]| (u * x + to.cross(u) * y) * texel);
            let on_plane = |d: DVec3| d - to * (d.dot(spot.normal) / to.dot(spot.normal));
            beside.map(|d| (spot.point + on_plane(d), to)).collect()
        }
        Lamp::Bulb { at, .. } => {
            let (at, from) = (at.as_dvec3(), spot.point - at.as_dvec3());
            let texel = 2.0 * libm::tan(45.5f64.to_radians()) / (0.5 * side);
            // The cube's side is that of the largest coordinate.
            let size = from.abs();
            let (axis, u, v) = match size.max_element() {
                most if most == size.x => (size.x, DVec3::Y, DVec3::Z),
                most if most == size.y => (size.y, DVec3::X, DVec3::Z),
                most => (most, DVec3::X, DVec3::Y),
            };
            let ways = offsets.map(|[x, y]| from + (u * x + v * y) * (texel * axis));
            ways.map(|way| {
                let point = at + way * (from.dot(spot.normal) / way.dot(spot.normal));
                (point, at - point)
            })
            .collect()
        }
    }
}

/// Compares shadows with rays at places where all rays within two texels agree.
fn compare(scene: &Scene, lamp: Lamp) {
    for (sharpness, side) in SIDES {
        let mut light = Lighting::new(scene, lamp, (&PARAMS, &[MATT]), sharpness);
        while !light.advance(scene, 100_000) {}
        compare_with(&light, scene, lamp, side);
    }
}

fn compare_with(light: &Lighting, scene: &Scene, lamp: Lamp, side: f64) {
    let (rays, (_, radius)) = (Rays::new(scene), scene.ball());
    let mut counts = [0; 3];
    for spot in spots(scene, 3000) {
        let to = match lamp {
            Lamp::Sun(to) => to.as_dvec3(),
            Lamp::Bulb { at, .. } => at.as_dvec3() - spot.point,
        };
        let seen = light.visible(spot.point.as_vec3(), spot.normal.as_vec3());
        let facing = spot.normal.dot(to.normalize());
        if facing <= 0.0 {
            assert!(facing > -1e-6 || seen == 0.0);
            continue;
        }
        // At grazing light everything is an edge.
        if facing < 0.02 {
            continue;
        }
        let is_dark = |(from, way): &(DVec3, DVec3)| {
            let hit = rays.nearest(*from + spot.normal * 1e-7, *way);
            hit.is_some_and(|hit| matches!(lamp, Lamp::Sun(_)) || hit.away < 1.0)
        };
        let near = near_spots(lamp, [radius.into(), side], &spot);
        // In a crease, the plane of one side lies below the other side.
        let is_inside =
            |(from, way): &(DVec3, DVec3)| rays.leaves(*from + spot.normal * 1e-7, *way);
        if near.iter().any(is_inside) {
            continue;
        }
        let dark = near.iter().filter(|near| is_dark(near)).count();
        let place = format!("{lamp:?}: {} facing {facing}", spot.point);
        match dark {
            0 => assert!(seen > 0.97, "{place}: {seen} of a lit place"),
            9 => assert!(seen < 0.03, "{place}: {seen} of a dark place"),
            _ => {}
        }
        counts[[dark == 0, dark == 9, true]
            .iter()
            .position(|&is| is)
            .unwrap()] += 1;
    }
    let [lit, dark, edge] = counts;
    assert!(
        lit > 400 && dark > 100 && edge * 5 < lit + dark,
        "{lamp:?}: {counts:?}"
    );
}

#[test]
fn the_suns_shadows_are_those_of_rays() {
    let scene = still_life();
    for lamp in [
        sun(0.5, 0.8, -0.3),
        sun(-0.9, 0.15, 0.2),
        sun(0.1, 1.0, 0.0),
        sun(0.3, 0.5, 0.8),
    ] {
        compare(&scene, lamp);
    }
}

#[test]
fn a_lamps_shadows_are_those_of_rays() {
    let scene = still_life();
    for at in [
        [0.2, 1.1, 0.4],
        [-0.9, 0.8, -0.9],
        [0.0, 3.0, 0.1],
        [0.05, 0.35, 0.1],
    ] {
        compare(&scene, bulb(at));
    }
}

/// Flat and curved surfaces that nothing shadows are lit from all sides, with the normals of their vertices,
/// unless the light grazes them.
#[test]
fn nothing_shadows_itself() {
    let flat = scene(vec![(square(1.0), Place::default())]);
    let round = scene(vec![(ball(64), Place::default())]);
    let mut chance = Chance(5);
    for turn in 0..16 {
        let way = Vec3::new(
            chance.next() - 0.5,
            0.05 + 0.3 * chance.next(),
            chance.next() - 0.5,
        );
        let way = way.normalize();
        let lamp = match turn % 2 {
            0 => Lamp::Sun(way),
            // The height has no effect on shadows.
            _ => Lamp::Bulb {
                at: way * 2.5,
                height: 1.0,
            },
        };
        for (scene, least) in [(&flat, 0.0), (&round, 0.15)] {
            let light = lighting(scene, lamp, &PARAMS, 100_000);
            for spot in spots(scene, 1500) {
                let (point, normal) = match least {
                    0.0 => (spot.point.as_vec3(), Vec3::Y),
                    _ => (spot.point.as_vec3(), spot.point.as_vec3().normalize()),
                };
                let to = match lamp {
                    Lamp::Sun(to) => to,
                    Lamp::Bulb { at, .. } => (at - point).normalize(),
                };
                if normal.dot(to) > least {
                    let seen = light.visible(point, normal);
                    assert!(seen > 0.99, "{lamp:?}: {seen} at {point}");
                }
            }
        }
    }
}

/// A body drawn at another level of detail than its shadow does not shadow itself.
#[test]
fn levels_do_not_shadow_each_other() {
    let mut scene = scene(vec![]);
    scene
        .bodies
        .push(Body::new([40, 24, 12, 8].map(ball).to_vec(), 0));
    // Two more balls make the map wide, so that the ball has few texels in it.
    for (k, x) in (0..).zip([0.0, -30.0, 30.0]) {
        let place = Place::at(Vec3::new(x, 0.0, 0.0));
        scene.instances.push(Instance {
            body: 0,
            place,
            id: k + 1,
            paint: None,
        });
    }
    let to = Vec3::new(0.3, 0.8, 0.5).normalize();
    let params = ShadeParams {
        ambient: 0.0,
        specular: 0.0,
        occlusion: 0.0,
        ..PARAMS
    };
    let light = lighting(&scene, Lamp::Sun(to), &params, 100_000);
    let bare = ShadeParams {
        shadow: 0.0,
        ..params
    };
    let without = lighting(&scene, Lamp::Sun(to), &bare, 100_000);
    for (distance, is_moving) in [
        (4.0, false),
        (8.0, false),
        (8.0, true),
        (20.0, false),
        (20.0, true),
    ] {
        let order = Order {
            is_moving,
            ..order(camera(30.0, 40.0, distance, 40.0), [120, 90])
        };
        let [one, other] = [&light, &without].map(|light| frame(&scene, light, order, 100_000));
        for at in 0..120 * 90 {
            if one.ids()[at] == 1 && one.normals()[at].dot(to) > 0.3 {
                let [lit, bare] = [&one, &other].map(|frame| frame.rgba()[4 * at]);
                assert!(
                    lit.abs_diff(bare) < 4,
                    "from {distance}: {lit} of {bare} at {at}"
                );
            }
        }
    }
}

/// A flat slab has the colour of a flat picture in the height field.
#[test]
fn light_is_that_of_the_height_field() {
    const SIDE: usize = 32;
    for (elevation, specular, ambient) in [(1.2, 1.0, 1.0), (0.5, 2.0, 0.6), (0.9, 0.0, 1.4)] {
        let light = Light::Parallel {
            azimuth: 2.0,
            elevation,
        };
        let params = ShadeParams {
            light,
            specular,
            ambient,
            ..PARAMS
        };
        let mut planes = Planes::new(SIDE);
        planes.colour.fill([150; 3]);
        let mut shader = Shader::new(&params, SIDE, 1);
        while !shader.advance(&planes, &[MATT], 100) {}
        let at = 4 * (SIDE / 2 * SIDE + SIDE / 2);
        let wanted = &shader.rgba()[at..at + 3];

        let scene = scene(vec![(square(0.5), Place::default())]);
        let lighting = lighting(&scene, Lamp::over_picture(light, 0.0), &params, 100_000);
        let order = order(camera(0.0, 90.0, 20.0, 5.0), [33, 33]);
        let frame = frame(&scene, &lighting, order, 100_000);
        let pixel = &frame.rgba()[4 * (16 * 33 + 16)..][..3];
        for k in 0..3 {
            assert!(pixel[k].abs_diff(wanted[k]) <= 1, "{pixel:?} of {wanted:?}");
        }
    }
}

/// The highlight lies in the mirror direction of the sun, and the sun of a picture shines from the same side in
/// space.
#[test]
fn highlights_lie_towards_the_mirrored_sun() {
    let light = Light::Parallel {
        azimuth: 0.0,
        elevation: 0.6,
    };
    let params = ShadeParams {
        ambient: 0.0,
        diffuse: 0.2,
        ..PARAMS
    };
    let scene = scene(vec![(ball(48), Place::default())]);
    let shiny = Material {
        specular: 1.0,
        shininess: 60.0,
        ..MATT
    };
    let lamp = Lamp::over_picture(light, 0.0);
    let Lamp::Sun(to) = lamp else { panic!() };
    assert!(to.x > 0.8 && to.y > 0.5 && to.z.abs() < 1e-6);
    let mut lighting = Lighting::new(&scene, lamp, (&params, &[shiny]), Sharpness::Small);
    while !lighting.advance(&scene, 100_000) {}
    let order = order(camera(0.0, 20.0, 6.0, 25.0), [120, 120]);
    let frame = frame(&scene, &lighting, order, 100_000);
    let brightest = (0..120 * 120)
        .max_by_key(|&at| frame.rgba()[4 * at])
        .unwrap();
    let bright = frame.rgba()[4 * brightest];
    let same: Vec<usize> = (0..120 * 120)
        .filter(|&at| frame.rgba()[4 * at] == bright)
        .collect();
    let view = order.camera.view(120, 120);
    let normal = same
        .iter()
        .map(|&at| frame.normals()[at])
        .sum::<Vec3>()
        .normalize();
    let half = (to - view.ahead).normalize();
    assert!(
        normal.dot(half) > 0.995,
        "{normal} of {half}, {} pixels",
        same.len()
    );
}

/// A ball darkens the slab where it stands. Occlusion does not darken a plane alone.
#[test]
fn occlusion_is_at_the_foot_of_bodies_only() {
    let sky = ShadeParams {
        diffuse: 0.0,
        specular: 0.0,
        shadow: 0.0,
        ..PARAMS
    };
    let open = ShadeParams {
        occlusion: 0.0,
        ..sky
    };
    let slab = (square(3.0), Place::default());
    let alone = scene(vec![slab.clone()]);
    let ball = (ball(24), place([1.0, 0.0, 0.0], 0.0, 0.3, [0.0, 0.3, 0.0]));
    let both = scene(vec![slab, ball]);
    for (angle, height) in [(30.0, 35.0), (200.0, 45.0), (90.0, 20.0)] {
        let order = order(camera(angle, height, 2.5, 40.0), [120, 90]);
        let shades = |scene: &Scene| {
            [&sky, &open].map(|params| {
                let light = Lighting::new(
                    scene,
                    sun(0.2, 1.0, 0.3),
                    (params, &[MATT]),
                    Sharpness::Small,
                );
                frame(scene, &light, order, 100_000)
            })
        };
        let [with, without] = shades(&alone);
        assert_eq!(with.rgba(), without.rgba(), "a plane alone, {height}");
        let [with, without] = shades(&both);
        let view = order.camera.view(120, 90);
        let (mut foot, mut far) = (Vec::new(), Vec::new());
        for at in (0..120 * 90).filter(|&at| with.ids()[at] == 1) {
            let ray = view.ray((at % 120) as f32 + 0.5, (at / 120) as f32 + 0.5);
            let away = (view.eye + ray * with.depths()[at]).length();
            let [dark, bright] = [&with, &without].map(|frame| f64::from(frame.rgba()[4 * at]));
            assert!(dark <= bright);
            match away {
                away if away < 0.36 => foot.push(dark / bright),
                away if away > 0.9 => far.push(dark / bright),
                _ => {}
            }
        }
        let mean = |list: &[f64]| list.iter().sum::<f64>() / list.len() as f64;
        assert!(
            foot.len() > 20 && mean(&foot) < 0.97,
            "{height}: {} at the foot",
            mean(&foot)
        );
        assert!(mean(&far) > 0.985, "{height}: {} far away", mean(&far));
    }
}

/// A ball whose level in the frame is coarser than that in the shadow map has no false shadow: its triangles lie below
/// the map's.
#[test]
fn a_coarser_level_has_no_shadow_of_a_finer_one() {
    let levels = vec![ball(48), ball(5), ball(4)];
    let mut scene = scene(vec![(ball(48), Place::default())]);
    scene.bodies[0] = Body::new(levels, 0);
    let lamp = sun(0.9, 0.5, 0.2);
    let Lamp::Sun(to) = lamp else { panic!() };
    let bare = ShadeParams {
        shadow: 0.0,
        ..PARAMS
    };
    let order = order(camera(20.0, 30.0, 10.0, 28.0), [140, 140]);
    let [with, without] = [&PARAMS, &bare].map(|params| {
        let mut light = Lighting::new(&scene, lamp, (params, &[MATT]), Sharpness::Small);
        while !light.advance(&scene, 100_000) {}
        frame(&scene, &light, order, 100_000)
    });
    let pixels = || (0..140 * 140).filter(|&at| with.ids()[at] > 0);
    assert!(
        (1800..2900).contains(&pixels().count()),
        "{}",
        pixels().count()
    );
    for at in pixels().filter(|&at| with.normals()[at].dot(to) > 0.1) {
        let [dark, bright] = [&with, &without].map(|frame| frame.rgba()[4 * at]);
        assert!(bright - dark < 4, "{dark} and {bright} at {at}");
    }
}

/// The floor is dark where a ball touches it, and lighter with the distance, also beside the shadow. Its tone in full
/// light depends on no factor of the recipe.
#[test]
fn the_floor_is_dark_at_contact_only() {
    let scene = scene(vec![(
        ball(24),
        place([1.0, 0.0, 0.0], 0.0, 0.3, [0.0, 0.3, 0.0]),
    )]);
    let order = Order {
        backdrop: Backdrop::Floor,
        ..order(camera(0.0, 30.0, 4.0, 28.0), [160, 120])
    };
    let dim = ShadeParams {
        ambient: 0.4,
        diffuse: 0.5,
        ..PARAMS
    };
    let [first, second] = [&PARAMS, &dim].map(|params| {
        let light = lighting(&scene, sun(0.2, 1.0, -0.8), params, 100_000);
        frame(&scene, &light, order, 100_000)
    });
    let view = order.camera.view(160, 120);
    let tone = |p: [f32; 3]| {
        let [x, y, _] = view.on_screen(view.of(Vec3::from(p)));
        let at = y as usize * 160 + x as usize;
        assert_eq!(first.ids()[at], 0, "{p:?}");
        assert_eq!(first.rgba()[4 * at..][..4], second.rgba()[4 * at..][..4]);
        i32::from(first.rgba()[4 * at])
    };
    // To the lamp's side no shadow falls.
    let [near, middle, far] = [0.14, 0.3, 0.8].map(|x| tone([x, 0.0, 0.16]));
    assert!(
        near + 8 < middle && middle + 5 < far,
        "{near}, {middle}, {far}"
    );
    assert!(far > 180);
}

/// The shadow of a ball high over the floor has a wide edge without steps, although the lamp of each sample has a sharp
/// one.
#[test]
fn a_shadow_far_from_its_body_has_no_steps() {
    const SIZE: [usize; 2] = [240, 120];
    let high = (ball(48), place([1.0, 0.0, 0.0], 0.0, 0.2, [0.0, 0.8, 0.0]));
    let low = (ball(8), place([1.0, 0.0, 0.0], 0.0, 0.02, [0.0, 0.02, 0.0]));
    let scene = scene(vec![high, low]);
    let camera = Camera {
        target: [0.72, 0.0, 0.0],
        ..camera(0.0, 89.0, 1.6, 28.0)
    };
    let order = Order {
        backdrop: Backdrop::Floor,
        samples: SAMPLES,
        ..order(camera, SIZE)
    };
    for lamp in [sun(-0.9, 1.0, 0.0), bulb([-1.5, 2.4, 0.0])] {
        let mut light = SoftLight::new(lighting(&scene, lamp, &PARAMS, 100_000));
        let mut frame = Frame::new(order);
        while !frame.is_done() {
            let light = light.of_sample(frame.sample(), &scene);
            while !light.advance(&scene, 100_000) {}
            frame.advance(&scene, light, 100_000);
        }
        let row = SIZE[1] / 2;
        // The small ball, which makes the floor low, is at the left.
        let tones: Vec<i32> = (40..SIZE[0])
            .filter(|x| frame.ids()[row * SIZE[0] + x] == 0)
            .map(|x| i32::from(frame.rgba()[4 * (row * SIZE[0] + x)]))
            .collect();
        let (dark, bright) = (tones.iter().min().unwrap(), tones.iter().max().unwrap());
        assert!(bright - dark > 40, "{lamp:?}: {dark} to {bright}");
        let steepest = tones.windows(2).map(|two| (two[1] - two[0]).abs()).max();
        assert!(steepest.unwrap() < 6, "{lamp:?}: {tones:?}");
    }
}
