use super::island::join_lone;
use super::quads::Faces;
use super::triangles::{NONE, Triangles};
use super::*;
use crate::domain::{cross, signed_area};
use crate::planar::unit_vector;
use crate::random::{Purpose, Random};

fn even(points: Vec<DVec2>) -> Vec<Node> {
    points.into_iter().map(Node::plain).collect()
}

fn plain_delaunay(points: Vec<DVec2>) -> IncrementalDelaunay {
    IncrementalDelaunay::new(even(points))
}

fn delaunay(nodes: &[Node]) -> Triangles {
    IncrementalDelaunay::new(nodes.to_vec()).finish().1
}

fn lattice(n: u32) -> Vec<DVec2> {
    (0..n * n)
        .map(|k| DVec2::new(f64::from(k % n), f64::from(k / n)))
        .collect()
}

#[test]
fn a_lattice_becomes_quads_with_four_around_each_inner_node() {
    let mesh = Mesh::whole(plain_delaunay(lattice(6)), |_| false, 0);
    assert_eq!(mesh.faces.len(), 25);
    assert!(mesh.faces.iter().all(|f| f.nodes().len() == 4));
    let fans = mesh.fans();
    for k in 0..36 {
        let (x, y) = (k % 6, k / 6);
        let inner = x > 0 && x < 5 && y > 0 && y < 5;
        assert_eq!(fans.row(k).len(), if inner { 4 } else { 0 });
    }
}

#[test]
fn fans_run_clockwise_on_screen() {
    let mut points = lattice(5);
    points[12] += DVec2::new(0.21, -0.13);
    let mesh = Mesh::whole(plain_delaunay(points), |_| false, 0);
    let ring: Vec<DVec2> = mesh
        .fans()
        .row(12)
        .iter()
        .map(|&f| mesh.faces[f as usize].centroid(&mesh.vertices))
        .collect();
    assert!(crate::domain::signed_area(&ring) > 0.5);
}

#[test]
fn degenerate_points_give_no_elements() {
    let line: Vec<DVec2> = (0..9).map(|k| DVec2::new(f64::from(k), 0.0)).collect();
    assert!(
        Mesh::whole(plain_delaunay(line), |_| false, 0)
            .faces
            .is_empty()
    );
    assert!(
        Mesh::whole(plain_delaunay(vec![]), |_| false, 0)
            .faces
            .is_empty()
    );
    assert!(
        Mesh::whole(plain_delaunay(vec![DVec2::ONE; 4]), |_| false, 0)
            .faces
            .is_empty()
    );
}

/// Points of a lattice, each displaced by up to `jitter` on both axes.
fn jittered(n: u32, jitter: f64, seed: u64) -> Vec<Node> {
    let mut random = Random::new(seed, Purpose::Placement, 0);
    let mut nodes = even(lattice(n));
    for node in &mut nodes {
        node.at += jitter * DVec2::new(random.signed(), random.signed());
    }
    nodes
}

fn lone(mesh: &Mesh) -> usize {
    mesh.faces.iter().filter(|f| f.sides == 3).count()
}

fn area(triangles: &Triangles, nodes: &[Node]) -> f64 {
    let areas = triangles.nodes.iter().map(|t| {
        let [a, b, c] = t.map(|k| nodes[k as usize].at);
        let area = cross(a, b, c) / 2.0;
        assert!(area > 0.0);
        area
    });
    areas.sum()
}

fn sides(triangles: &Triangles) -> Vec<[u32; 2]> {
    let mut sides: Vec<[u32; 2]> = Vec::new();
    for &[a, b, c] in &triangles.nodes {
        sides.extend([[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)]));
    }
    sides.sort_unstable();
    sides.dedup();
    sides
}

#[test]
fn under_one_metric_flips_give_the_delaunay_triangulation_of_the_shrunk_points() {
    for (seed, aspect) in [(1, 1.5), (2, 2.0), (3, 3.0), (4, 5.0)] {
        let axis = unit_vector(0.3 + seed as f64);
        let mut nodes = jittered(20, 0.49, seed);
        for node in &mut nodes {
            node.metric = Metric::new(axis, aspect);
        }
        let mut shrunk = nodes.clone();
        for node in &mut shrunk {
            let (along, across) = (axis.dot(node.at), axis.perp_dot(node.at));
            node.at = DVec2::new(along / aspect.sqrt(), across * aspect.sqrt());
        }
        let mut triangles = delaunay(&nodes);
        let plain = sides(&triangles);
        triangles.flip_to_metric(&nodes, |_| false);
        let exact = sides(&delaunay(&shrunk));
        let made = sides(&triangles);
        let missing = exact.iter().filter(|s| made.binary_search(s).is_err());
        assert_eq!(missing.count(), 0, "aspect {aspect}");
        assert_eq!(made.len(), exact.len());
        assert!(made != plain);
    }
}

#[test]
fn flips_under_a_metric_that_turns_within_few_cells_end_in_a_valid_triangulation() {
    for seed in 0..8 {
        let mut nodes = jittered(25, 0.49, seed);
        for node in &mut nodes {
            let turn = (0.7 + 0.2 * seed as f64) * (node.at.x + 0.3 * node.at.y);
            node.metric = Metric::new(unit_vector(turn), 2.0 + seed as f64);
        }
        let mut triangles = delaunay(&nodes);
        let before = area(&triangles, &nodes);
        let held: Vec<[u32; 2]> = sides(&triangles).into_iter().step_by(9).collect();
        triangles.flip_to_metric(&nodes, |side| held.binary_search(&side).is_ok());
        assert!((area(&triangles, &nodes) - before).abs() < 1e-6 * before);
        let after = sides(&triangles);
        assert!(held.iter().all(|side| after.binary_search(side).is_ok()));
        for (t, adjacent) in triangles.adjacent.iter().enumerate() {
            for &u in adjacent.iter().filter(|&&u| u != NONE) {
                assert!(triangles.adjacent[u as usize].contains(&(t as u32)));
            }
        }
    }
}

#[test]
fn stretched_lattices_become_quads_and_round_cells_triangles() {
    for aspect in [1.5, 2.0, 3.0, 5.0] {
        let axis = unit_vector(0.4);
        let mut nodes = even(lattice(9));
        for node in &mut nodes {
            node.at = axis * node.at.x * aspect + axis.perp() * node.at.y;
            node.metric = Metric::new(axis, aspect);
        }
        let mesh = Mesh::whole(IncrementalDelaunay::new(nodes.clone()), |_| false, 0);
        // Slivers from rounding along the border are triangles, too.
        assert_eq!(mesh.faces.len() - lone(&mesh), 64);
        for node in &mut nodes {
            node.corners = false;
        }
        let mesh = Mesh::whole(IncrementalDelaunay::new(nodes.clone()), |_| false, 0);
        assert_eq!(mesh.faces.len(), lone(&mesh));
        // A single round cell keeps the elements around it triangles.
        let mut nodes = even(lattice(9));
        nodes[40].corners = false;
        let mesh = Mesh::whole(IncrementalDelaunay::new(nodes.clone()), |_| false, 0);
        assert!((4..=8).contains(&lone(&mesh)));
    }
}

#[test]
fn joining_leaves_few_triangles_and_a_valid_mesh() {
    for seed in 0..6 {
        let mut nodes = jittered(24, 0.3, seed);
        let mut triangles = delaunay(&nodes);
        triangles.flip_to_metric(&nodes, |_| false);
        let mut made = quads::pair(&nodes[..], &triangles, |_| false, 0);
        let lone = |made: &Faces| made.faces.iter().filter(|f| f.sides == 3).count();
        let paired = lone(&made);
        let at = |k: usize| (k % 24, k / 24);
        let held = |k: usize| [at(k).0, at(k).1].iter().any(|&c| c == 0 || c == 23);
        let before = nodes.clone();
        join_lone(&mut nodes, &mut made, held, |_| false);
        assert!(2 * lone(&made) < paired, "{} of {paired}", lone(&made));
        for (k, (old, new)) in before.iter().zip(&nodes).enumerate() {
            assert!(!held(k) || old.at == new.at);
        }
        let mut sum = 0.0;
        for face in made.faces.iter().filter(|f| f.sides > 0) {
            let ring: Vec<DVec2> = face.nodes().iter().map(|&k| nodes[k as usize].at).collect();
            for k in 0..ring.len() {
                let n = ring.len();
                assert!(cross(ring[(k + n - 1) % n], ring[k], ring[(k + 1) % n]) > 0.0);
            }
            sum += signed_area(&ring);
        }
        assert!((sum - area(&triangles, &before)).abs() < 1e-6 * sum);
        // Adjacency is symmetric, over the same side.
        for (f, (face, adjacent)) in made.faces.iter().zip(&made.adjacent).enumerate() {
            let n = face.nodes().len();
            for k in (0..n).filter(|&k| face.sides > 0 && adjacent[k] != NONE) {
                let side = [face.nodes()[(k + 1) % n], face.nodes()[k]];
                let other = made.faces[adjacent[k] as usize];
                let m = other.nodes().len();
                let back = (0..m).find(|&j| [other.nodes()[j], other.nodes()[(j + 1) % m]] == side);
                let back = back.expect("the side runs back along the neighbour");
                assert_eq!(made.adjacent[adjacent[k] as usize][back], f as u32);
            }
        }
    }
}

#[test]
fn sides_to_be_kept_are_not_dissolved() {
    let nodes = jittered(20, 0.3, 5);
    let triangles = delaunay(&nodes);
    let held: Vec<[u32; 2]> = sides(&triangles).into_iter().step_by(5).collect();
    let keep = |side| held.binary_search(&side).is_ok();
    let mut made = quads::pair(&nodes[..], &triangles, keep, 0);
    requad::requadrangulate(&nodes[..], &mut made, 0.2, 0, keep);
    for &[a, b] in &held {
        let has = |face: &Face| {
            let n = face.nodes();
            (0..n.len()).any(|k| {
                let side = [n[k], n[(k + 1) % n.len()]];
                side == [a, b] || side == [b, a]
            })
        };
        assert!(made.faces.iter().any(|f| f.sides > 0 && has(f)));
    }
}

#[test]
fn every_inner_node_of_a_whole_mesh_keeps_four_elements() {
    for seed in 0..6 {
        let nodes = jittered(24, 0.3, seed);
        let mut before = vec![0; nodes.len()];
        for &k in delaunay(&nodes).nodes.iter().flatten() {
            before[k as usize] += 1;
        }
        let mesh = Mesh::whole(IncrementalDelaunay::new(nodes), |_| false, 4);
        let fans = mesh.fans();
        for (k, before) in before.into_iter().enumerate() {
            let after = fans.row(k).len();
            assert!(
                after == 0 || after >= before.min(4),
                "{k}: {before}, {after}"
            );
        }
    }
}
