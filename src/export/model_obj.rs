//! A model's triangle mesh as an OBJ file.

use super::fixed::push_whole;
use super::json::number;
use crate::trimesh::TriMesh;
use glam::DVec3;

/// Text: vertices with numbers that read back as the same bits, then the triangles, in their order. `anchor` is the place
/// of the mesh's origin in the model.
pub fn model_obj(mesh: &TriMesh, anchor: DVec3) -> String {
    let mut out = b"# Made by Bubblestone.\n".to_vec();
    for p in mesh.positions() {
        out.push(b'v');
        for x in (*p + anchor).to_array() {
            out.push(b' ');
            out.extend_from_slice(number(x).as_bytes());
        }
        out.push(b'\n');
    }
    for triangle in mesh.triangles() {
        out.push(b'f');
        for &v in triangle {
            out.push(b' ');
            push_whole(&mut out, u64::from(v) + 1);
        }
        out.push(b'\n');
    }
    // Only ASCII has been written.
    String::from_utf8(out).unwrap_or_default()
}
