//! JSON by plain string building: the shapes are few and flat.

use crate::cells::Cell;
use crate::mesh::{Face, Mesh};
#[cfg(house)]
use crate::surface_cells::SurfaceCell;
use glam::DVec2;
#[cfg(house)]
use glam::DVec3;
use std::fmt::Write;

/// `{"cells":[[[x,y],...],...]}`, one ring per cell in the order given, picture units, y down.
pub fn cells_json(cells: &[Cell]) -> String {
    let rings = cells.iter().map(|c| list(c.ring.iter().map(|&p| point(p))));
    format!("{{\"cells\":{}}}\n", list(rings))
}

/// `{"vertices":[[x,y],...],"faces":[[i,j,k,l?],...]}`, faces of three or four vertices.
pub fn mesh_json(mesh: &Mesh) -> String {
    let vertices = mesh.vertices.iter().map(|&p| point(p));
    faces_json(vertices, mesh.faces.iter().map(Face::nodes))
}

/// The object of a mesh with these vertices, which are JSON already.
fn faces_json<F: AsRef<[u32]>>(
    vertices: impl Iterator<Item = String>,
    faces: impl Iterator<Item = F>,
) -> String {
    let faces = faces.map(|face| list(face.as_ref().iter().map(u32::to_string)));
    let (vertices, faces) = (list(vertices), list(faces));
    format!("{{\"vertices\":{vertices},\"faces\":{faces}}}\n")
}

/// `{"cells":[{"ring":[[x,y,z],...],"normal":[x,y,z],"size":d},...]}`, cells on a surface in the model's units.
/// `anchor` is the place of their origin in the model.
#[cfg(house)]
pub fn surface_cells_json(cells: &[SurfaceCell], anchor: DVec3) -> String {
    let cell = |cell: &SurfaceCell| {
        let ring = cell.ring.iter().map(|&p| point_in_space(p + anchor));
        object([
            ("ring", list(ring)),
            ("normal", point_in_space(cell.centre.normal)),
            ("size", number(cell.size)),
        ])
    };
    format!("{{\"cells\":{}}}\n", list(cells.iter().map(cell)))
}

/// `{"vertices":[[x,y,z],...],"faces":[[i,j,k,l?],...]}`, faces of three or four vertices.
#[cfg(house)]
pub fn surface_mesh_json<F: AsRef<[u32]>>(
    vertices: &[DVec3],
    faces: impl Iterator<Item = F>,
) -> String {
    faces_json(vertices.iter().map(|&p| point_in_space(p)), faces)
}

#[cfg(house)]
fn point_in_space(p: DVec3) -> String {
    format!("[{},{},{}]", number(p.x), number(p.y), number(p.z))
}

fn point(p: DVec2) -> String {
    format!("[{},{}]", number(p.x), number(p.y))
}

/// A JSON list of items that are JSON already.
pub(super) fn list(items: impl Iterator<Item = String>) -> String {
    let mut out = String::from("[");
    for (k, item) in items.enumerate() {
        if k > 0 {
            out.push(',');
        }
        out.push_str(&item);
    }
    out.push(']');
    out
}

/// A JSON object of values that are JSON already.
pub(super) fn object<K: AsRef<str>>(items: impl IntoIterator<Item = (K, String)>) -> String {
    let items = items.into_iter();
    let items: Vec<String> = items
        .map(|(key, value)| text(key.as_ref()) + ":" + &value)
        .collect();
    "{".to_string() + &items.join(",") + "}"
}

/// A JSON number; null for numbers that are not finite, which JSON cannot express.
pub(super) fn number(x: f64) -> String {
    if x.is_finite() {
        format!("{x}")
    } else {
        "null".to_string()
    }
}

/// A JSON string with its quotes.
pub fn text(s: &str) -> String {
    let mut out = String::from("\"");
    for c in s.chars() {
        match c {
            '"' | '\\' => {
                out.push('\\');
                out.push(c);
            }
            c if (c as u32) < 0x20 => {
                // Writing to a String cannot fail.
                let _ = write!(out, "\\u{:04x}", c as u32);
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::CellKind;

    #[test]
    fn numbers_read_back_as_the_same_bits() {
        for x in [0.1, -1e-300, 1.0 / 3.0, 511.999_999_999, 0.0] {
            assert_eq!(number(x).parse::<f64>().map(f64::to_bits), Ok(x.to_bits()));
        }
        assert_eq!(number(f64::NAN), "null");
    }

    #[test]
    fn strings_are_escaped() {
        assert_eq!(text("a\"b\\c\n"), "\"a\\\"b\\\\c\\u000a\"");
    }

    #[cfg(house)]
    #[test]
    fn cells_on_surfaces_have_rings_normals_and_sizes() {
        let at = crate::trimesh::SurfacePoint {
            triangle: 0,
            at: DVec3::ZERO,
            normal: DVec3::Y,
        };
        let cell = SurfaceCell {
            id: 3,
            kind: CellKind::Square,
            centre: at,
            axis: DVec2::X,
            size: 0.25,
            aspect: 1.0,
            ring: vec![DVec3::ZERO, DVec3::new(0.5, 0.0, -1.0)],
            normals: vec![DVec3::Y; 2],
            on_border: false,
        };
        assert_eq!(
            surface_cells_json(&[cell], DVec3::ZERO),
            "{\"cells\":[{\"ring\":[[0,0,0],[0.5,0,-1]],\"normal\":[0,1,0],\"size\":0.25}]}\n"
        );
        let faces: [&[u32]; 2] = [&[0, 1, 2], &[0, 1, 2, 3]];
        assert_eq!(
            surface_mesh_json(&[DVec3::X], faces.iter()),
            "{\"vertices\":[[1,0,0]],\"faces\":[[0,1,2],[0,1,2,3]]}\n"
        );
    }

    #[test]
    fn cells_are_lists_of_points() {
        let ring = vec![DVec2::ZERO, DVec2::new(1.5, 0.0), DVec2::ONE];
        let cell = Cell {
            id: 3,
            centre: DVec2::ZERO,
            kind: CellKind::Square,
            size: 1.0,
            aspect: 1.0,
            axis: DVec2::X,
            ring,
        };
        let json = cells_json(&[cell]);
        assert_eq!(json, "{\"cells\":[[[0,0],[1.5,0],[1,1]]]}\n");
        assert_eq!(cells_json(&[]), "{\"cells\":[]}\n");
    }
}
