//! Tests of where darts lie.

use super::fixture;
use super::{Dart, Kind, same_side};
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
