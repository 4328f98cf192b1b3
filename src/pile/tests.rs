use super::fixture::{self, PARAMS, count, deepest_overlap, pierced};
use super::{
    Body, Dart, Fate, Kind, Method, Reading, RefineParams, Refining, Turn, Wall, same_side,
};
use crate::random::{Purpose, Random};
use crate::trimesh::running_sums::RunningSums;
use crate::trimesh::{SurfacePoint, TriMesh};
use glam::DVec3;

/// Points of the surface, uniform by area.
fn probes(mesh: &TriMesh, count: usize) -> Vec<SurfacePoint> {
    let sums = RunningSums::of_areas(mesh);
    let mut random = Random::new(9, Purpose::Scatter, 0);
    (0..count)
        .map(|_| super::darts::anywhere(mesh, &sums, &mut random))
        .collect()
}

fn sided_distance(dart: &Dart, at: DVec3, normal: DVec3) -> f64 {
    match same_side(dart.normal, normal) {
        true => dart.at.distance(at),
        false => f64::INFINITY,
    }
}

#[test]
fn darts_are_even_and_leave_no_hole() {
    for (mesh, spacing) in [
        (fixture::heap(14.0), 1.1),
        (fixture::globe(5.0), 0.8),
        (fixture::globe(0.9), 2.5),
    ] {
        let kinds = [Kind {
            density: spacing,
            ..fixture::ball()
        }];
        let darts = fixture::darts(&mesh, &kinds, 1, false, 1000);
        for (k, a) in darts.iter().enumerate() {
            let others = darts[..k].iter().chain(&darts[k + 1..]);
            let nearest = others
                .map(|b| sided_distance(b, a.at, a.normal))
                .fold(f64::INFINITY, f64::min);
            assert!(nearest >= spacing, "{nearest} of {spacing}");
            // Requirement R3: neighbours overlap, since their distance is less than 4 r.
            assert!(darts.len() < 9 || nearest < 2.0 * spacing);
        }
        for p in probes(&mesh, 4000) {
            let nearest = darts
                .iter()
                .map(|d| sided_distance(d, p.at, p.normal))
                .fold(f64::INFINITY, f64::min);
            assert!(nearest <= spacing, "{nearest} of {spacing}");
        }
    }
}

/// How much the distances between near points gather at one length: the densest shell over the mean, less 1.
fn strongest_peak(points: &[DVec3], spacing: f64) -> f64 {
    // Shells from 2 to 6 spacings: a distribution without a period has the same density in each of them.
    const SHELLS: usize = 40;
    let mut counts = [0.0; SHELLS];
    for (k, a) in points.iter().enumerate() {
        for b in &points[..k] {
            let shell = (a.distance(*b) / spacing - 2.0) / 4.0 * SHELLS as f64;
            if (0.0..SHELLS as f64).contains(&shell) {
                let distance = 2.0 + 4.0 * (shell.floor() + 0.5) / SHELLS as f64;
                counts[shell as usize] += 1.0 / distance;
            }
        }
    }
    let mean = counts.iter().sum::<f64>() / SHELLS as f64;
    counts.iter().map(|c| c / mean - 1.0).fold(0.0, f64::max)
}

#[test]
fn darts_have_no_period() {
    let mesh = fixture::heap(30.0);
    let darts = fixture::darts(&mesh, &[fixture::ball()], 1, false, 1000);
    let points: Vec<DVec3> = darts
        .iter()
        .map(|d| d.at)
        .filter(|p| p.x.abs().max(p.z.abs()) < 22.0)
        .collect();
    let lattice: Vec<DVec3> = (0..2000)
        .map(|k| DVec3::new(f64::from(k % 45), 0.0, f64::from(k / 45)))
        .collect();
    let (own, regular) = (strongest_peak(&points, 1.0), strongest_peak(&lattice, 1.0));
    assert!(own < 0.2, "{own}");
    assert!(regular > 1.0, "{regular}");
}

/// How much the directions between near darts agree, 0 to 1: the greatest of the means of e^(i N φ) for N = 2, 4, 6.
fn agreement(darts: &[Dart]) -> f64 {
    let near = |a: &Dart, b: &Dart| a.at.distance(b.at) < 1.3;
    let pairs = darts.iter().enumerate().flat_map(|(k, a)| {
        darts[..k]
            .iter()
            .filter(move |b| near(a, b))
            .map(move |b| b.at - a.at)
    });
    let angles: Vec<f64> = pairs.map(|d| libm::atan2(d.z, d.x)).collect();
    let mean = |n: f64| {
        let sum: (f64, f64) = angles
            .iter()
            .map(|a| libm::sincos(n * a))
            .fold((0.0, 0.0), |s, a| (s.0 + a.0, s.1 + a.1));
        libm::hypot(sum.0, sum.1) / angles.len() as f64
    };
    [2.0, 4.0, 6.0].map(mean).into_iter().fold(0.0, f64::max)
}

#[test]
fn scan_order_shows_as_rows() {
    let mesh = fixture::heap(30.0);
    let [random, scan] = [false, true].map(|in_scan_order| {
        agreement(&fixture::darts(
            &mesh,
            &[fixture::ball()],
            1,
            in_scan_order,
            1000,
        ))
    });
    println!("agreement {random} {scan}");
    assert!(random < 0.05 && scan > 0.1, "{random} and {scan}");
}

#[test]
fn spheres_overlap_by_no_more_than_was_asked_for() {
    let mesh = fixture::heap(12.0);
    for (offset, removal) in [(0.0, 0.0), (0.1, 0.05), (0.3, 0.2)] {
        for kinds in [
            vec![fixture::ball()],
            vec![fixture::rod()],
            vec![fixture::ball(), fixture::rod()],
        ] {
            let params = RefineParams {
                offset,
                removal,
                ..PARAMS
            };
            let pile = fixture::pile(&mesh, kinds.clone(), &[], params, 50);
            let deepest = deepest_overlap(pile.bodies(), &kinds);
            assert!(deepest <= offset + removal + 1e-9, "{deepest}");
            assert!(deepest > offset - 1e-6, "bodies touch: {deepest}");
        }
    }
}

#[test]
fn each_dart_has_a_fate_and_each_body_is_in_its_range() {
    let mesh = fixture::globe(6.0);
    let large = Kind {
        scale: 2.0,
        density: 1.5,
        range: 0.3,
        ..fixture::ball()
    };
    let kinds = vec![large, fixture::rod()];
    let ground = Wall::Plane {
        normal: -DVec3::Y,
        offset: 5.0,
    };
    let pile = fixture::pile(&mesh, kinds.clone(), &[ground], PARAMS, 7);
    let fates =
        [Fate::Merged, Fate::Walls, Fate::Removed, Fate::Kept].map(|fate| count(&pile, fate));
    assert_eq!(fates.iter().sum::<usize>(), pile.bodies().len());
    assert!(fates.iter().all(|&n| n > 0), "{fates:?}");
    for body in pile.bodies().iter().filter(|b| b.fate == Fate::Kept) {
        let (lo, hi) = body.range;
        assert!(lo <= body.t && body.t <= hi);
        let shape = body.shape(&kinds);
        let lowest = shape
            .points
            .iter()
            .map(|&p| (body.place() + body.turn * (body.scale * p)).y)
            .fold(f64::INFINITY, f64::min);
        assert!(lowest >= -5.0 - 0.05 * body.radius(&kinds), "{lowest}");
    }
}

#[test]
fn any_slices_give_the_same_bits() {
    let mesh = fixture::heap(9.0);
    let kinds = || {
        vec![
            Kind {
                jitter: 0.2,
                ..fixture::rod()
            },
            fixture::ball(),
        ]
    };
    for method in [
        Method::Exact,
        Method::Golden {
            iterations: 15,
            reading: Reading::Nearest,
        },
    ] {
        let params = RefineParams {
            method,
            retries: 2,
            ..PARAMS
        };
        let whole = fixture::pile(&mesh, kinds(), &[], params, usize::MAX);
        assert_eq!(
            whole.bodies(),
            fixture::pile(&mesh, kinds(), &[], params, 1).bodies()
        );
    }
}

/// The mean number of kept bodies over five seeds.
fn mean_kept(mesh: &TriMesh, kind: &Kind, params: RefineParams) -> f64 {
    let kept = |seed| {
        count(
            &fixture::pile(
                mesh,
                vec![kind.clone()],
                &[],
                RefineParams { seed, ..params },
                1000,
            ),
            Fate::Kept,
        )
    };
    (1..=5).map(kept).sum::<usize>() as f64 / 5.0
}

#[test]
fn more_is_kept_with_more_overlap_and_more_range() {
    let mesh = fixture::heap(10.0);
    let rod = fixture::rod();
    let base = mean_kept(&mesh, &rod, PARAMS);
    assert!(
        mean_kept(
            &mesh,
            &rod,
            RefineParams {
                offset: 0.2,
                ..PARAMS
            }
        ) > base
    );
    assert!(
        mean_kept(
            &mesh,
            &rod,
            RefineParams {
                removal: 0.2,
                ..PARAMS
            }
        ) > base
    );
    assert!(
        mean_kept(
            &mesh,
            &Kind {
                range: 3.0,
                ..rod.clone()
            },
            PARAMS
        ) > base
    );
    assert!(
        mean_kept(
            &mesh,
            &rod,
            RefineParams {
                retries: 3,
                ..PARAMS
            }
        ) > base
    );
}

#[test]
fn the_exact_solver_keeps_no_fewer_than_golden_section() {
    let mesh = fixture::heap(8.0);
    for kind in [fixture::ball(), fixture::rod()] {
        let kept = |method| {
            let params = RefineParams { method, ..PARAMS };
            count(
                &fixture::pile(&mesh, vec![kind.clone()], &[], params, 1000),
                Fate::Kept,
            )
        };
        let exact = kept(Method::Exact);
        for reading in [Reading::Nearest, Reading::All] {
            let iterations = 15;
            let golden = kept(Method::Golden {
                iterations,
                reading,
            });
            println!("{reading:?}: {golden} of {exact}");
            assert!(
                5 * golden > exact && golden <= exact,
                "{reading:?}: {golden} of {exact}"
            );
        }
    }
}

#[test]
fn golden_section_keeps_what_eq_3_allows() {
    let mesh = fixture::heap(9.0);
    let kinds = vec![fixture::rod()];
    let method = Method::Golden {
        iterations: 15,
        reading: Reading::Nearest,
    };
    let pile = fixture::pile(
        &mesh,
        kinds.clone(),
        &[],
        RefineParams { method, ..PARAMS },
        1000,
    );
    let mut settled: Vec<&Body> = Vec::new();
    for &k in pile.history() {
        let body = &pile.bodies()[k as usize];
        if body.fate != Fate::Kept {
            continue;
        }
        let points = body
            .shape(&kinds)
            .points
            .iter()
            .map(|&p| body.place() + body.turn * (body.scale * p));
        for p in points {
            for other in &settled {
                let depth = other
                    .spheres(&kinds)
                    .map(|s| s.radius - s.centre.distance(p))
                    .fold(f64::NEG_INFINITY, f64::max);
                assert!(depth / other.radius(&kinds) <= PARAMS.offset + PARAMS.removal + 1e-9);
            }
        }
        settled.push(body);
    }
    assert!(settled.len() > 50);
}

#[test]
fn a_range_of_nothing_leaves_bodies_at_their_darts() {
    let mesh = fixture::heap(9.0);
    let kind = Kind {
        range: 0.0,
        ..fixture::ball()
    };
    let pile = fixture::pile(&mesh, vec![kind], &[], PARAMS, 1000);
    assert!(count(&pile, Fate::Kept) > 20);
    assert!(pile.bodies().iter().all(|b| b.t == 0.0));
}

#[test]
fn bodies_of_a_global_frame_lie_level() {
    let mesh = fixture::globe(6.0);
    let turn = Turn {
        ranges: DVec3::ZERO,
        is_global: true,
    };
    let pile = fixture::pile(
        &mesh,
        vec![Kind {
            turn,
            ..fixture::rod()
        }],
        &[],
        PARAMS,
        1000,
    );
    let kept = pile.bodies().iter().filter(|b| b.fate == Fate::Kept);
    assert!(kept.clone().count() > 100 && kept.clone().all(|b| b.turn == glam::DMat3::IDENTITY));
}

#[test]
fn a_layer_lies_at_its_depth() {
    let mesh = fixture::globe(6.0);
    let search = crate::trimesh::Search::new(&mesh);
    let mut layer = super::LayerDarting::new(&mesh, (0, 1), 2.0, 1.0, 1);
    while !layer.advance(&mesh, &search, 100) {}
    // The mesh is a polyhedron inside of its ball.
    let radii = layer.darts().iter().map(|d| d.at.length());
    assert!(radii.clone().all(|r| (3.7..4.1).contains(&r)));
    let full = super::expected_darts(4.0 * std::f64::consts::PI * 16.0, 1.0);
    assert!(
        layer.darts().len() as f64 > 0.85 * full,
        "{} of {full}",
        layer.darts().len()
    );
}

fn pierced_by_normals(pile: &Refining, kinds: &[Kind]) -> usize {
    let mut counts: Vec<usize> = pile
        .bodies()
        .iter()
        .map(|b| pierced(pile.bodies(), kinds, (b.at, b.normal), 20.0))
        .collect();
    counts.sort_unstable();
    counts[counts.len() / 2]
}

#[test]
fn the_natural_range_pierces_three_to_five_bodies() {
    let mesh = fixture::heap(16.0);
    let volume = 4.0 / 3.0 * std::f64::consts::PI;
    let ball = fixture::ball();
    let range = super::natural_range(volume, 3.0 * volume, ball.diagonal());
    let kinds = vec![Kind {
        range,
        density: 0.75,
        ..ball
    }];
    let pile = fixture::pile(&mesh, kinds.clone(), &[], PARAMS, 1000);
    let median = pierced_by_normals(&pile, &kinds);
    assert!((3..=5).contains(&median), "{median} with the range {range}");
}
