//! Writes a draft as JSON. Numbers have the fewest digits that read back as the same value.

use super::draft::{Draft, DraftArc, DraftFace, ExtraMesh};
use super::json::VERSION;
use super::piece::Piece;
use super::surface::{Disk, FaceSurface, Sweep};
use glam::DVec3;
use serde_json::{Map, Value, json};

/// The draft as JSON. NaN and infinity become null, so only a valid draft can be read back.
pub fn write_json(draft: &Draft) -> String {
    let mut root = Map::new();
    let mut put = |name: &str, value: Value| root.insert(name.to_owned(), value);
    put("version", json!(VERSION));
    put("unit", json!("m"));
    put("v", list(&draft.vertices, |&v| vector(v)));
    put("arcs", list(&draft.arcs, arc));
    put("faces", list(&draft.faces, face));
    let edges = list(&draft.edge_labels, |([a, b], label)| json!([a, b, label]));
    let corners = list(&draft.corner_labels, |(v, label)| json!([v, label]));
    put("labels", json!({ "edges": edges, "corners": corners }));
    let flip = json!({ "edges": draft.edge_flips, "corners": draft.corner_flips });
    put("flip", flip);
    put("extras", list(&draft.extras, extra));
    if let Some(ground) = draft.ground {
        put("ground", json!(ground));
    }
    Value::Object(root).to_string()
}

fn list<T>(items: &[T], value: impl Fn(&T) -> Value) -> Value {
    Value::Array(items.iter().map(value).collect())
}

fn vector(v: DVec3) -> Value {
    json!(v.to_array())
}

fn arc(arc: &DraftArc) -> Value {
    json!({
        "from": arc.from,
        "to": arc.to,
        "centre": vector(arc.centre),
        "axis": vector(arc.axis),
    })
}

fn face(face: &DraftFace) -> Value {
    let mut all = Map::new();
    all.insert("label".into(), json!(face.labels));
    if let Some(surface) = &face.surface {
        let param = match surface {
            FaceSurface::Sweep(sweep) => {
                json!({ "sweep": profile(sweep), "dir": vector(sweep.direction()) })
            }
            FaceSurface::Disk(own) => json!({ "disk": disk(own) }),
        };
        all.insert("param".into(), param);
    }
    all.insert("loops".into(), json!(face.loops));
    if let Some(thickness) = face.thickness {
        all.insert("thickness".into(), json!(thickness));
    }
    Value::Object(all)
}

fn profile(sweep: &Sweep) -> Value {
    list(sweep.profile().pieces(), |piece| match piece {
        Piece::Line { from, to } => json!(["line", vector(*from), vector(*to)]),
        Piece::Arc(arc) => json!([
            "arc",
            vector(arc.centre),
            arc.radius,
            vector(arc.x),
            vector(arc.y),
            arc.from,
            arc.to
        ]),
    })
}

fn disk(disk: &Disk) -> Value {
    let rim = disk.rim();
    json!({
        "centre": vector(rim.centre),
        "normal": vector(disk.normal()),
        "zero": vector(rim.x),
        "radius": rim.radius,
        "angles": [rim.from, rim.to],
    })
}

fn extra(mesh: &ExtraMesh) -> Value {
    json!({
        "name": mesh.name,
        "material": mesh.material,
        "v": list(&mesh.positions, |&v| vector(v)),
        "triangles": mesh.triangles,
    })
}
