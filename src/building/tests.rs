//! Properties of buildings by rule: both meshes are whole, and agree with each other.

use super::*;
use crate::random::{Purpose, Random};
use glam::DVec3;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// Every rule with its defaults, at its limits, and at random within its ranges.
fn drafts() -> Vec<(String, Draft)> {
    let mut all = Vec::new();
    for (k, rule) in Rule::ALL.into_iter().enumerate() {
        let numbers = rule.numbers();
        let limit =
            |side: fn(&crate::shapes::ShapeNumber) -> f64| numbers.iter().map(side).collect();
        let mut choices: Vec<Vec<f64>> = vec![Vec::new(), limit(|n| n.least), limit(|n| n.most)];
        for seed in 0..4 {
            let mut random = Random::new(seed, Purpose::Size, k as u64);
            let each = numbers.iter();
            choices.push(
                each.map(|n| n.least + random.unit() * (n.most - n.least))
                    .collect(),
            );
        }
        for choice in choices {
            let name = format!("{} {choice:?}", rule.word());
            all.push((name, rule.draft(&Module::NORMAL, &choice)));
        }
    }
    all
}

/// The drafts and their buildings, with their names. Tests share them.
pub(super) fn all() -> &'static [(String, Draft, Building)] {
    static ALL: OnceLock<Vec<(String, Draft, Building)>> = OnceLock::new();
    ALL.get_or_init(|| {
        let with_building = |(name, draft): (String, Draft)| {
            let building = built(&name, &draft);
            (name, draft, building)
        };
        drafts().into_iter().map(with_building).collect()
    })
}

pub(super) fn built(name: &str, draft: &Draft) -> Building {
    Building::new(draft).unwrap_or_else(|fault| panic!("{name}: {fault:?}"))
}

/// The number of connected parts of the child mesh.
fn parts(building: &Building) -> usize {
    let mut label: Vec<usize> = (0..building.polygons().len()).collect();
    fn root(label: &[usize], mut k: usize) -> usize {
        while label[k] != k {
            k = label[k];
        }
        k
    }
    for edge in building.polygon_edges() {
        if let [Some(a), Some(b)] = edge.polygons {
            let (a, b) = (root(&label, a.index()), root(&label, b.index()));
            label[a.max(b)] = a.min(b);
        }
    }
    (0..label.len()).filter(|&k| label[k] == k).count()
}

/// The number of open edges of a building.
fn open(building: &Building) -> usize {
    building
        .edges()
        .iter()
        .filter(|edge| edge.bend == Bend::Open)
        .count()
}

/// The number of openings that do not reach the ground.
fn sills(building: &Building) -> usize {
    let is_sill = |face: &&Face| face.labels.iter().any(|label| label == labels::SILL);
    building.faces().iter().filter(is_sill).count()
}

/// The number of holes through the solids of a rule's building.
fn genus(rule: &str, building: &Building) -> usize {
    match rule {
        "wall" => 3,
        "ring" => 1,
        "tower" => 1 + sills(building),
        "plan" => sills(building),
        _ => 0,
    }
}

#[test]
fn both_meshes_obey_euler() {
    for (name, _, building) in all() {
        let rule = name.split(' ').next().unwrap();
        let (parts, genus) = (parts(building), genus(rule, building));
        let border = usize::from(rule == "sheet");
        assert_eq!(open(building) > 0, border > 0, "{name}");
        let wanted = 2 * (parts as i64) - 2 * (genus as i64) - border as i64;
        let used = building
            .polygon_edges()
            .iter()
            .flat_map(|edge| edge.vertices);
        let vertices = used.collect::<std::collections::BTreeSet<_>>().len();
        assert_eq!(vertices, building.vertices().len(), "{name}");
        let count = |n: usize| n as i64;
        let euler = count(vertices) - count(building.polygon_edges().len());
        assert_eq!(euler + count(building.polygons().len()), wanted, "{name}");
        // A closed edge brings a vertex of its own, and each loop of a face after its first counts as -1.
        let closed = building
            .edges()
            .iter()
            .filter(|edge| edge.is_closed())
            .count();
        let rings: usize = building.faces().iter().map(|face| face.loops.len()).sum();
        let faces = 2 * count(building.faces().len()) - count(rings);
        let euler = count(building.corners().len() + closed) - count(building.edges().len());
        assert_eq!(euler + faces, wanted, "{name}");
    }
}

#[test]
fn child_and_parent_agree() {
    for (name, _, building) in all() {
        for id in building.edge_ids() {
            let edge = building.edge(id);
            let mut at = edge.path.point(0.0);
            for &(part, forward) in &edge.chain {
                let part = building.polygon_edge(part);
                assert_eq!(part.edge, Some(id), "{name}");
                let ends = part.vertices.map(|v| building.vertex(v).position);
                let [from, to] = if forward { ends } else { [ends[1], ends[0]] };
                assert!(from.distance(at) < 1e-9, "{name}");
                at = to;
                let faces = part.polygons.map(|p| p.map(|p| building.polygon(p).face));
                let wanted = if forward {
                    edge.faces
                } else {
                    [edge.faces[1], edge.faces[0]]
                };
                assert_eq!(faces, wanted, "{name}");
            }
            assert!(at.distance(edge.path.point(edge.length())) < 1e-9, "{name}");
            for (end, corner) in edge.corners.iter().enumerate() {
                let Some(corner) = *corner else { continue };
                let place = edge.path.point(edge.length() * end as f64);
                assert!(building.place(corner).distance(place) < 1e-9, "{name}");
                let ends = &building.corner(corner).edges;
                assert!(ends.contains(&EdgeEnd { edge: id, end }), "{name}");
            }
        }
        for id in building.corner_ids() {
            let corner = building.corner(id);
            assert_eq!(building.vertex(corner.vertex).corner, Some(id));
            assert_eq!(corner.edges.len(), corner.class.valence);
        }
        for (k, polygon) in building.polygons().iter().enumerate() {
            let own = PolygonId(k as u32);
            assert!(building.face(polygon.face).polygons.contains(&own));
        }
    }
}

#[test]
fn walks_along_the_wings_are_the_loops() {
    for (name, _, building) in all() {
        for face in building.face_ids() {
            for ring in &building.face(face).loops {
                for (k, step) in ring.iter().enumerate() {
                    let edge = building.edge(step.edge);
                    let side = usize::from(!step.forward);
                    assert_eq!(edge.faces[side], Some(face), "{name}");
                    let next = ring[(k + 1) % ring.len()];
                    assert_eq!(edge.wings.next[side], Some(next.edge), "{name}");
                    let back = building.edge(next.edge).wings.previous[usize::from(!next.forward)];
                    assert_eq!(back, Some(step.edge), "{name}");
                    let (end, start) = (usize::from(step.forward), usize::from(!next.forward));
                    let corners = [edge.corners[end], building.edge(next.edge).corners[start]];
                    assert_eq!(corners[0], corners[1], "{name}");
                }
            }
        }
        for (k, edge) in building.polygon_edges().iter().enumerate() {
            for side in 0..2 {
                let Some(next) = edge.wings.next[side] else {
                    continue;
                };
                let next = building.polygon_edge(next);
                let own = Some(PolygonEdgeId(k as u32));
                let back = (0..2).find(|&s| next.polygons[s] == edge.polygons[side]);
                assert_eq!(next.wings.previous[back.unwrap()], own, "{name}");
            }
        }
    }
}

#[test]
fn faces_are_covered_by_their_polygons_and_rings() {
    for (name, _, building) in all() {
        for face in building.faces() {
            let area = |ring: &Vec<glam::DVec2>| crate::domain::signed_area(ring);
            let rings: f64 = face.rings.iter().map(area).sum();
            let mut polygons = 0.0;
            for &polygon in &face.polygons {
                let corners = building.polygon(polygon).vertices.iter();
                let corners: Vec<DVec3> = corners.map(|&v| building.vertex(v).position).collect();
                let across = crate::trimesh::polygon::across(&corners);
                polygons += 0.5 * across.length();
                let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
                let place = face.surface.project(middle);
                let normal = face.surface.frame(place.x, place.y).normal;
                assert!(
                    across.normalize().dot(normal) > 0.99,
                    "{name} {:?}",
                    face.labels
                );
                // The middle of a chord lies below the arc by less than 2 mm.
                assert!(place.z.abs() < 2e-3, "{name} {}", place.z);
            }
            assert!(rings > 0.0, "{name}");
            if let FaceSurface::Sweep(_) = face.surface {
                let share = polygons / rings;
                assert!((0.998..1.0 + 1e-9).contains(&share), "{name} {share}");
            }
        }
    }
}

#[test]
fn the_solid_is_closed_and_its_volume_is_positive() {
    for (name, _, building) in all().iter().filter(|all| !all.0.starts_with("sheet")) {
        let mut six = 0.0;
        for polygon in building.polygons() {
            let corner = |k: usize| building.vertex(polygon.vertices[k]).position;
            for k in 2..polygon.vertices.len() {
                six += corner(0).dot(corner(k - 1).cross(corner(k)));
            }
        }
        assert!(six > 0.0, "{name}");
    }
}

/// How often each class of corners, each bend of edges and each set of labels occurs.
fn census(building: &Building) -> BTreeMap<String, usize> {
    let mut all = BTreeMap::new();
    let mut count = |what: String| *all.entry(what).or_insert(0) += 1;
    for corner in building.corners() {
        count(format!("{:?} {:?}", corner.class, corner.labels));
    }
    for edge in building.edges() {
        let length = (edge.length() * 1e6).round();
        count(format!("{:?} {length} {:?}", edge.bend, edge.labels));
    }
    for face in building.faces() {
        count(format!("{:?} {:?}", face.loops.len(), face.labels));
    }
    all
}

#[test]
fn the_order_of_faces_does_not_matter() {
    for (name, draft, building) in all() {
        let wanted = census(building);
        let mut turned = draft.clone();
        turned.faces.reverse();
        for face in &mut turned.faces {
            let n = face.loops.len();
            face.loops[1.min(n - 1)..].reverse();
            face.loops.iter_mut().for_each(|ring| ring.rotate_left(1));
        }
        assert_eq!(census(&built(name, &turned)), wanted, "{name}");
    }
}

/// The draft under a map of space; `mirrors` is true if the map is a reflection.
pub(super) fn mapped(draft: &Draft, map: impl Fn(DVec3) -> DVec3, mirrors: bool) -> Draft {
    let mut mapped = draft.clone();
    mapped.vertices.iter_mut().for_each(|v| *v = map(*v));
    for arc in &mut mapped.arcs {
        arc.centre = map(arc.centre);
        arc.axis = map(arc.axis) * if mirrors { -1.0 } else { 1.0 };
    }
    for face in &mut mapped.faces {
        if mirrors {
            face.loops.iter_mut().for_each(|ring| ring.reverse());
        }
        face.surface = face.surface.as_ref().map(|surface| match surface {
            FaceSurface::Sweep(sweep) => {
                let piece = |piece: &Piece| match *piece {
                    Piece::Line { from, to } => Piece::Line {
                        from: map(from),
                        to: map(to),
                    },
                    Piece::Arc(arc) => Piece::Arc(CircularArc {
                        centre: map(arc.centre),
                        x: map(arc.x),
                        y: map(arc.y),
                        ..arc
                    }),
                };
                let profile = Path::new(sweep.profile().pieces().iter().map(piece).collect());
                let profile = if mirrors { profile.reversed() } else { profile };
                FaceSurface::Sweep(Sweep::new(profile, map(sweep.direction())))
            }
            FaceSurface::Disk(disk) => {
                let rim = disk.rim();
                let range = match mirrors {
                    true => [-rim.to, -rim.from],
                    false => [rim.from, rim.to],
                };
                let (centre, normal) = (map(disk.centre()), map(disk.normal()));
                FaceSurface::Disk(Disk::new(centre, normal, map(rim.x), rim.radius, range))
            }
        });
    }
    mapped
}

#[test]
fn turning_and_mirroring_keep_all_features() {
    for (name, draft, building) in all() {
        let wanted = census(building);
        let quarter = mapped(draft, |p| DVec3::new(p.z, p.y, -p.x), false);
        assert_eq!(census(&built(name, &quarter)), wanted, "{name}");
        let mirror = mapped(draft, |p| DVec3::new(-p.x, p.y, p.z), true);
        assert_eq!(census(&built(name, &mirror)), wanted, "{name}");
    }
}

#[test]
fn projecting_and_mapping_are_inverse() {
    let mut random = Random::new(1, Purpose::Scatter, 0);
    for (name, _, building) in all() {
        for face in building.faces() {
            let [low, high] = face.bounds();
            for _ in 0..8 {
                let s = low.x + random.unit() * (high.x - low.x);
                let t = low.y + random.unit() * (high.y - low.y);
                let z = 0.05 * random.signed();
                let p = face.surface.map(s, t, z).origin;
                let place = face.surface.project(p);
                let back = face.surface.map(place.x, place.y, place.z).origin;
                assert!(back.distance(p) < 1e-6, "{name}");
                let turn = face
                    .surface
                    .period()
                    .map_or(0.0, |p| p * ((place.x - s) / p).round());
                assert!((place.x - s - turn).abs() < 1e-6, "{name}");
                assert!(
                    (place.z - z).abs() < 1e-6 && (place.y - t).abs() < 1e-6,
                    "{name}"
                );
                let frame = face.surface.frame(s, t);
                assert!(frame.s.cross(frame.t).distance(frame.normal) < 1e-9);
            }
        }
    }
}
