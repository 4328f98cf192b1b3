//! Tiles: meshes, planes and pictures of the periodic picture continue across its edges.

use crate::paving::OfPavement;
use bubblestone::domain::{Domain, signed_area};
use bubblestone::heightfield::{Planes, Shader};
use bubblestone::light::{Light, ShadeParams};
use bubblestone::material::{Gloss, material_table};
use bubblestone::mesh::Mesh;
use bubblestone::metrics::Metrics;
use bubblestone::random::{Purpose, Random};
use bubblestone::studio::Studio;
use std::collections::HashMap;

const SIDE: usize = 192;

/// All kinds of cells, fields with varying direction and size, and random sizes.
const LINKS: [&str; 5] = [
    "kind=square&dir=constant&angle=20&vs=0.15",
    "kind=circle&vs=0.1",
    "kind=ellipse&ca=2&dir=strokes&strokes=0.1,0.2,0.6,0.3;0.9,0.5,0.5,0.9",
    "kind=rectangle&ca=1.6&dir=circular&vs=0.1",
    "kind=square&dir=constant&lines=-0.1,0.3,0.4,0.5,1.2,0.8",
];

fn finished(link: &str) -> Studio {
    crate::common::finished(&format!("size={SIDE}&tile=1&cs=17&{link}"))
}

/// Asserts that every side of every face is also a side of another face, up to a period.
fn assert_closed(domain: &Domain, mesh: &Mesh, what: &str) {
    let first = mesh.vertices.len() - mesh.images.len();
    let real = |k: u32| {
        (k as usize)
            .checked_sub(first)
            .map_or(k, |k| mesh.images[k])
    };
    let place = |k: u32| mesh.vertices[k as usize];
    let mut sides = HashMap::new();
    let mut area = 0.0;
    for face in &mesh.faces {
        let nodes = face.nodes();
        let ring: Vec<_> = nodes.iter().map(|&k| place(k)).collect();
        assert!(signed_area(&ring) > 0.0, "{what}");
        area += signed_area(&ring);
        for (k, &a) in nodes.iter().enumerate() {
            let b = nodes[(k + 1) % nodes.len()];
            let shift = |k: u32| ((place(k) - place(real(k))) / SIDE as f64).round();
            let way = shift(b) - shift(a);
            let by = (way.x as i32, way.y as i32);
            *sides.entry((real(a), real(b), by)).or_insert(0) += 1;
        }
    }
    for (&(a, b, by), &count) in &sides {
        assert_eq!(count, 1, "{what}: {a} {b}");
        assert!(
            sides.contains_key(&(b, a, (-by.0, -by.1))),
            "{what}: {a} {b}"
        );
    }
    assert!((area / domain.area() - 1.0).abs() < 1e-9, "{what}: {area}");
    for (&k, &at) in mesh.images.iter().zip(&mesh.vertices[first..]) {
        let off = domain.space().shortest(at - place(k)).length();
        assert!(off < 1e-9, "{what}");
    }
}

#[test]
fn meshes_close_over_the_seams() {
    for link in &LINKS[..4] {
        let studio = finished(link);
        let made = (
            studio.pavement().domain,
            studio.pavement().mesh,
            studio.pavement().packing,
        );
        let (Some(domain), Some(mesh), Some(packing)) = made else {
            panic!("{link}");
        };
        let particles = packing.particles();
        assert_eq!(mesh.vertices.len() - mesh.images.len(), particles.len());
        assert_closed(domain, mesh, link);
        let fields = studio.pavement().fields.unwrap();
        let figures = Metrics::new(domain, fields, &particles, mesh, studio.pavement().cells);
        for cover in [figures.mesh.cover, figures.cells.cover] {
            assert!((cover.coverage - 1.0).abs() < 1e-5, "{link}: {cover:?}");
            assert!(cover.overlap + cover.outside < 1e-5, "{link}: {cover:?}");
        }
        let nodes: usize = figures.mesh.valence.iter().sum();
        assert_eq!(nodes, particles.len(), "{link}");
    }
}

/// With only a few cells, cells are neighbours of themselves across several seams at once.
#[test]
fn meshes_of_few_cells_close_over_the_seams() {
    let domain = Domain::torus(SIDE as f64, &[]);
    let studio = finished(LINKS[0]);
    let model = studio.pavement().packing.unwrap().particles()[0];
    let mut random = Random::new(8, Purpose::Noise, 0);
    for count in 1..30 {
        let particles: Vec<_> = (0..count)
            .map(|id| {
                let at = glam::DVec2::new(random.unit(), random.unit());
                let (centre, size) = (at * SIDE as f64, SIDE as f64 / f64::from(count).sqrt());
                bubblestone::packing::Particle {
                    id,
                    centre,
                    size,
                    ..model
                }
            })
            .collect();
        assert_closed(
            &domain,
            &Mesh::build(&domain, &particles),
            &format!("{count}"),
        );
    }
}

fn shaded(planes: &Planes, light: Light) -> Vec<u8> {
    let table = material_table("granite", "sand", Gloss::Own);
    let params = ShadeParams {
        light,
        ..ShadeParams::default()
    };
    let mut shader = Shader::new(&params, planes.side, 1);
    while !shader.advance(planes, &table, 16) {}
    shader.rgba().to_vec()
}

/// The source of pixel `k` in the picture before it was moved.
fn from(k: usize, [x, y]: [usize; 2]) -> usize {
    (k / SIDE + y) % SIDE * SIDE + (k % SIDE + x) % SIDE
}

fn moved<T: Copy>(plane: &[T], by: [usize; 2]) -> Vec<T> {
    (0..plane.len()).map(|k| plane[from(k, by)]).collect()
}

/// Shading does not depend on the picture's edges: the shading of moved planes is the moved shading.
#[test]
fn shading_of_a_tile_has_no_edges() {
    let studio = finished("kind=square&dir=constant&vs=0.2&hs=30");
    let planes = studio.pavement().planes.unwrap();
    assert!(planes.tile);
    for by in [[96, 96], [1, 0], [0, 1], [37, 150]] {
        let mut other = planes.clone();
        other.bump = moved(&planes.bump, by);
        other.colour = moved(&planes.colour, by);
        other.material = moved(&planes.material, by);
        other.occlusion = moved(&planes.occlusion, by);
        for (azimuth, elevation) in [(225, 40), (10, 20), (100, 5), (290, 8), (180, 5), (45, 70)] {
            let light = Light::Parallel {
                azimuth: f64::from(azimuth).to_radians(),
                elevation: f64::from(elevation).to_radians(),
            };
            let (here, there) = (shaded(planes, light), shaded(&other, light));
            let pixel = |k: usize| &here[4 * k..4 * k + 4];
            for k in 0..SIDE * SIDE {
                let (a, b) = (pixel(from(k, by)), &there[4 * k..4 * k + 4]);
                let far = a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max();
                assert!(
                    far <= Some(1),
                    "{by:?} {azimuth} {elevation}: {k} {a:?} {b:?}"
                );
            }
        }
        // Without repeating, the edges of the same planes are visible.
        other.tile = false;
        let single = Planes {
            tile: false,
            ..planes.clone()
        };
        let light = ShadeParams::default().light;
        let (here, there) = (shaded(&single, light), shaded(&other, light));
        let unlike = |k: &usize| here[4 * from(*k, by)] != there[4 * k];
        assert!((0..SIDE * SIDE).filter(unlike).count() > 20);
    }
}

/// The sums of a plane's changes from each column to the next, and from the last to the first.
fn steps(step: impl Fn(usize, usize) -> f64) -> Vec<f64> {
    let line = |x: usize| {
        let at = |y: usize| (y * SIDE + x, y * SIDE + (x + 1) % SIDE);
        (0..SIDE).map(|y| step(at(y).0, at(y).1)).sum::<f64>()
    };
    (0..SIDE).map(line).collect()
}

/// Across the seams, planes and picture change as much as elsewhere, and stones continue.
#[test]
fn planes_and_pictures_run_on_over_the_seams() {
    for link in LINKS {
        let mut studio = finished(link);
        let planes = studio.pavement().planes.unwrap().clone();
        let picture = studio.engine_mut().view("picture").to_vec();
        let down = |k: usize| k % SIDE * SIDE + k / SIDE;
        for upright in [true, false] {
            let at = |k: usize| if upright { k } else { down(k) };
            let id = |a: usize, b: usize| f64::from(u8::from(planes.id[at(a)] != planes.id[at(b)]));
            let height =
                |a: usize, b: usize| f64::from((planes.bump[at(a)] - planes.bump[at(b)]).abs());
            let open = |a: usize, b: usize| {
                f64::from(planes.occlusion[at(a)].abs_diff(planes.occlusion[at(b)]))
            };
            let light =
                |a: usize, b: usize| f64::from(picture[4 * at(a)].abs_diff(picture[4 * at(b)]));
            let all: [(&str, Vec<f64>); 4] = [
                ("id", steps(id)),
                ("height", steps(height)),
                ("occlusion", steps(open)),
                ("light", steps(light)),
            ];
            for (what, mut steps) in all {
                let seam = steps.pop().unwrap();
                let most = steps.iter().copied().fold(0.0, f64::max);
                let mean = steps.iter().sum::<f64>() / steps.len() as f64;
                assert!(
                    seam < most.max(1.5 * mean),
                    "{link}: {what} {seam} of {mean}, {most}"
                );
            }
        }
    }
}
