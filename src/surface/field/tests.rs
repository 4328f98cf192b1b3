//! Fields as a whole.

use super::*;
use crate::surface::{Search, testing};

fn build(mesh: &TriMesh, params: SurfaceFieldParams) -> SurfaceFields {
    SurfaceFieldBuilder::build(Arc::new(mesh.clone()), params)
}

fn of_size(kind: Kind, size: f64) -> SurfaceFieldParams {
    SurfaceFieldParams {
        kind,
        size: SizeParams {
            amount: Amount::Size(size),
            ..SizeParams::default()
        },
        ..SurfaceFieldParams::default()
    }
}

/// Directions told in several ways.
fn directions() -> Vec<DirectionParams> {
    let none = DirectionParams::default();
    vec![
        none.clone(),
        DirectionParams {
            axis: 1.0,
            towards: DVec3::new(0.2, 1.0, 0.1),
            ..none.clone()
        },
        DirectionParams {
            curvature: 1.0,
            ..none.clone()
        },
        DirectionParams {
            borders: 1.0,
            creases: 1.0,
            turn: 0.3,
            ..none
        },
    ]
}

#[test]
fn indices_sum_to_the_euler_characteristic() {
    let meshes = [
        ("ball", testing::ball(4)),
        ("blob", testing::blob(4)),
        ("torus", testing::torus(60, 24)),
        ("facets", testing::torus(24, 10)),
        ("noisy ball", testing::noisy(&testing::ball(4), 0.02)),
        ("noisy torus", testing::noisy(&testing::torus(60, 24), 0.03)),
        ("knot", testing::knot(200, 16)),
        ("two rings", testing::double_ring(3)),
        ("tetrahedron", testing::ball(0)),
        ("hill", testing::hill(20)),
        ("cylinder", testing::cylinder(30, 16)),
    ];
    for (name, mesh) in &meshes {
        for kind in [Kind::Square, Kind::Rectangle, Kind::Circle] {
            for (k, direction) in directions().into_iter().enumerate() {
                let params = SurfaceFieldParams {
                    direction,
                    ..of_size(kind, 0.15)
                };
                let fields = build(mesh, params);
                let sum = fields.index_sum() + fields.border_index();
                assert_eq!(sum, mesh.euler() as f64, "{name} {kind:?} {k}");
                if mesh.borders().is_empty() {
                    assert_eq!(fields.border_index(), 0.0);
                }
            }
        }
    }
}

#[test]
fn without_sources_singular_places_keep_away_from_each_other() {
    for (kind, count, apart) in [
        (Kind::Square, 8, 0.9),
        (Kind::Rectangle, 4, 1.2),
        (Kind::Circle, 12, 0.7),
    ] {
        let fields = build(&testing::ball(5), of_size(kind, 0.1));
        let points = fields.singular_points();
        assert_eq!(points.len(), count, "{kind:?}");
        for (k, a) in points.iter().enumerate() {
            assert_eq!(a.turns, 1);
            for b in &points[..k] {
                let far = a.at.at.distance(b.at.at);
                assert!(far > apart, "{kind:?}: {far}");
            }
        }
    }
}

#[test]
#[ignore = "prints how long things take"]
fn times() {
    #[allow(clippy::disallowed_methods, reason = "measures only")]
    fn now() -> std::time::Instant {
        std::time::Instant::now()
    }
    for (name, mesh) in [
        ("torus 20k", testing::torus(260, 77)),
        ("torus 163k", testing::torus(740, 220)),
        ("ball 164k", testing::ball(7)),
        ("knot 163k", testing::knot(2040, 80)),
    ] {
        let mesh = Arc::new(mesh);
        for (k, direction) in directions().into_iter().enumerate() {
            for kind in [Kind::Square, Kind::Rectangle] {
                let params = SurfaceFieldParams {
                    direction: direction.clone(),
                    size: SizeParams {
                        amount: Amount::Count(mesh.positions().len() as f64 / 16.0),
                        ..SizeParams::default()
                    },
                    kind,
                    ..SurfaceFieldParams::default()
                };
                let start = now();
                let mut builder = SurfaceFieldBuilder::new(mesh.clone(), params);
                let (mut longest, mut slices) = (0.0_f64, 0);
                loop {
                    let begin = now();
                    let done = builder.advance();
                    longest = longest.max(begin.elapsed().as_secs_f64() * 1e3);
                    slices += 1;
                    if done {
                        break;
                    }
                }
                let fields = builder.finish();
                let all = start.elapsed().as_secs_f64() * 1e3;
                let points = fields.singular_points();
                println!(
                    "{name} {kind:?} {k}: {all:.0} ms, slices {slices}, longest {longest:.1}, singular {} sum {} iterations {}",
                    points.len(),
                    fields.index_sum(),
                    fields.iterations
                );
            }
        }
        let fields = build(&mesh, of_size(Kind::Square, 0.1));
        let places: Vec<SurfacePoint> = (0..mesh.triangles().len() as u32)
            .map(|t| SurfacePoint::new(&mesh, t, DVec3::new(0.2, 0.3, 0.5)))
            .collect();
        let start = now();
        let sum: f64 = places.iter().map(|p| fields.at(p).axis.x).sum();
        let each = start.elapsed().as_secs_f64() * 1e9 / places.len() as f64;
        let start = now();
        let search = Search::new(&mesh);
        let made = start.elapsed().as_secs_f64() * 1e3;
        let start = now();
        let found: f64 = places
            .iter()
            .step_by(10)
            .map(|p| search.closest(&mesh, p.at * 1.01).at.x)
            .sum();
        let asked = start.elapsed().as_secs_f64() * 1e9 / places.len() as f64 * 10.0;
        println!(
            "{name}: asked {each:.0} ns ({sum:.1}); search made {made:.0} ms, closest {asked:.0} ns ({found:.1})"
        );
    }
}
