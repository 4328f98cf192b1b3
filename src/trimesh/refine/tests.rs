use super::super::testing::{self, mesh};
use super::*;

fn longest(mesh: &TriMesh, allowed: impl Fn(DVec3) -> f64) -> f64 {
    let edge = |t: u32, k: usize| {
        let corners = mesh.corners(t);
        let (a, b) = (corners[k], corners[(k + 1) % 3]);
        (a - b).length() / allowed(a).min(allowed(b))
    };
    let all = (0..mesh.triangles().len() as u32).flat_map(|t| [0, 1, 2].map(|k| edge(t, k)));
    all.fold(0.0, f64::max)
}

fn least_angle(mesh: &TriMesh) -> f64 {
    let angle = |t: u32, k: usize| {
        let p = mesh.corners(t);
        let (e, f) = (p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]);
        libm::atan2(e.cross(f).length(), e.dot(f)).to_degrees()
    };
    let all = (0..mesh.triangles().len() as u32).flat_map(|t| [0, 1, 2].map(|k| angle(t, k)));
    all.fold(180.0, f64::min)
}

#[test]
fn edges_become_short_enough_and_the_surface_stays() {
    for (soup, target) in [
        (testing::blob(2), 0.05),
        (testing::cube(1), 0.07),
        (testing::torus(24, 10, 0.4), 0.04),
        (testing::two_holes(1), 0.11),
        (testing::tube(5, 1), 0.1),
        (testing::flat(4), 0.021),
    ] {
        let old = mesh(soup);
        let new = Refining::evenly(old.clone(), target).finish_all().unwrap();
        assert!(longest(&new.mesh, |_| target) <= 1.0);
        assert_eq!(new.mesh.euler(), old.euler());
        assert_eq!(new.mesh.parts().1, old.parts().1);
        assert_eq!(new.mesh.borders().len(), old.borders().len());
        assert!((new.mesh.area() - old.area()).abs() < 1e-9 * old.area());
        // No angle becomes much smaller, and there are not many more triangles than needed.
        assert!(least_angle(&new.mesh) > 0.45 * least_angle(&old).min(40.0));
        let least = old.area() / (0.433 * target * target);
        assert!(
            (new.mesh.triangles().len() as f64) < 7.0 * least + 4.0 * old.triangles().len() as f64
        );
        for (t, &from) in new.origin.iter().enumerate() {
            let dot = new.mesh.face_normal(t as u32).dot(old.face_normal(from));
            assert!(dot > 1.0 - 1e-9);
        }
        let count = old.positions().len();
        for (k, parents) in new.parents.iter().enumerate() {
            let [a, b] = parents.map(|v| new.mesh.positions()[v as usize]);
            assert_eq!(new.mesh.positions()[count + k], 0.5 * (a + b));
        }
    }
}

#[test]
fn lengths_may_vary() {
    let allowed = |p: DVec3| 0.02 + 0.2 * p.x;
    let old = mesh(testing::flat(3));
    let targets = old.positions().iter().map(|&p| allowed(p)).collect();
    let mut refining = Refining::new(old.clone(), targets);
    let new = loop {
        if let Some(new) = refining.advance(&|p, _| allowed(p)) {
            break new.unwrap().mesh;
        }
    };
    assert!(longest(&new, allowed) <= 1.0 && longest(&new, |_| 0.1) > 1.0);
    let evenly = Refining::evenly(old, 0.02).finish_all().unwrap().mesh;
    assert!(3 * new.triangles().len() < evenly.triangles().len());
}

#[test]
fn short_edges_stay() {
    let old = mesh(testing::blob(3));
    let new = Refining::evenly(old.clone(), 1.0).finish_all().unwrap();
    assert_eq!(new.mesh, old);
    assert!(new.parents.is_empty());
}

/// All triangles as the bits of their corners' positions.
fn places(mesh: &TriMesh) -> Vec<[[u64; 3]; 3]> {
    let bits = |p: DVec3| p.to_array().map(f64::to_bits);
    let count = mesh.triangles().len() as u32;
    let mut all: Vec<[[u64; 3]; 3]> = (0..count)
        .map(|t| {
            let mut corners = mesh.corners(t).map(bits);
            corners.sort_unstable();
            corners
        })
        .collect();
    all.sort_unstable();
    all
}

#[test]
fn the_order_of_triangles_does_not_matter() {
    let (positions, mut triangles) = testing::noisy(testing::blob(3), 0.02);
    let refined = |triangles: &[[u32; 3]]| {
        let mesh = mesh((positions.clone(), triangles.to_vec()));
        places(&Refining::evenly(mesh, 0.06).finish_all().unwrap().mesh)
    };
    let one = refined(&triangles);
    triangles.reverse();
    for t in &mut triangles {
        t.rotate_left(1);
    }
    assert!(one == refined(&triangles));
}

#[test]
fn too_many_triangles_are_a_sentence_before_they_are_made() {
    let refused = Refining::evenly(mesh(testing::cube(1)), 1e-3).finish_all();
    let sentence = refused.unwrap_err();
    assert_eq!(sentence.code, Code::RefinedTooMany);
    assert!(sentence.to_string().contains("14000000"), "{sentence}");
    let refused = Refining::evenly(mesh(testing::cube(1)), 1e-300).finish_all();
    assert!(refused.is_err());
}
