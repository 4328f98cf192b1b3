//! Files: JSON reads back as it was written, OBJ is recognised, and bad files are refused.

use super::tests::{all, built};
use super::*;
use glam::DVec3;
use std::fmt::Write as _;

/// Reads an OBJ file in metres, with y up.
fn read_obj(file: impl AsRef<[u8]>) -> Result<obj::Recognised, BuildingFault> {
    obj::read(file.as_ref(), &obj::FileSpace::METRES)
}

#[test]
fn json_reads_back_equal() {
    for (name, draft, _) in all() {
        let mut draft = draft.clone();
        draft.edge_labels.push(([0, 1], "Quoin \"x\"".into()));
        draft.corner_labels.push((1, "Finial".into()));
        draft.edge_flips.push([1, 2]);
        draft.corner_flips.push(2);
        assert_eq!(json::read(&write_json(&draft)), Ok(draft), "{name}");
    }
}

#[test]
fn the_example_of_the_documentation_is_a_building() {
    let page = include_str!("../../docs/building.md");
    let text = page
        .split("```json\n")
        .nth(1)
        .and_then(|rest| rest.split("```").next());
    let draft = json::read(text.unwrap()).unwrap();
    let building = built("example", &draft);
    assert!(matches!(
        building.warnings(),
        [BuildingWarning::OpenEdges(_)]
    ));
    let window = |edge: &&Edge| edge.labels == ["Window"];
    assert_eq!(building.edges().iter().filter(window).count(), 1);
    assert_eq!(
        building
            .corners()
            .iter()
            .filter(|corner| corner.flip)
            .count(),
        1
    );
    assert!(building.extras()[0].material == "glass" && building.ground() == Some(0.0));
}

/// A block as JSON, with one part of the text replaced.
fn replaced(from: &str, to: &str) -> BuildingFault {
    let text = write_json(&Rule::Block.draft(&Module::NORMAL, &[]));
    assert!(text.contains(from), "{from}");
    json::read(&text.replacen(from, to, 1)).unwrap_err()
}

#[test]
fn bad_json_is_refused_with_its_place() {
    let BuildingFault::NotJson { line, column, .. } = json::read("{\n \"v\": [1,}\n").unwrap_err()
    else {
        panic!("not refused");
    };
    assert_eq!((line, column), (2, 10));
    let field = |path: &str, allowed| BuildingFault::Field {
        path: path.into(),
        allowed,
    };
    assert_eq!(json::read("[]"), Err(field("", "an object")));
    let found = |found: &str| BuildingFault::Version {
        found: found.into(),
    };
    assert_eq!(json::read("{}"), Err(found("")));
    assert_eq!(replaced("\"version\":1", "\"version\":2"), found("2"));
    let unit = BuildingFault::Unit {
        found: "\"mm\"".into(),
    };
    assert_eq!(replaced("\"unit\":\"m\"", "\"unit\":\"mm\""), unit);
    assert_eq!(
        replaced("\"v\":[[", "\"v\":[[\"a\",1,2],["),
        field("v[0][0]", "a number")
    );
    assert_eq!(
        replaced("\"v\":[[", "\"v\":[[1,2],["),
        field("v[0]", "three numbers")
    );
    assert_eq!(replaced("\"v\":", "\"w\":"), field("v", "a value"));
    let vertex = field("faces[0].loops[0][0]", "the number of a vertex");
    assert_eq!(replaced("\"loops\":[[0", "\"loops\":[[-1"), vertex);
    assert_eq!(replaced("\"loops\":[[0", "\"loops\":[[0.5"), vertex);
    let param = field("faces[0].param", "a sweep or a disk");
    assert_eq!(replaced("\"sweep\"", "\"sphere\""), param);
    assert!(matches!(
        replaced("[\"line\"", "[\"spline\""),
        BuildingFault::Field { .. }
    ));
    // The parser refuses numbers beyond the range of f64 as no JSON.
    assert!(matches!(
        replaced("\"v\":[[", "\"v\":[[1e999,0,0],["),
        BuildingFault::NotJson { .. }
    ));
    let label = field("faces[0].label", "a text or a list of texts");
    assert_eq!(replaced("\"label\":[]", "\"label\":3"), label);
}

#[test]
fn a_face_without_a_parameterisation_is_read_and_refused() {
    let text = write_json(&Rule::Block.draft(&Module::NORMAL, &[]));
    let draft = json::read(&text.replacen("\"param\"", "\"other\"", 1)).unwrap();
    let face = FaceId(0);
    assert_eq!(
        Building::new(&draft),
        Err(BuildingFault::NoSurface { face })
    );
}

/// The numbers of a tower without windows.
const PLAIN_TOWER: [f64; 4] = [80.0, 48.0, 3.0, 0.0];

/// The child mesh of a building as an OBJ file, each face in a group of its own label.
fn obj_of(building: &Building) -> String {
    let mut text = String::new();
    for vertex in building.vertices() {
        let p = vertex.position;
        writeln!(text, "v {} {} {}", p.x, p.y, p.z).unwrap();
    }
    for face in building.faces() {
        writeln!(text, "g {}", face.labels.join(" ")).unwrap();
        for &polygon in &face.polygons {
            let corners = building.polygon(polygon).vertices.iter();
            let corners: Vec<String> = corners.map(|v| (v.0 + 1).to_string()).collect();
            writeln!(text, "f {}", corners.join(" ")).unwrap();
        }
    }
    text
}

#[test]
fn obj_files_are_recognised() {
    for rule in Rule::ALL {
        // Windows of a tower do not begin where its facets do, so its facets would not be flat.
        let numbers: &[f64] = if rule == Rule::Tower {
            &PLAIN_TOWER
        } else {
            &[]
        };
        let draft = rule.draft(&Module::NORMAL, numbers);
        let building = built(rule.word(), &draft);
        let read = read_obj(obj_of(&building)).unwrap();
        let again = built(rule.word(), &read.draft);
        let count = |building: &Building, is_flat| {
            let is = |face: &&Face| face.surface.is_flat() == is_flat;
            building.faces().iter().filter(is).count()
        };
        // Both jambs and their arch are one face in a draft, and three faces in a file.
        let joined = building.faces().iter().filter(|face| match &face.surface {
            FaceSurface::Sweep(sweep) => sweep.profile().pieces().len() > 1,
            FaceSurface::Disk(_) => false,
        });
        let joined = joined.count();
        assert_eq!(
            read.curved.len(),
            count(&building, false),
            "{}",
            rule.word()
        );
        assert_eq!(
            count(&again, false),
            count(&building, false),
            "{}",
            rule.word()
        );
        assert_eq!(
            count(&again, true),
            count(&building, true) + 2 * joined,
            "{}",
            rule.word()
        );
        assert_eq!(read.polygons, building.polygons().len());
        assert_eq!(read.flat + read.curved.len(), again.faces().len());
        let labels = |building: &Building| -> std::collections::BTreeSet<String> {
            building
                .faces()
                .iter()
                .flat_map(|face| face.labels.clone())
                .collect()
        };
        assert_eq!(labels(&again), labels(&building), "{}", rule.word());
        let volume = |building: &Building| {
            let six = building.polygons().iter().map(|polygon| {
                let [a, b, c] = [0, 1, 2].map(|k| building.vertex(polygon.vertices[k]).position);
                a.dot(b.cross(c))
            });
            six.sum::<f64>() / 6.0
        };
        let share = volume(&again) / volume(&building);
        assert!(
            rule == Rule::Sheet || (share - 1.0).abs() < 1e-4,
            "{} {share}",
            rule.word()
        );
    }
}

#[test]
fn arches_keep_their_radius_and_do_not_swallow_their_jambs() {
    let draft = Rule::Gate.draft(&Module::NORMAL, &[]);
    let building = built("gate", &draft);
    let read = read_obj(obj_of(&building)).unwrap();
    let [curved] = read.curved[..] else {
        panic!("{:?}", read.curved);
    };
    assert!(
        (curved.radius - 0.5 * (12.0 * 0.125 + 0.01)).abs() < 1e-6,
        "{}",
        curved.radius
    );
    assert!(!curved.is_whole);
    let tower = built("tower", &Rule::Tower.draft(&Module::NORMAL, &PLAIN_TOWER));
    let read = read_obj(obj_of(&tower)).unwrap();
    assert!(read.curved.len() == 2 && read.curved.iter().all(|curved| curved.is_whole));
}

/// A round tower of many sides about an axis that is off the origin, as a file whose numbers have few decimals.
fn rounded_tower(sides: usize, decimals: usize) -> String {
    let mut text = String::from("g Wall\n");
    for height in [0.0, 3.0] {
        for k in 0..sides {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * k as f64 / sides as f64);
            let (x, z) = (0.1234 + 2.5 * cos, -1.7 - 2.5 * sin);
            writeln!(text, "v {x:.decimals$} {height} {z:.decimals$}").unwrap();
        }
    }
    for a in 1..=sides {
        let b = a % sides + 1;
        writeln!(
            text,
            "f {a} {b} {}\nf {a} {} {}",
            b + sides,
            b + sides,
            a + sides
        )
        .unwrap();
    }
    let lid: Vec<String> = (1..=sides).map(|k| (k + sides).to_string()).collect();
    writeln!(text, "f {}", lid.join(" ")).unwrap();
    text
}

#[test]
fn rounded_numbers_do_not_divide_a_cylinder() {
    for (sides, decimals) in [(12, 3), (24, 3), (32, 4), (64, 4), (96, 5), (200, 6)] {
        let read = read_obj(rounded_tower(sides, decimals)).unwrap();
        let case = format!("{sides} sides, {decimals} decimals");
        let [curved] = read.curved[..] else {
            panic!("{case}: {:?}", read.curved);
        };
        assert!(curved.is_whole && curved.pieces == sides, "{case}");
        assert!(
            (curved.radius - 2.5).abs() < 1e-3,
            "{case}: {}",
            curved.radius
        );
        let building = built(&case, &read.draft);
        // The rims of the wall are whole circles, each of one piece.
        assert_eq!(building.edges().len(), 2, "{case}");
        for edge in building.edges() {
            assert_eq!(edge.path.pieces().len(), 1, "{case}");
        }
    }
}

#[test]
fn a_rounded_arch_does_not_swallow_its_jambs() {
    let draft = Rule::Gate.draft(&Module::NORMAL, &[]);
    let exact = obj_of(&built("gate", &draft));
    for decimals in [4, 5] {
        let rounded = |word: &str| match word.parse::<f64>() {
            Ok(number) if word.contains('.') => format!("{number:.decimals$}"),
            _ => word.to_owned(),
        };
        let lines = exact.lines().map(|line| {
            let words: Vec<String> = line.split(' ').map(rounded).collect();
            words.join(" ")
        });
        let text = lines.collect::<Vec<_>>().join("\n");
        let read = read_obj(text).unwrap();
        let before = read_obj(&exact).unwrap();
        assert_eq!(read.curved.len(), 1, "{decimals} decimals");
        assert_eq!(read.curved[0].pieces, before.curved[0].pieces);
        assert_eq!(read.flat, before.flat);
    }
}

#[test]
fn sides_are_divided_at_vertices_of_other_polygons() {
    // A box whose front has two polygons, one above the other, and whose other sides have one.
    let file = "v 0 0 0\nv 4 0 0\nv 4 0 3\nv 0 0 3\nv 0 2 0\nv 4 2 0\nv 4 2 3\nv 0 2 3\nv 4 1 3.0001\nv 0 1 3\n\
        f 4 3 9 10\nf 10 9 7 8\nf 3 2 6 7\nf 2 1 5 6\nf 1 4 8 5\nf 8 7 6 5\nf 1 2 3 4\n";
    let read = read_obj(file).unwrap();
    let building = built("box", &read.draft);
    assert_eq!(building.warnings(), []);
    assert_eq!((building.faces().len(), building.edges().len()), (6, 12));
    // A picture on a wall shares a part of its foot, in the same direction: nothing is divided.
    let file = "v 0 0 0\nv 3 0 0\nv 3 2 0\nv 0 2 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nf 1 2 3 4\nf 5 6 7 8\n";
    let read = read_obj(file).unwrap();
    assert!(read.draft.faces.iter().all(|face| face.loops[0].len() == 4));
}

#[test]
fn groups_part_faces_and_name_them() {
    let text = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 0 1 0\n\
        o Wall.001\nf 1 2 5 6\nf 1 1 2\ng Window Sill\nf 2 3 4 5\n";
    let read = read_obj(text).unwrap();
    let labels: Vec<String> = read
        .draft
        .faces
        .iter()
        .map(|face| face.labels.join("+"))
        .collect();
    assert_eq!(labels, ["Wall", "Window+Sill"]);
    assert_eq!((read.polygons, read.degenerate, read.flat), (3, 1, 2));
    let joined = read_obj(text.replace("g Window Sill\n", "")).unwrap();
    assert_eq!(joined.draft.faces.len(), 1);
    assert_eq!(joined.draft.faces[0].loops[0].len(), 6);
}

#[test]
fn a_building_on_a_map_is_moved_to_the_origin() {
    let file =
        "g Wall\nv -3 0 -2.001\nv 3.1 0 -2.001\nv 3.1 4.2 -2.001\nv -3 4.2 -2.001\nf 4 3 2 1\n";
    let near = read_obj(file).unwrap();
    assert_eq!(near.moved, None);
    for [x, y, z] in [[512_345.0, 0.0, -5_403_210.0], [0.0, 20_000.0, 0.0]] {
        let mut far = String::new();
        for line in file.lines() {
            let words: Vec<&str> = line.split(' ').collect();
            match words[..] {
                ["v", a, b, c] => {
                    let [a, b, c] = [a, b, c].map(|word| word.parse::<f64>().unwrap());
                    // The digits that a program would write.
                    writeln!(far, "v {:.3} {:.3} {:.3}", a + x, b + y, c + z).unwrap();
                }
                _ => writeln!(far, "{line}").unwrap(),
            }
        }
        let read = read_obj(far).unwrap();
        assert_eq!(read.draft.vertices[0].y, 0.0);
        let by = read.moved.unwrap();
        assert_eq!(by.y, -y);
        // The places are the same but for a move in whole metres, to the last bit.
        let back = by + DVec3::new(x, y, z);
        assert_eq!(back, back.round());
        let expected = near
            .draft
            .vertices
            .iter()
            .map(|&v| ((v + back) * 1e6).round() / 1e6);
        assert_eq!(read.draft.vertices, expected.collect::<Vec<_>>());
        assert!(back.length() < 3.0);
    }
}

#[test]
fn bad_obj_files_are_refused() {
    let line = read_obj(b"v 0 0 0\nv 0 x 0\n").unwrap_err();
    assert!(matches!(line, BuildingFault::NotObj(_)));
    for far in ["1e38", "-20000"] {
        let text = format!("v 0 0 0\nv 1 0 {far}\nv 1 1 0\nf 1 2 3\n");
        let fault = read_obj(text).unwrap_err();
        assert!(
            matches!(fault, BuildingFault::Far { vertex: 2, .. }),
            "{fault:?}"
        );
    }
    let bent = read_obj(b"v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nf 1 2 3 4\n").unwrap();
    let fault = Building::new(&bent.draft).unwrap_err();
    assert!(
        matches!(fault, BuildingFault::OffSurface { .. }),
        "{fault:?}"
    );
    assert_eq!(read_obj(b"v 0 0 0\n"), Err(BuildingFault::Empty));
    let twice = read_obj(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\n").unwrap_err();
    let why = PolygonFault::Twice;
    let (vertices, polygons) = ([0, 1], [0, 1]);
    assert_eq!(
        twice,
        BuildingFault::Polygons {
            vertices,
            polygons,
            why
        }
    );
}
