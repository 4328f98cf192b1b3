//! The fields together.

mod follow;
mod values;

use super::*;
use crate::trimesh::{Search, samples};

fn build(mesh: &TriMesh, params: SurfaceFieldParams) -> SurfaceFields {
    SurfaceFieldBuilder::build(Arc::new(mesh.clone()), params)
}

fn of_size(kind: CellKind, size: f64) -> SurfaceFieldParams {
    SurfaceFieldParams {
        kind,
        size: SizeParams {
            amount: Amount::Size(size),
            ..SizeParams::default()
        },
        ..SurfaceFieldParams::default()
    }
}

/// The axis at a point, turned by a multiple of a half, quarter or sixth turn to the direction nearest to the flow.
fn one_sense(fields: &SurfaceFields, p: &SurfacePoint) -> DVec2 {
    let flow = fields.flow(p);
    let part = match fields.symmetry() {
        4 => DVec2::Y,
        6 => DVec2::new(0.5, 0.866_025_403_784_438_6),
        _ => DVec2::NEG_X,
    };
    let mut turned = fields.axis(p);
    let mut best = turned;
    for _ in 1..fields.symmetry() {
        turned = turned.rotate(part);
        if turned.dot(flow) > best.dot(flow) {
            best = turned;
        }
    }
    best
}

/// Parameters of directions that use different constraints.
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
        ("ball", samples::ball(4)),
        ("blob", samples::blob(4)),
        ("torus", samples::torus(60, 24)),
        ("facets", samples::torus(24, 10)),
        ("noisy ball", samples::noisy(&samples::ball(4), 0.02)),
        ("noisy torus", samples::noisy(&samples::torus(60, 24), 0.03)),
        ("knot", samples::knot(200, 16)),
        ("two rings", samples::double_ring(3)),
        ("tetrahedron", samples::ball(0)),
        ("hill", samples::hill(20)),
        ("cylinder", samples::cylinder(30, 16)),
    ];
    for (name, mesh) in &meshes {
        for kind in [CellKind::Square, CellKind::Rectangle, CellKind::Circle] {
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
        (CellKind::Square, 8, 0.9),
        (CellKind::Rectangle, 4, 1.2),
        (CellKind::Circle, 12, 0.7),
    ] {
        let fields = build(&samples::ball(5), of_size(kind, 0.1));
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

/// The frame's vector in space.
fn out(p: &SurfacePoint, v: DVec2) -> DVec3 {
    p.frame().out(v)
}

fn middles(mesh: &TriMesh) -> impl Iterator<Item = SurfacePoint> + '_ {
    let all = 0..mesh.triangles().len() as u32;
    all.map(|t| SurfacePoint::new(mesh, t, DVec3::splat(1.0 / 3.0)))
}

fn angle(a: DVec3, b: DVec3) -> f64 {
    libm::acos(a.dot(b).abs().min(1.0)).to_degrees()
}

#[test]
fn it_is_the_same_however_it_is_cut() {
    let stroke = |mesh: &TriMesh| {
        let ends = [0, 40].map(|v| mesh.vertex_point(v).unwrap());
        Stroke::through(mesh, &ends, 0.2)
    };
    let mesh = samples::blob(3);
    let direction = DirectionParams {
        curvature: 1.0,
        creases: 1.0,
        strokes: vec![stroke(&mesh)],
        ..DirectionParams::default()
    };
    let mut params = SurfaceFieldParams {
        direction,
        ..of_size(CellKind::Ellipse, 0.2)
    };
    params.aspect.by_curvature = true;
    params.aspect.aspect = 2.0;
    params.size.curvature = Some(ByCurvature {
        angle: 0.2,
        factors: (0.4, 1.6),
    });
    params.flow = Some(FlowParams {
        axis: 1.0,
        ..FlowParams::default()
    });
    let all = build(&mesh, params.clone());
    for amount in [1, 37] {
        let mut builder = SurfaceFieldBuilder::new(Arc::new(mesh.clone()), params.clone());
        while !builder.advance_by(amount) {}
        let cut = builder.finish();
        assert_eq!((&cut.sizes, &cut.aspects), (&all.sizes, &all.aspects));
        assert_eq!((&cut.axes, &cut.flows), (&all.axes, &all.flows));
        assert_eq!(cut.curvature, all.curvature);
    }
}

#[test]
fn no_flow_where_nothing_tells_one() {
    let mesh = samples::torus(30, 12);
    let mut params = of_size(CellKind::Square, 0.2);
    params.flow = Some(FlowParams::default());
    let fields = build(&mesh, params);
    let p = middles(&mesh).next().unwrap();
    assert_eq!(fields.flow(&p), DVec2::ZERO);
}

#[test]
fn each_part_has_its_own_direction() {
    let ball = samples::ball(4);
    let n = ball.positions().len() as u32;
    let more = ball.positions().iter().map(|&p| 0.5 * p + DVec3::X * 3.0);
    let mut positions: Vec<DVec3> = ball.positions().iter().copied().chain(more).collect();
    // A point of no triangle does not count as a part.
    positions.push(DVec3::splat(9.0));
    let second = ball.triangles().iter().map(|t| t.map(|v| v + n));
    let triangles = ball.triangles().iter().copied().chain(second).collect();
    let mesh = TriMesh::new(positions, triangles).unwrap();
    let search = Search::new(&mesh);
    let places = [DVec3::X, DVec3::Y].map(|p| search.closest(&mesh, p));
    let mut params = of_size(CellKind::Square, 0.2);
    params.direction.strokes = vec![Stroke::through(&mesh, &places, 0.2)];
    let fields = build(&mesh, params);
    let half = |s: &SurfaceSingularity| s.at.triangle >= ball.triangles().len() as u32;
    let points = fields.singular_points();
    let second: Vec<_> = points.iter().filter(|s| half(s)).collect();
    assert_eq!(second.iter().map(|s| s.turns).sum::<i32>(), 8);
    assert_eq!(second.len(), 8);
    assert_eq!(fields.index_sum(), 4.0);
}
