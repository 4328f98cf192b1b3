//! Files of stones on a surface, as other programs read them.

use bubblestone::export::{MeshFormat, MeshOrder, ModelFile, PartFile};
use bubblestone::field::CellKind;
use bubblestone::heightfield::TextureParams;
use bubblestone::material::{Gloss, WeatherParams, material_table};
use bubblestone::surface_cells::SurfaceCell;
use bubblestone::surface_stones::{Paving, StonesParams, links};
use bubblestone::trimesh::{SurfacePoint, TangentFrame, TriMesh};
use glam::{DVec2, DVec3};

const SIDE: usize = 6;

fn place(i: usize, j: usize) -> DVec3 {
    let (x, z) = (i as f64 - 3.0, j as f64 - 3.0);
    DVec3::new(x, 10.0 - 0.05 * (x * x + z * z), z)
}

fn normal(p: DVec3) -> DVec3 {
    DVec3::new(0.1 * p.x, 1.0, 0.1 * p.z).normalize()
}

/// A hill of six by six squares.
fn hill() -> (TriMesh, Vec<SurfaceCell>) {
    let at = |i: usize, j: usize| (j * (SIDE + 1) + i) as u32;
    let places = (0..(SIDE + 1) * (SIDE + 1)).map(|k| place(k % (SIDE + 1), k / (SIDE + 1)));
    let (mut triangles, mut cells) = (Vec::new(), Vec::new());
    for k in 0..SIDE * SIDE {
        let (i, j) = (k % SIDE, k / SIDE);
        let corners = [[i, j], [i, j + 1], [i + 1, j + 1], [i + 1, j]];
        let [a, b, c, d] = corners.map(|[i, j]| at(i, j));
        triangles.extend([[a, b, c], [a, c, d]]);
        let ring = corners.map(|[i, j]| place(i, j)).to_vec();
        let middle = ring.iter().sum::<DVec3>() / 4.0;
        let n = normal(middle);
        cells.push(SurfaceCell {
            id: k as u32,
            kind: CellKind::Square,
            centre: SurfacePoint {
                triangle: 0,
                at: middle,
                normal: n,
            },
            axis: TangentFrame::of(n).within(DVec3::X).normalize_or(DVec2::X),
            size: 1.0,
            aspect: 1.0,
            normals: ring.iter().map(|&p| normal(p)).collect(),
            ring,
            on_border: i % (SIDE - 1) == 0 || j % (SIDE - 1) == 0,
        });
    }
    (
        TriMesh::new(places.collect(), triangles).expect("a mesh"),
        cells,
    )
}

fn file(format: MeshFormat) -> (MeshOrder, Vec<u8>) {
    let (mesh, cells) = hill();
    let links = links(&cells);
    let paving = Paving {
        cells: &cells,
        links: &links,
        coats: &[],
        claws: &[],
    };
    let texture = TextureParams {
        size: 24.0,
        ..TextureParams::default()
    };
    let weather = WeatherParams {
        wear: 0.0,
        moss: 0.3,
        dirt: 0.0,
        wet: 0.0,
    };
    let order = MeshOrder {
        format,
        detail: 100,
        images: None,
        joined: false,
    };
    let materials = material_table(texture.palette, texture.ground, Gloss::Own);
    let params = StonesParams::new(texture, weather, &cells);
    let mut file = ModelFile::new(&order, params, &materials, (&cells, DVec3::ZERO));
    let mut parts = Vec::new();
    while !file.advance(&mesh, paving) {
        parts.extend(file.take());
    }
    parts.extend(file.finish());
    (order, parts.concat())
}

#[test]
fn an_obj_has_each_stone_where_its_cell_is() {
    let (order, bytes) = file(MeshFormat::Obj);
    let read = |_: &std::path::Path| Err(tobj::LoadError::OpenFileFailed);
    let (models, _) =
        tobj::load_obj_buf(&mut bytes.as_slice(), &tobj::LoadOptions::default(), read)
            .expect("an OBJ file");
    let (_, cells) = hill();
    let mut stones = 0;
    for model in &models {
        let mesh = &model.mesh;
        assert!(mesh.vertex_color.len() == mesh.positions.len());
        let Some(k) = model.name.strip_prefix("cell_") else {
            assert_eq!(model.name, "ground");
            continue;
        };
        stones += 1;
        let cell = &cells[k.parse::<usize>().expect("a number")];
        assert_charted(cell, mesh);
        assert!(mesh.indices.len() <= 3 * order.detail);
        let corner = |k: &u32| {
            DVec3::from([0, 1, 2].map(|axis| f64::from(mesh.positions[3 * *k as usize + axis])))
        };
        for p in mesh.indices.iter().map(corner) {
            let off = TangentFrame::of(cell.centre.normal).within(p - cell.centre.at);
            assert!(off.abs().max_element() < 0.62, "{off}");
        }
        let six: f64 = mesh
            .indices
            .chunks(3)
            .map(|t| {
                let [a, b, c] = [0, 1, 2].map(|k| corner(&t[k]) - cell.centre.at);
                a.dot(b.cross(c))
            })
            .sum();
        assert!(six > 0.0, "{k} looks inwards");
    }
    assert_eq!(stones, cells.len());
    let size = order.model_size(cells.len(), 288);
    let part = bytes.len() as f64 / size.bytes;
    assert!((0.7..1.3).contains(&part), "{part}");
}

/// Asserts that texture coordinates are lengths in the tangent plane, along the cell, and that no texture is mirrored.
fn assert_charted(cell: &SurfaceCell, mesh: &tobj::Mesh) {
    assert_eq!(mesh.texcoord_indices, mesh.indices);
    let frame = TangentFrame::of(cell.centre.normal);
    let along = frame.x * cell.axis.x + frame.y * cell.axis.y;
    let left = cell.centre.normal.cross(along);
    for (p, uv) in mesh.positions.chunks(3).zip(mesh.texcoords.chunks(2)) {
        let p = DVec3::new(p[0].into(), p[1].into(), p[2].into());
        let wanted = [p.dot(along), 1.0 + p.dot(left)];
        let off = [0, 1].map(|k| f64::from(uv[k]) - wanted[k]);
        assert!(off.iter().all(|v| v.abs() < 1e-5), "{uv:?} {wanted:?}");
    }
}

#[test]
fn a_glb_has_a_node_for_each_stone() {
    let (order, bytes) = file(MeshFormat::Glb);
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!((&bytes[..4], word(8)), (&b"glTF"[..], bytes.len()));
    let json: serde_json::Value = serde_json::from_slice(&bytes[20..20 + word(12)]).expect("JSON");
    let nodes = json["nodes"].as_array().expect("nodes");
    let named = |start: &str| {
        let names = nodes.iter().filter_map(|node| node["name"].as_str());
        names.filter(|name| name.starts_with(start)).count()
    };
    assert_eq!(named("stone_"), SIDE * SIDE);
    assert!(named("ground") > 0);
    let (accessors, meshes) = (
        &json["accessors"],
        json["meshes"].as_array().expect("meshes"),
    );
    let mut triangles = 0;
    for mesh in meshes {
        let primitive = &mesh["primitives"][0];
        let attributes = primitive["attributes"].as_object().expect("attributes");
        assert_eq!(attributes.len(), 4);
        let of = |k: &serde_json::Value| &accessors[k.as_u64().unwrap() as usize];
        let count = of(&attributes["POSITION"])["count"].as_u64();
        for (name, kind) in [
            ("POSITION", "VEC3"),
            ("NORMAL", "VEC3"),
            ("COLOR_0", "VEC4"),
            ("TEXCOORD_0", "VEC2"),
        ] {
            let accessor = of(&attributes[name]);
            assert_eq!(
                (accessor["count"].as_u64(), accessor["type"].as_str()),
                (count, Some(kind))
            );
            let end = accessor["byteOffset"].as_u64().unwrap() + 40 * (count.unwrap() - 1);
            assert!(end < json["bufferViews"][0]["byteLength"].as_u64().unwrap());
        }
        let indices = of(&primitive["indices"]);
        assert_eq!(indices["type"].as_str(), Some("SCALAR"));
        triangles += indices["count"].as_u64().unwrap() / 3;
    }
    let size = order.model_size(SIDE * SIDE, 288);
    let part = triangles as f64 / size.triangles as f64;
    assert!((0.7..1.1).contains(&part), "{part}");
    let part = bytes.len() as f64 / size.bytes;
    assert!((0.7..1.3).contains(&part), "{part}");
}
