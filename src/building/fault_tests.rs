//! Each kind of bad input is answered with its fault.

use super::tests::built;
use super::*;
use glam::DVec3;

/// A block of 20 x 14 modules; face 0 is its front, face 4 its top, face 5 its bottom.
fn block() -> Draft {
    Rule::Block.draft(&Module::NORMAL, &[])
}

fn fault(change: impl Fn(&mut Draft)) -> BuildingFault {
    let mut draft = block();
    change(&mut draft);
    Building::new(&draft).unwrap_err()
}

#[test]
fn numbers_have_to_be_some() {
    let place = |path: &str, found: &str| BuildingFault::Number {
        path: path.into(),
        found: found.into(),
    };
    assert_eq!(
        fault(|draft| draft.vertices[3].y = f64::NAN),
        place("v[3]", "NaN")
    );
    assert_eq!(
        fault(|draft| draft.vertices[0].x = 20_000.0),
        place("v[0]", "20000")
    );
    assert_eq!(
        fault(|draft| draft.ground = Some(f64::INFINITY)),
        place("ground", "inf")
    );
    let thick = |draft: &mut Draft| draft.faces[1].thickness = Some(-1.0);
    assert_eq!(fault(thick), place("faces[1].thickness", "-1"));
}

#[test]
fn counts_have_to_be_within_bounds() {
    assert_eq!(fault(|draft| draft.faces.clear()), BuildingFault::Empty);
    let many = fault(|draft| draft.faces = vec![draft.faces[0].clone(); MOST_FACES + 1]);
    assert_eq!(
        many,
        BuildingFault::TooManyFaces {
            faces: MOST_FACES + 1
        }
    );
    let sides = fault(|draft| draft.faces[0].loops = vec![vec![0; 5]; MOST_SIDES]);
    assert_eq!(
        sides,
        BuildingFault::TooManySides {
            sides: 5 * (MOST_SIDES + 4)
        }
    );
    let vertex = fault(|draft| draft.faces[2].loops[0][1] = 99);
    let path = "faces[2].loops[0]".to_owned();
    assert_eq!(vertex, BuildingFault::NoVertex { path, vertex: 99 });
    let short = fault(|draft| draft.faces[0].loops[0].truncate(2));
    let face = FaceId(0);
    assert_eq!(short, BuildingFault::ShortLoop { face, ring: 0 });
}

#[test]
fn surfaces_have_to_be_there_and_right() {
    let face = FaceId(0);
    let none = fault(|draft| draft.faces[0].surface = None);
    assert_eq!(none, BuildingFault::NoSurface { face });
    let bad = |pieces: Vec<Piece>, direction: DVec3| {
        let sweep = Sweep::new(Path::new(pieces), direction);
        fault(|draft| draft.faces[0].surface = Some(FaceSurface::Sweep(sweep.clone())))
    };
    let line = |x: f64, y: f64| Piece::Line {
        from: DVec3::X * x,
        to: DVec3::X * y,
    };
    let turn = Piece::Line {
        from: DVec3::X,
        to: DVec3::X + DVec3::Z,
    };
    for (pieces, direction, why) in [
        (vec![], DVec3::Y, SurfaceFault::NoLength),
        (vec![line(1.0, 1.0)], DVec3::Y, SurfaceFault::NoLength),
        (
            vec![line(0.0, 1.0)],
            DVec3::Y * 2.0,
            SurfaceFault::Direction,
        ),
        (vec![line(0.0, 1.0)], DVec3::X, SurfaceFault::Direction),
        (
            vec![line(0.0, 1.0), line(1.1, 2.0)],
            DVec3::Y,
            SurfaceFault::Gap,
        ),
        (vec![line(0.0, 1.0), turn], DVec3::Y, SurfaceFault::Kink),
    ] {
        assert_eq!(
            bad(pieces, direction),
            BuildingFault::BadSurface { face, why }
        );
    }
}

#[test]
fn loops_have_to_lie_on_their_surface() {
    let BuildingFault::OffSurface { face, by, .. } = fault(|draft| {
        let Some(FaceSurface::Sweep(sweep)) = &draft.faces[4].surface else {
            unreachable!();
        };
        let frame = FaceSurface::Sweep(sweep.clone()).frame(0.0, 0.0);
        let moved = FaceSurface::flat(frame.origin + frame.normal * 0.002, frame.s, frame.t);
        draft.faces[4].surface = Some(moved);
    }) else {
        panic!("no fault");
    };
    assert!(
        face == FaceId(4) && (by - 0.002).abs() < 1e-9,
        "{face:?} {by}"
    );
}

#[test]
fn loops_have_to_be_apart_and_the_right_way_round() {
    let crossed = fault(|draft| {
        draft.faces.truncate(1);
        draft.faces[0].loops[0].swap(0, 1);
    });
    let face = FaceId(0);
    assert!(
        matches!(
            crossed,
            BuildingFault::Crossing {
                face: FaceId(0),
                ..
            }
        ),
        "{crossed:?}"
    );
    let alone = |draft: &mut Draft| {
        draft.faces.truncate(1);
        draft.faces[0].loops[0].reverse();
    };
    assert_eq!(fault(alone), BuildingFault::InsideOut { face });
    let turned = fault(|draft| draft.faces[4].loops[0].reverse());
    assert!(
        matches!(turned, BuildingFault::TurnedOver { .. }),
        "{turned:?}"
    );
}

#[test]
fn edges_of_three_faces_are_refused_with_their_vertices() {
    let fault = fault(|draft| {
        let corners = draft.faces[0].loops[0].clone();
        let out = DVec3::new(0.0, 0.0, 1.0);
        let first = draft.vertices.len() as u32;
        for &v in &corners[..2] {
            let p = draft.vertices[v as usize] + out;
            draft.vertices.push(p);
        }
        let surface = FaceSurface::flat(draft.vertices[corners[0] as usize], DVec3::Z, DVec3::X);
        draft.faces.push(DraftFace {
            labels: Vec::new(),
            surface: Some(surface),
            loops: vec![vec![corners[0], first, first + 1, corners[1]]],
            thickness: None,
        });
    });
    let BuildingFault::NonManifold { vertices, faces } = fault else {
        panic!("{fault:?}");
    };
    let pair = &block().faces[0].loops[0][..2];
    assert!(vertices.iter().all(|v| pair.contains(v)));
    assert_eq!(faces, [FaceId(0), FaceId(5), FaceId(6)]);
}

#[test]
fn arcs_have_to_be_ones() {
    let arc = |change: fn(&mut DraftArc)| {
        let mut draft = Rule::Gate.draft(&Module::NORMAL, &[]);
        change(&mut draft.arcs[0]);
        Building::new(&draft).unwrap_err()
    };
    let bad = |why| BuildingFault::BadArc { arc: 0, why };
    assert_eq!(arc(|arc| arc.axis = DVec3::ZERO), bad(ArcFault::NoAxis));
    assert_eq!(arc(|arc| arc.centre.x += 0.1), bad(ArcFault::Radius));
    assert_eq!(arc(|arc| arc.centre.z += 0.1), bad(ArcFault::Plane));
    let mut draft = Rule::Gate.draft(&Module::NORMAL, &[]);
    draft.arcs.push(draft.arcs[0]);
    let why = ArcFault::Twice;
    let twice = Building::new(&draft).unwrap_err();
    assert_eq!(twice, BuildingFault::BadArc { arc: 2, why });
    // The other way round the same circle is off the intrados.
    let other = arc(|arc| arc.axis = -arc.axis);
    assert!(
        matches!(
            other,
            BuildingFault::OffSurface { .. } | BuildingFault::Crossing { .. }
        ),
        "{other:?}"
    );
}

#[test]
fn open_edges_are_legal_and_listed() {
    let mut draft = block();
    draft.faces.remove(4);
    let building = built("open", &draft);
    let [BuildingWarning::OpenEdges(open)] = building.warnings() else {
        panic!("{:?}", building.warnings());
    };
    assert_eq!(open.len(), 4);
    for &id in open {
        let edge = building.edge(id);
        assert!(edge.bend == Bend::Open && edge.faces[0].is_some() && edge.faces[1].is_none());
        assert!(building.edge_frame(id, 0.0).inward[1].is_none());
    }
    for corner in building.corners() {
        let is_high = building.vertex(corner.vertex).position.y > 0.5;
        assert_eq!(corner.faces.contains(&None), is_high);
        assert_eq!(corner.class.valence, 3);
    }
}

#[test]
fn a_pinched_corner_is_told() {
    let mut draft = block();
    let other = block();
    let size = other
        .vertices
        .iter()
        .fold(DVec3::ZERO, |most, v| most.max(*v));
    let by = DVec3::new(2.0 * size.x, size.y, 2.0 * size.z);
    let first = draft.vertices.len() as u32;
    draft
        .vertices
        .extend(other.vertices.iter().map(|v| *v + by));
    for mut face in other.faces {
        face.loops.iter_mut().flatten().for_each(|v| *v += first);
        let Some(FaceSurface::Sweep(sweep)) = &face.surface else {
            unreachable!();
        };
        let frame = FaceSurface::Sweep(sweep.clone()).frame(0.0, 0.0);
        face.surface = Some(FaceSurface::flat(frame.origin + by, frame.s, frame.t));
        draft.faces.push(face);
    }
    let building = built("pinched", &draft);
    let [BuildingWarning::Pinched(corner)] = building.warnings() else {
        panic!("{:?}", building.warnings());
    };
    assert_eq!(building.corner(*corner).class.valence, 6);
    assert_eq!(building.corners().len(), 15);
}

#[test]
fn names_that_lead_nowhere_are_told() {
    let mut draft = block();
    draft.edge_labels.push(([0, 99], "A".into()));
    draft.corner_labels.push((77, "A".into()));
    draft.edge_flips.push([0, 99]);
    draft.corner_flips.push(77);
    draft.arcs.push(DraftArc {
        from: 0,
        to: 2,
        centre: (draft.vertices[0] + draft.vertices[2]) * 0.5,
        axis: DVec3::Z,
    });
    let no_edge = BuildingWarning::NoSuchEdge { vertices: [0, 99] };
    let no_corner = BuildingWarning::NoSuchCorner { vertex: 77 };
    let wanted = [
        BuildingWarning::UnusedArc { arc: 0 },
        no_edge.clone(),
        no_corner.clone(),
        no_edge,
        no_corner,
    ];
    assert_eq!(built("names", &draft).warnings(), wanted);
}

#[test]
fn own_labels_win() {
    let mut draft = block();
    draft.faces[0].labels = vec!["Front".into(), "Wall".into()];
    draft.faces[4].labels = vec!["Top".into()];
    let [a, b] = [draft.faces[0].loops[0][2], draft.faces[0].loops[0][3]];
    let taken = built("taken", &draft);
    let edge = |building: &Building| {
        let at = |v: u32| draft.vertices[v as usize];
        let middle = 0.5 * (at(a) + at(b));
        let near = |edge: &&Edge| edge.path.point(0.5 * edge.length()).distance(middle) < 1e-9;
        let edge = building.edges().iter().find(near).unwrap();
        (edge.labels.join(" "), edge.has_own_labels, edge.flip)
    };
    assert_eq!(edge(&taken), ("Front Top Wall".into(), false, false));
    draft.edge_labels = vec![([a, b], "Ledge".into()), ([b, a], "Stone".into())];
    draft.edge_flips = vec![[a, b]];
    assert_eq!(
        edge(&built("own", &draft)),
        ("Ledge Stone".into(), true, true)
    );
    draft.edge_labels.clear();
    draft.edge_flips.clear();
    draft.faces[4].labels.push("Glass".into());
    assert_eq!(edge(&built("glass", &draft)).0, "Glass");
}

/// Changes one thing of a draft at random.
fn spoil(draft: &mut Draft, random: &mut crate::random::Random) {
    let mut pick = |n: usize| (random.unit() * n as f64) as usize;
    let (face, vertex) = (pick(draft.faces.len()), pick(draft.vertices.len()));
    let (kind, other) = (pick(10), pick(draft.vertices.len()));
    let ring = pick(draft.faces[face].loops.len());
    let first = draft.faces[0].surface.clone();
    let own = &mut draft.faces[face];
    let at = pick(own.loops[ring].len());
    match kind {
        0 => draft.vertices[vertex].x += 0.3,
        1 => draft.vertices[vertex] = draft.vertices[other],
        2 => own.loops[ring][at] = vertex as u32,
        3 => own.loops[ring].reverse(),
        4 => drop(own.loops[ring].remove(at)),
        5 => drop(draft.faces.remove(face)),
        6 => drop(own.loops.swap_remove(ring)),
        7 => draft.arcs.truncate(at),
        8 => own.surface = first,
        _ => draft.vertices[vertex].y *= -1.0,
    }
}

/// Whether there are faces left to spoil, all with loops that have vertices.
fn has_loops(draft: &Draft) -> bool {
    let is_whole =
        |face: &DraftFace| !face.loops.is_empty() && face.loops.iter().all(|ring| !ring.is_empty());
    !draft.faces.is_empty() && draft.faces.iter().all(is_whole)
}

#[test]
fn spoilt_drafts_are_refused_or_built() {
    let (mut built, mut refused) = (0, 0);
    for (k, rule) in Rule::ALL.into_iter().enumerate() {
        for seed in 0..40 {
            let mut random =
                crate::random::Random::new(seed, crate::random::Purpose::Noise, k as u64);
            let mut draft = rule.draft(&Module::NORMAL, &[]);
            for _ in 0..1 + seed % 3 {
                if has_loops(&draft) {
                    spoil(&mut draft, &mut random);
                }
            }
            match Building::new(&draft) {
                Ok(building) => {
                    built += 1;
                    let joined = building
                        .edges()
                        .iter()
                        .filter(|edge| edge.bend != Bend::Open);
                    assert!(joined.into_iter().all(|edge| edge.faces[1].is_some()));
                }
                Err(_) => refused += 1,
            }
        }
    }
    assert!(built > 20 && refused > 100, "{built} {refused}");
}
