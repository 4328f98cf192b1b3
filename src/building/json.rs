//! Reads a building from JSON. docs/building.md describes the format.

use super::draft::{Draft, DraftArc, DraftFace, ExtraMesh};
use super::fault::BuildingFault;
use super::path::Path;
use super::piece::{CircularArc, Piece};
use super::surface::{Disk, FaceSurface, Sweep};
use glam::DVec3;
use serde_json::Value;

/// The version of the format.
pub const VERSION: u64 = 1;

type Read<T> = Result<T, BuildingFault>;

/// A value, and where it is: the value that contains it, and its name or index there.
#[derive(Clone, Copy)]
struct At<'a> {
    value: &'a Value,
    within: Option<(&'a At<'a>, PathPart<'a>)>,
}

/// The name of a value in an object, or its index in a list.
#[derive(Clone, Copy)]
enum PathPart<'a> {
    Name(&'a str),
    Item(usize),
}

/// Reads a draft from JSON text. Only [`super::Building::new`] checks whether it is a building.
///
/// # Errors
/// As [`parse`] and [`draft`].
pub fn read(text: &str) -> Read<Draft> {
    draft(&parse(text)?)
}

/// The first half of [`read`]: parses the text.
///
/// # Errors
/// Text that is not JSON, with its line and column.
pub fn parse(text: &str) -> Read<Value> {
    serde_json::from_str(text).map_err(|fault| BuildingFault::NotJson {
        line: fault.line(),
        column: fault.column(),
        why: fault.to_string(),
    })
}

/// The second half of [`read`]: makes a draft of parsed text.
///
/// # Errors
/// Another version or unit; a value that is missing or of the wrong kind, with its place.
pub fn draft(value: &Value) -> Read<Draft> {
    let root = At {
        value,
        within: None,
    };
    if !value.is_object() {
        return Err(root.fault("an object"));
    }
    check_head(value)?;
    let labels = root.get("labels");
    let flip = root.get("flip");
    Ok(Draft {
        vertices: root.need("v")?.each(|at| at.vector())?,
        arcs: root.each_of("arcs", read_arc)?,
        faces: root.need("faces")?.each(read_face)?,
        edge_labels: each(part(&labels, "edges"), read_edge_label)?,
        corner_labels: each(part(&labels, "corners"), read_corner_label)?,
        edge_flips: each(part(&flip, "edges"), read_pair)?,
        corner_flips: each(part(&flip, "corners"), |at| at.index())?,
        extras: root.each_of("extras", read_extra)?,
        ground: root.get("ground").map(|at| at.number()).transpose()?,
    })
}

/// The value under a name, if there is an object and the object has it.
fn part<'a>(of: &'a Option<At<'a>>, name: &'a str) -> Option<At<'a>> {
    of.as_ref()?.get(name)
}

/// Tests version and unit.
fn check_head(value: &Value) -> Read<()> {
    let found = |name: &str| value.get(name).map_or(String::new(), Value::to_string);
    if value.get("version").and_then(Value::as_u64) != Some(VERSION) {
        let found = found("version");
        return Err(BuildingFault::Version { found });
    }
    match value.get("unit").and_then(Value::as_str) {
        Some("m") => Ok(()),
        _ => Err(BuildingFault::Unit {
            found: found("unit"),
        }),
    }
}

/// The items of a list that may be missing.
fn each<T>(list: Option<At<'_>>, read: impl Fn(&At<'_>) -> Read<T>) -> Read<Vec<T>> {
    list.map_or(Ok(Vec::new()), |list| list.each(read))
}

impl<'a> At<'a> {
    /// The path of the value as text, such as `faces[3].loops[0]`; empty at the root.
    fn path(&self) -> String {
        let Some((of, part)) = self.within else {
            return String::new();
        };
        let path = of.path();
        match part {
            PathPart::Name(name) if path.is_empty() => name.to_owned(),
            PathPart::Name(name) => format!("{path}.{name}"),
            PathPart::Item(k) => format!("{path}[{k}]"),
        }
    }

    fn fault(&self, allowed: &'static str) -> BuildingFault {
        BuildingFault::Field {
            path: self.path(),
            allowed,
        }
    }

    /// A value within this one.
    fn at<'b>(&'b self, value: &'b Value, part: PathPart<'b>) -> At<'b> {
        At {
            value,
            within: Some((self, part)),
        }
    }

    /// The value under a name; `None` if it is missing or null.
    fn get<'b>(&'b self, name: &'b str) -> Option<At<'b>> {
        let value = self.value.get(name).filter(|value| !value.is_null())?;
        Some(self.at(value, PathPart::Name(name)))
    }

    fn need<'b>(&'b self, name: &'b str) -> Read<At<'b>> {
        let missing = || self.at(&Value::Null, PathPart::Name(name)).fault("a value");
        self.get(name).ok_or_else(missing)
    }

    fn each_of<T>(&self, name: &str, read: impl Fn(&At<'_>) -> Read<T>) -> Read<Vec<T>> {
        each(self.get(name), read)
    }

    fn list(&self) -> Read<Vec<At<'_>>> {
        let list = self.value.as_array().ok_or_else(|| self.fault("a list"))?;
        let items = list.iter().enumerate();
        Ok(items
            .map(|(k, value)| self.at(value, PathPart::Item(k)))
            .collect())
    }

    fn each<T>(&self, read: impl Fn(&At<'_>) -> Read<T>) -> Read<Vec<T>> {
        self.list()?.iter().map(read).collect()
    }

    /// A list of just `N` values.
    fn array<const N: usize>(&self, allowed: &'static str) -> Read<[At<'_>; N]> {
        let list = self.list()?;
        list.try_into().map_err(|_| self.fault(allowed))
    }

    fn number(&self) -> Read<f64> {
        self.value.as_f64().ok_or_else(|| self.fault("a number"))
    }

    fn index(&self) -> Read<u32> {
        let index = self.value.as_u64().and_then(|n| u32::try_from(n).ok());
        index.ok_or_else(|| self.fault("the number of a vertex"))
    }

    fn text(&self) -> Read<&str> {
        self.value.as_str().ok_or_else(|| self.fault("a text"))
    }

    fn vector(&self) -> Read<DVec3> {
        let [x, y, z] = self.array("three numbers")?;
        Ok(DVec3::new(x.number()?, y.number()?, z.number()?))
    }
}

fn read_arc(at: &At<'_>) -> Read<DraftArc> {
    Ok(DraftArc {
        from: at.need("from")?.index()?,
        to: at.need("to")?.index()?,
        centre: at.need("centre")?.vector()?,
        axis: at.need("axis")?.vector()?,
    })
}

fn read_face(at: &At<'_>) -> Read<DraftFace> {
    Ok(DraftFace {
        labels: at
            .get("label")
            .map_or(Ok(Vec::new()), |at| read_labels(&at))?,
        surface: at.get("param").map(|at| read_surface(&at)).transpose()?,
        loops: at.need("loops")?.each(|ring| ring.each(|at| at.index()))?,
        thickness: at.get("thickness").map(|at| at.number()).transpose()?,
    })
}

/// The labels: a list, or one text; an empty text is no label.
fn read_labels(at: &At<'_>) -> Read<Vec<String>> {
    match at.value {
        Value::String(label) if label.is_empty() => Ok(Vec::new()),
        Value::String(label) => Ok(vec![label.clone()]),
        Value::Array(_) => at.each(|at| Ok(at.text()?.to_owned())),
        _ => Err(at.fault("a text or a list of texts")),
    }
}

fn read_surface(at: &At<'_>) -> Read<FaceSurface> {
    if let Some(disk) = at.get("disk") {
        return read_disk(&disk);
    }
    let Some(sweep) = at.get("sweep") else {
        return Err(at.fault("a sweep or a disk"));
    };
    let profile = Path::new(sweep.each(read_piece)?);
    Ok(FaceSurface::Sweep(Sweep::new(
        profile,
        at.need("dir")?.vector()?,
    )))
}

fn read_piece(at: &At<'_>) -> Read<Piece> {
    let list = at.list()?;
    let kind = list.first().map(At::text).transpose()?;
    match (kind, &list[..]) {
        (Some("line"), [_, from, to]) => Ok(Piece::Line {
            from: from.vector()?,
            to: to.vector()?,
        }),
        (Some("arc"), [_, centre, radius, x, y, from, to]) => Ok(Piece::Arc(CircularArc {
            centre: centre.vector()?,
            radius: radius.number()?,
            x: x.vector()?,
            y: y.vector()?,
            from: from.number()?,
            to: to.number()?,
        })),
        _ => Err(at.fault("[\"line\", from, to] or [\"arc\", centre, radius, x, y, from, to]")),
    }
}

fn read_disk(at: &At<'_>) -> Read<FaceSurface> {
    let angles = at.need("angles")?;
    let [from, to] = angles.array("two numbers")?;
    Ok(FaceSurface::Disk(Disk::new(
        at.need("centre")?.vector()?,
        at.need("normal")?.vector()?,
        at.need("zero")?.vector()?,
        at.need("radius")?.number()?,
        [from.number()?, to.number()?],
    )))
}

fn read_pair(at: &At<'_>) -> Read<[u32; 2]> {
    let [a, b] = at.array("two numbers of vertices")?;
    Ok([a.index()?, b.index()?])
}

fn read_edge_label(at: &At<'_>) -> Read<([u32; 2], String)> {
    let [a, b, label] = at.array("two numbers of vertices and a text")?;
    Ok(([a.index()?, b.index()?], label.text()?.to_owned()))
}

fn read_corner_label(at: &At<'_>) -> Read<(u32, String)> {
    let [v, label] = at.array("the number of a vertex and a text")?;
    Ok((v.index()?, label.text()?.to_owned()))
}

fn read_extra(at: &At<'_>) -> Read<ExtraMesh> {
    let triangle = |at: &At<'_>| {
        let [a, b, c] = at.array("three numbers of vertices")?;
        Ok([a.index()?, b.index()?, c.index()?])
    };
    Ok(ExtraMesh {
        name: at.need("name")?.text()?.to_owned(),
        material: at.need("material")?.text()?.to_owned(),
        positions: at.need("v")?.each(|at| at.vector())?,
        triangles: at.need("triangles")?.each(triangle)?,
    })
}
