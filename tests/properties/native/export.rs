//! Meshes for other programs: closed surfaces as OBJ and GLB, read by independent readers.

use super::samples::{painted, small, star};
use crate::common::finished;
use crate::paving::OfPavement;
use bubblestone::export::{MapKind, MeshFormat, MeshOrder};
use bubblestone::generators::pavement;
use bubblestone::heightfield::{Surfaces, TextureParams};
use bubblestone::notice::Code;
use bubblestone::solid::{SkinParams, Solids, StoneKind, StoneParams};
use bubblestone::studio::Studio;
use glam::Vec3;
use proptest::prelude::*;
use std::collections::HashSet;

pub(super) const LINK: &str = "size=160&outline=annulus&cs=14";
/// Scales that overlap.
const SKIN: &str = "size=160&outline=annulus&cs=20&stone=skin&sc=0.7&dir=boundary";

fn file(studio: &mut Studio, format: MeshFormat) -> Vec<u8> {
    file_of(studio, &order(format, 400))
}

pub(super) fn order(format: MeshFormat, detail: usize) -> MeshOrder {
    MeshOrder {
        format,
        detail,
        images: None,
        joined: false,
    }
}

pub(super) fn file_of(studio: &mut Studio, order: &MeshOrder) -> Vec<u8> {
    let made = studio
        .meshes()
        .unwrap()
        .mesh_file(order, &mut || 0.0, f64::INFINITY);
    made.expect("a finished picture").parts.concat()
}

/// Asserts that every edge belongs to two triangles, once in each direction.
fn assert_closed(triangles: &[[u32; 3]], what: &str) {
    let mut sides = HashSet::new();
    for &[a, b, c] in triangles {
        for side in [[a, b], [b, c], [c, a]] {
            assert!(side[0] != side[1] && sides.insert(side), "{what}: {side:?}");
        }
    }
    for &[a, b] in &sides {
        assert!(sides.contains(&[b, a]), "{what}: {a} {b} is open");
    }
}

/// The enclosed volume. With right-handed axes it is positive if triangles are counter-clockwise seen from
/// outside.
fn volume(places: &[Vec3], triangles: &[[u32; 3]]) -> f64 {
    let six = triangles.iter().map(|t| {
        let [a, b, c] = t.map(|k| places[k as usize].as_dvec3());
        a.dot(b.cross(c))
    });
    six.sum::<f64>() / 6.0
}

fn threes<T: Copy>(list: &[T]) -> Vec<[T; 3]> {
    list.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn surfaces_are_closed(
        corners in 3usize..12,
        rough in 0.0..0.7f64,
        id in 0u32..1000,
        kind in prop::sample::select(vec![StoneKind::Cobble, StoneKind::Flagstone, StoneKind::Skin]),
        scale in 0.5..1.3f64,
        distortion in 0.0..1.0f64,
        amplitude in 0.0..30.0f64,
        lean in (0.0..1.5f64, 0.0..1.0f64, 0.0..1.0f64),
    ) {
        let cell = star(corners, 22.0, rough, id);
        let (skew, taper, keel) = lean;
        let skin = SkinParams { skew, taper, keel, ..SkinParams::default() };
        let stone = StoneParams { kind, scale, distortion, skin, ..StoneParams::default() };
        let params = TextureParams { stone, amplitude, ..small() };
        let solid = Solids::new().solid(&cell, &stone);
        prop_assume!(!solid.vertices.is_empty());
        let planes = painted(params, std::slice::from_ref(&cell));
        let whole = Surfaces::new(params, usize::MAX).close(&solid, &cell, 0, &planes);
        for most in [100, 400] {
            let surface = Surfaces::new(params, most).close(&solid, &cell, 0, &planes);
            assert_closed(&surface.triangles, "a simple stone");
            prop_assert!(surface.triangles.len() <= most.max(whole.triangles.len() / 3));
            prop_assert!(surface.positions.iter().all(|p| whole.positions.contains(p)));
            let parts = [&surface, &whole].map(|s| volume(&s.positions, &s.triangles));
            prop_assert!(parts[0] > 0.6 * parts[1], "{parts:?}");
        }
        let surface = whole;
        let count = surface.positions.len();
        prop_assert_eq!((surface.normals.len(), surface.colours.len()), (count, count));
        prop_assert!(surface.positions.iter().all(|p| p.is_finite()));
        prop_assert!(surface.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-5));
        assert_closed(&surface.triangles, "a stone");
        let full = volume(&surface.positions, &surface.triangles);
        prop_assert!(full > 0.0, "{}", full);
        // The base is flat.
        let level = surface.positions.iter().fold(f32::MAX, |low, p| low.min(p.z));
        let base = surface.triangles.last().map_or(0, |t| t[2]);
        let base = surface.triangles.iter().filter(|t| t.contains(&base));
        for &k in base.flatten() {
            prop_assert_eq!(surface.positions[k as usize].z, level);
        }
    }
}

#[test]
fn a_surface_stands_as_its_planes_show_it() {
    let params = TextureParams {
        amplitude: 4.0,
        ..small()
    };
    let cells = super::samples::pavement(16.0);
    let planes = painted(params, &cells);
    let (mut solids, surfaces) = (Solids::new(), Surfaces::new(params, usize::MAX));
    let (mut off, mut count) = (0.0, 0);
    for (index, cell) in cells.iter().enumerate() {
        let solid = solids.solid(cell, &params.stone);
        let surface = surfaces.close(&solid, cell, index, &planes);
        // All vertices but the middle of the base.
        let vertices = surface.positions.iter().zip(&surface.colours);
        for (p, &colour) in vertices.take(solid.vertices.len()) {
            let at = p.y as usize * planes.side + p.x as usize;
            if planes.id[at] == index as u32 + 1 {
                assert_eq!(colour, planes.colour[at]);
            }
            // Away from the walls.
            if (glam::DVec2::new(p.x.into(), p.y.into()) - cell.centre).length() < 4.0 && p.z > 4.0
            {
                off += f64::from((p.z - planes.bump[at]).abs());
                count += 1;
            }
        }
    }
    let mean = off / f64::from(count);
    assert!(count > 300 && mean < 0.3, "{mean} off on average");
}

#[test]
fn a_reader_of_obj_finds_closed_cells_as_in_the_picture() {
    for link in [LINK, SKIN] {
        read_as_obj(finished(link));
    }
}

fn read_as_obj(mut studio: Studio) {
    let text = file(&mut studio, MeshFormat::Obj);
    let (models, _) = tobj::load_obj_buf(&mut &text[..], &tobj::LoadOptions::default(), |_| {
        Err(tobj::LoadError::GenericFailure)
    })
    .expect("an OBJ file");
    let cells = studio.pavement().cells.len();
    assert_eq!(models.len(), cells + 1);
    assert_eq!(models[cells].name, "ground");
    let planes = studio.pavement().planes.unwrap();
    let side = planes.side as f32;
    let mut seen = 0;
    for (k, model) in models[..cells].iter().enumerate() {
        assert_eq!(model.name, format!("cell_{k}"));
        let triangles = threes(&model.mesh.indices);
        assert_closed(&triangles, &model.name);
        assert_eq!(model.mesh.normal_indices, model.mesh.indices);
        let places: Vec<Vec3> = threes(&model.mesh.positions)
            .into_iter()
            .map(Vec3::from)
            .collect();
        assert!(volume(&places, &triangles) > 0.0, "{k}");
        for n in threes(&model.mesh.normals) {
            assert!((Vec3::from(n).length() - 1.0).abs() < 1e-3);
        }
        let colours = threes(&model.mesh.vertex_color);
        assert_eq!(colours.len(), places.len());
        for (p, colour) in places.iter().zip(colours) {
            let (x, y) = ((p.x + 0.5) * side, (p.z + 0.5) * side);
            let at = y as usize * planes.side + x as usize;
            let same = |c: usize| (colour[c] * 255.0 - f32::from(planes.colour[at][c])).abs() < 0.6;
            seen += i32::from(planes.id[at] == k as u32 + 1 && (0..3).all(same));
        }
        let cell = &studio.pavement().cells[k];
        let mean = places.iter().sum::<Vec3>() / places.len() as f32 + 0.5;
        let (x, z) = (cell.centre.x as f32 / side, cell.centre.y as f32 / side);
        assert!((mean.x - x).abs() < 0.1 && (mean.z - z).abs() < 0.1, "{k}");
    }
    for mesh in models.iter().map(|model| &model.mesh) {
        assert_eq!(mesh.texcoord_indices, mesh.indices);
        for (p, uv) in threes(&mesh.positions).iter().zip(mesh.texcoords.chunks(2)) {
            let wanted = [p[0] + 0.5, 0.5 - p[2]];
            assert!((uv[0] - wanted[0]).abs() < 1e-5 && (uv[1] - wanted[1]).abs() < 1e-5);
        }
    }
    let stones = models[..cells].iter();
    let all: usize = stones.map(|m| m.mesh.positions.len() / 3).sum();
    assert!(seen as usize > all / 3, "{seen} of {all}");
}

/// A mesh of a GLB file: its node's name, positions, texture coordinates and triangles.
pub(super) struct Node {
    name: String,
    places: Vec<Vec3>,
    in_maps: Vec<[f32; 2]>,
    pub(super) triangles: Vec<[u32; 3]>,
}

pub(super) fn nodes(glb: &[u8]) -> Vec<Node> {
    let word = |at: usize| u32::from_le_bytes(glb[at..at + 4].try_into().unwrap());
    let float = |at: usize| f32::from_bits(word(at));
    assert_eq!((&glb[..4], word(4)), (&b"glTF"[..], 2));
    assert_eq!(word(8) as usize, glb.len());
    let start = 28 + word(12) as usize;
    let json: serde_json::Value = serde_json::from_slice(&glb[20..start - 8]).unwrap();
    assert_eq!(start + word(start - 8) as usize, glb.len());
    let number = |value: &serde_json::Value| value.as_u64().unwrap_or(0) as usize;
    // The beginning of an accessor, the bytes of an element, and the number of elements.
    let accessor = |which: &serde_json::Value| {
        let accessor = &json["accessors"][number(which)];
        let view = &json["bufferViews"][number(&accessor["bufferView"])];
        let begin = start + number(&view["byteOffset"]) + number(&accessor["byteOffset"]);
        (
            begin,
            number(&view["byteStride"]),
            number(&accessor["count"]),
        )
    };
    let root = &json["nodes"][0]["children"];
    let nodes = root.as_array().unwrap().iter().map(|node| {
        let node = &json["nodes"][number(node)];
        let mesh = &json["meshes"][number(&node["mesh"])]["primitives"][0];
        let (at, stride, count) = accessor(&mesh["attributes"]["POSITION"]);
        let starts = (0..count).map(|k| at + stride * k);
        let (uv, ..) = accessor(&mesh["attributes"]["TEXCOORD_0"]);
        let small = json["accessors"][number(&mesh["indices"])]["componentType"] == 5123;
        let (first, _, corners) = accessor(&mesh["indices"]);
        let index = |k: usize| match small {
            true => u32::from(u16::from_le_bytes([
                glb[first + 2 * k],
                glb[first + 2 * k + 1],
            ])),
            false => word(first + 4 * k),
        };
        Node {
            name: node["name"].as_str().unwrap().to_owned(),
            places: starts
                .clone()
                .map(|at| Vec3::new(float(at), float(at + 4), float(at + 8)))
                .collect(),
            in_maps: starts
                .map(|k| k - at + uv)
                .map(|at| [float(at), float(at + 4)])
                .collect(),
            triangles: threes(&(0..corners).map(index).collect::<Vec<_>>()),
        }
    });
    nodes.collect()
}

/// The bodies of a joined file are those of the other one, and their colours are those of the picture, in linear light.
#[test]
fn joined_bodies_have_one_mesh_and_the_pictures_colours() {
    let mut studio = finished(LINK);
    let each = nodes(&file(&mut studio, MeshFormat::Glb));
    let joined = MeshOrder {
        joined: true,
        ..order(MeshFormat::Glb, 400)
    };
    let glb = file_of(&mut studio, &joined);
    let [all] = &nodes(&glb)[..] else {
        panic!("more than one mesh");
    };
    let places: Vec<Vec3> = each.iter().flat_map(|node| node.places.clone()).collect();
    assert_eq!(all.places, places);
    let mut first = 0;
    let mut triangles = Vec::new();
    for node in &each {
        triangles.extend(node.triangles.iter().map(|t| t.map(|k| k + first)));
        first += node.places.len() as u32;
    }
    assert_eq!(all.triangles, triangles);
    let planes = studio.pavement().planes.expect("planes");
    let linear = |c: u8| {
        let c = f64::from(c) / 255.0;
        let bright = libm::pow((c + 0.055) / 1.055, 2.4);
        if c <= 0.04045 { c / 12.92 } else { bright }
    };
    let start = 28 + u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
    let mut seen = 0;
    for (k, p) in all.places[..each[0].places.len()].iter().enumerate() {
        let at = [p.x, p.z].map(|v| ((v + 0.5) * planes.side as f32) as usize);
        let at = at[1] * planes.side + at[0];
        let colour = [24, 26, 28].map(|byte| start + 40 * k + byte);
        let colour = colour.map(|at| u16::from_le_bytes([glb[at], glb[at + 1]]));
        let off = |c: usize| f64::from(colour[c]) / 65535.0 - linear(planes.colour[at][c]);
        seen += usize::from(planes.id[at] == 1 && (0..3).all(|c| off(c).abs() < 1e-4));
    }
    assert!(3 * seen > each[0].places.len(), "{seen}");
}

#[test]
fn a_glb_file_has_the_triangles_of_the_obj_file() {
    let mut studio = finished(LINK);
    let nodes = nodes(&file(&mut studio, MeshFormat::Glb));
    let (ground, stones) = nodes.split_last().unwrap();
    assert_eq!(ground.name, "ground");
    for (k, node) in stones.iter().enumerate() {
        assert_eq!(node.name, format!("stone_{}", k + 1));
        assert_closed(&node.triangles, &node.name);
        assert!(volume(&node.places, &node.triangles) > 0.0);
    }
    for node in &nodes {
        for (p, [u, v]) in node.places.iter().zip(&node.in_maps) {
            assert!((0.0..=1.0).contains(u) && (0.0..=1.0).contains(v));
            assert!((p.x + 0.5 - u).abs() < 1e-5 && (p.z + 0.5 - v).abs() < 1e-5);
        }
    }
    let obj = String::from_utf8(file(&mut studio, MeshFormat::Obj)).unwrap();
    let lines = |word: &str| obj.lines().filter(|line| line.starts_with(word)).count();
    let count: usize = nodes.iter().map(|node| node.places.len()).sum();
    let triangles: usize = nodes.iter().map(|node| node.triangles.len()).sum();
    assert_eq!(
        (lines("v "), lines("vt "), lines("vn ")),
        (count, count, count)
    );
    assert_eq!(lines("f "), triangles);
    let places = nodes.iter().flat_map(|node| &node.places);
    for (line, place) in obj
        .lines()
        .filter(|line| line.starts_with("v "))
        .zip(places)
    {
        let read: Vec<f32> = line
            .split(' ')
            .skip(1)
            .map(|n| n.parse().unwrap())
            .collect();
        assert!((Vec3::new(read[0], read[1], read[2]) - *place).length() < 2e-7);
    }
}

#[test]
fn the_ground_lies_below_the_stones_and_looks_up() {
    let mut studio = finished(LINK);
    let nodes = nodes(&file(&mut studio, MeshFormat::Glb));
    let (ground, stones) = nodes.split_last().unwrap();
    let top = |node: &Node| node.places.iter().fold(f32::MIN, |top, p| top.max(p.y));
    let highest = top(ground);
    let buried = stones.iter().filter(|stone| top(stone) < highest).count();
    assert!(buried * 20 < stones.len(), "{buried} of {}", stones.len());
    let [low, high] = [f32::min, f32::max].map(|f| ground.places.iter().map(|p| p.x).reduce(f));
    assert_eq!((low, high), (Some(-0.5), Some(0.5)));
    for t in &ground.triangles {
        let [a, b, c] = t.map(|k| ground.places[k as usize]);
        assert!((b - a).cross(c - a).y > 0.0);
    }
}

#[test]
fn slices_do_not_matter_and_changes_begin_anew() {
    let mut studio = finished(LINK);
    for (format, word) in MeshFormat::ALL {
        let order = order(format, 100);
        let whole = file_of(&mut studio, &order);
        let slice =
            |studio: &mut Studio| studio.meshes().unwrap().mesh_file(&order, &mut || 0.0, 0.0);
        let (mut cut, mut slices, mut done) = (Vec::new(), 0, false);
        while !done {
            let next = slice(&mut studio).unwrap();
            assert_eq!(next.begun, slices == 0, "{word}");
            cut.extend(next.parts.concat());
            (slices, done) = (slices + 1, next.done);
        }
        assert!(slices > 3 && cut == whole, "{word}");

        let before = studio.recipe().clone();
        // Colours come from the planes. The roughness in a GLB file depends on the materials.
        for change in ["palette=basalt", "gloss=wet"] {
            assert!(slice(&mut studio).is_ok_and(|next| next.begun && !next.done));
            let (recipe, _) = pavement::recipe(&format!("{LINK}&{change}"));
            studio.set_recipe(recipe);
            studio.finish(&mut || 0.0).unwrap();
            assert!(slice(&mut studio).is_ok_and(|next| next.begun), "{change}");
            let other = file_of(&mut studio, &order);
            let is_as_rough = format == MeshFormat::Obj && change == "gloss=wet";
            assert_eq!(other == whole, is_as_rough, "{word}: {change}");
            studio.set_recipe(before.clone());
            let why = slice(&mut studio).unwrap_err();
            assert!(
                why.code == Code::NotYet && studio.maps().unwrap().map(MapKind::Id) == Err(why)
            );
            studio.finish(&mut || 0.0).unwrap();
            assert_eq!(file_of(&mut studio, &order), whole, "{word}");
        }
    }
}

#[test]
fn surfaces_of_a_tile_fit_their_images() {
    // Cells that reach over an edge are complete, so that copies at a distance of one side fill the gaps.
    let mut studio = finished("size=192&tile=1&cs=17&kind=square");
    let text = String::from_utf8(file(&mut studio, MeshFormat::Obj)).unwrap();
    let places = text.lines().filter_map(|line| line.strip_prefix("v "));
    let x = places.map(|line| line.split(' ').next().unwrap().parse::<f32>().unwrap());
    let (low, high) = x.fold((f32::MAX, f32::MIN), |(l, h), x| (l.min(x), h.max(x)));
    assert!(low < -0.5 || high > 0.5);
    assert!(high - low > 0.98 && high - low < 1.2, "{low} to {high}");
}
