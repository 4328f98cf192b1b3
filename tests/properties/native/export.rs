//! What is taken out of the program for other programs: closed surfaces as OBJ and GLB, read by other
//! readers, and maps.

use super::samples::{painted, small, star};
use crate::common::finished;
use crate::paving::OfPavement;
use bubblestone::export::{MapKind, MeshFormat, maps};
use bubblestone::generators::pavement;
use bubblestone::heightfield::{Planes, Surfaces, TextureParams};
use bubblestone::material::Gloss;
use bubblestone::notice::Code;
use bubblestone::solid::{SkinParams, Solids, StoneKind, StoneParams};
use bubblestone::studio::Studio;
use glam::Vec3;
use proptest::prelude::*;
use std::collections::HashSet;

const LINK: &str = "size=160&outline=annulus&cs=14";
/// Scales that lie over each other.
const SKIN: &str = "size=160&outline=annulus&cs=20&stone=skin&sc=0.7&dir=boundary";

fn file(studio: &mut Studio, format: MeshFormat) -> Vec<u8> {
    let made = studio
        .engine_mut()
        .mesh_file(format, &mut || 0.0, f64::INFINITY);
    made.expect("a finished picture").parts.concat()
}

/// Every side belongs to two triangles, once in each direction.
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

/// Where the axes are right-handed, greater than 0 if triangles go counter-clockwise seen from outside.
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
        let surface = Surfaces::new(params).close(&solid, &cell, 0, &planes);
        let count = surface.positions.len();
        prop_assert_eq!((surface.normals.len(), surface.colours.len()), (count, count));
        prop_assert!(surface.positions.iter().all(|p| p.is_finite()));
        prop_assert!(surface.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-5));
        assert_closed(&surface.triangles, "a stone");
        let full = volume(&surface.positions, &surface.triangles);
        prop_assert!(full > 0.0, "{}", full);
        // The base is flat.
        let level = surface.positions[count - 1].z;
        let base = surface.triangles.iter().filter(|t| t.contains(&(count as u32 - 1)));
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
    let (mut solids, mut surfaces) = (Solids::new(), Surfaces::new(params));
    let (mut off, mut count) = (0.0, 0);
    for (index, cell) in cells.iter().enumerate() {
        let solid = solids.solid(cell, &params.stone);
        let surface = surfaces.close(&solid, cell, index, &planes);
        // All but the middle of the base.
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
    assert_eq!(models.len(), studio.pavement().cells().len());
    let planes = studio.pavement().planes().unwrap();
    let side = planes.side as f32;
    let mut seen = 0;
    for (k, model) in models.iter().enumerate() {
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
        let cell = &studio.pavement().cells()[k];
        let mean = places.iter().sum::<Vec3>() / places.len() as f32 + 0.5;
        let (x, z) = (cell.centre.x as f32 / side, cell.centre.y as f32 / side);
        assert!((mean.x - x).abs() < 0.1 && (mean.z - z).abs() < 0.1, "{k}");
    }
    let all: usize = models.iter().map(|m| m.mesh.positions.len() / 3).sum();
    assert!(seen as usize > all / 3, "{seen} of {all}");
}

#[test]
fn a_glb_file_has_the_triangles_of_the_obj_file() {
    let mut studio = finished(LINK);
    let glb = file(&mut studio, MeshFormat::Glb);
    let word = |at: usize| u32::from_le_bytes(glb[at..at + 4].try_into().unwrap());
    let float = |at: usize| f32::from_bits(word(at));
    assert_eq!((&glb[..4], word(4)), (&b"glTF"[..], 2));
    assert_eq!(word(8) as usize, glb.len());
    let json_end = 20 + word(12) as usize;
    let json: serde_json::Value = serde_json::from_slice(&glb[20..json_end]).unwrap();
    assert_eq!(json_end + 8 + word(json_end) as usize, glb.len());
    let start = json_end + 8;
    let number = |pointer: &str| json.pointer(pointer).and_then(|v| v.as_u64()).unwrap() as usize;
    let count = number("/accessors/0/count");
    let places: Vec<Vec3> = (0..count)
        .map(|k| start + 32 * k)
        .map(|at| Vec3::new(float(at), float(at + 4), float(at + 8)))
        .collect();
    let first = start + number("/bufferViews/1/byteOffset");
    let indices: Vec<u32> = (0..number("/accessors/3/count"))
        .map(|k| word(first + 4 * k))
        .collect();
    let triangles = threes(&indices);
    assert_closed(&triangles, "all cells");
    assert!(volume(&places, &triangles) > 0.0);

    let obj = String::from_utf8(file(&mut studio, MeshFormat::Obj)).unwrap();
    let lines = |word: &str| obj.lines().filter(|line| line.starts_with(word)).count();
    assert_eq!(
        (lines("v "), lines("vn "), lines("f ")),
        (count, count, triangles.len())
    );
    for (line, place) in obj
        .lines()
        .filter(|line| line.starts_with("v "))
        .zip(&places)
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
fn slices_do_not_matter_and_changes_begin_anew() {
    let mut studio = finished(LINK);
    for (format, word) in MeshFormat::ALL {
        let whole = file(&mut studio, format);
        let slice = |studio: &mut Studio| studio.engine_mut().mesh_file(format, &mut || 0.0, 0.0);
        let (mut cut, mut slices, mut done) = (Vec::new(), 0, false);
        while !done {
            let next = slice(&mut studio).unwrap();
            assert_eq!(next.begun, slices == 0, "{word}");
            cut.extend(next.parts.concat());
            (slices, done) = (slices + 1, next.done);
        }
        assert!(slices > 3 && cut == whole, "{word}");

        let before = studio.recipe().clone();
        // Colours are of the planes, and how rough a GLB file is depends on the light's materials.
        for change in ["palette=basalt", "gloss=wet"] {
            assert!(slice(&mut studio).is_ok_and(|next| next.begun && !next.done));
            let (recipe, _) = pavement::recipe(&format!("{LINK}&{change}"));
            studio.set_recipe(recipe);
            studio.finish(&mut || 0.0).unwrap();
            assert!(slice(&mut studio).is_ok_and(|next| next.begun), "{change}");
            let other = file(&mut studio, format);
            let is_as_rough = format == MeshFormat::Obj && change == "gloss=wet";
            assert_eq!(other == whole, is_as_rough, "{word}: {change}");
            studio.set_recipe(before.clone());
            let why = slice(&mut studio).unwrap_err();
            assert!(why.code == Code::NotYet && studio.engine().map(MapKind::Id) == Err(why));
            studio.finish(&mut || 0.0).unwrap();
            assert_eq!(file(&mut studio, format), whole, "{word}");
        }
    }
}

/// Planes that begin at another place of the tile.
fn shifted(planes: &Planes, [dx, dy]: [usize; 2]) -> Planes {
    fn moved<T: Clone>(list: &[T], side: usize, [dx, dy]: [usize; 2]) -> Vec<T> {
        let at = |k: usize| (k / side + dy) % side * side + (k % side + dx) % side;
        (0..list.len()).map(|k| list[at(k)].clone()).collect()
    }
    let by = [dx, dy];
    Planes {
        bump: moved(&planes.bump, planes.side, by),
        colour: moved(&planes.colour, planes.side, by),
        material: moved(&planes.material, planes.side, by),
        id: moved(&planes.id, planes.side, by),
        occlusion: moved(&planes.occlusion, planes.side, by),
        ..*planes
    }
}

#[test]
fn maps_of_a_tile_repeat_to_the_pixel() {
    let studio = finished("size=192&tile=1&cs=17&kind=square");
    let planes = studio.pavement().planes().unwrap();
    let materials = bubblestone::material::material_table("granite", "sand", Gloss::default());
    for (kind, word) in MapKind::ALL {
        let map = studio.engine().map(kind).unwrap();
        let pixel = usize::from(map.channels) * usize::from(map.bits) / 8;
        assert_eq!(map.bytes.len(), map.side * map.side * pixel, "{word}");
        let values: HashSet<&[u8]> = map.bytes.chunks_exact(pixel).collect();
        assert!(values.len() > 2, "{word} is flat");
        let [dx, dy] = [77, 130];
        let other = maps::map(kind, &shifted(planes, [dx, dy]), &materials, 1.0);
        for (k, there) in other.bytes.chunks_exact(pixel).enumerate() {
            let (x, y) = ((k % 192 + dx) % 192, (k / 192 + dy) % 192);
            let here = &map.bytes[(y * 192 + x) * pixel..][..pixel];
            assert_eq!(here, there, "{word} at {x}, {y}");
        }
    }
}

#[test]
fn surfaces_of_a_tile_fit_their_images() {
    // Cells that reach over an edge are whole, so that copies a side apart fill the gaps.
    let mut studio = finished("size=192&tile=1&cs=17&kind=square");
    let text = String::from_utf8(file(&mut studio, MeshFormat::Obj)).unwrap();
    let places = text.lines().filter_map(|line| line.strip_prefix("v "));
    let x = places.map(|line| line.split(' ').next().unwrap().parse::<f32>().unwrap());
    let (low, high) = x.fold((f32::MAX, f32::MIN), |(l, h), x| (l.min(x), h.max(x)));
    assert!(low < -0.5 || high > 0.5);
    assert!(high - low > 0.98 && high - low < 1.2, "{low} to {high}");
}
