//! The results as text, for measurements.

use super::PileEngine;
use super::components::Components;
use super::site::Site;
use crate::decimal;
use crate::pile::{Body, Fate, Kind, RefineParams, Wall, contacts};
use crate::trimesh::TriMesh;
use glam::{DMat3, DVec3};

impl PileEngine {
    /// The results as text files: names and contents. Lengths are in the shape's units, y up.
    pub(super) fn data_files(&self) -> Vec<(&'static str, String)> {
        let made = &self.made;
        let all = (
            made.placed.made(),
            made.settled.made(),
            made.components.made(),
            made.site.made(),
        );
        let (Some(placed), Some(settled), Some(components), Some(site)) = all else {
            return Vec::new();
        };
        let pile = PileText {
            words: made.words(),
            components,
            kinds: &placed.kinds,
            bodies: settled.bodies(),
            site,
            params: *made.settled.params(),
        };
        vec![
            ("bodies.json", pile.json()),
            ("bodies.csv", self.places_table()),
        ]
    }
}

/// A settled pile, to be written.
struct PileText<'a> {
    words: Vec<&'static str>,
    components: &'a Components,
    kinds: &'a [Kind],
    bodies: &'a [Body],
    site: &'a Site,
    params: RefineParams,
}

impl PileText<'_> {
    fn json(&self) -> String {
        let count = |fate| self.bodies.iter().filter(|b| b.fate == fate).count();
        let [merged, walls, removed, kept] =
            [Fate::Merged, Fate::Walls, Fate::Removed, Fate::Kept].map(count);
        let components = list(self.variants(), |(word, number, mesh, spheres)| {
            format!(
                "{{\"name\":\"{word}-{number}\",{},\"spheres\":{spheres}}}",
                faces(mesh)
            )
        });
        let touches = contacts(self.bodies, self.kinds);
        let bodies = list(self.kept(), |body| {
            self.body_json(body, &touches[body.dart as usize])
        });
        let walls_text = list(self.site.walls.iter(), wall);
        let shape = faces(&self.site.mesh);
        let placed = kept + removed;
        let (t, d) = (number(self.params.offset), number(self.params.removal));
        let darts = self.bodies.len();
        format!(
            "{{\"components\":{components},\"bodies\":{bodies},\"shape\":{{{shape}}},\"placed\":{placed},\
             \"removed\":{removed},\"walls\":{walls_text},\"T\":{t},\"D\":{d},\"counts\":{{\"darts\":{darts},\
             \"merged\":{merged},\"walls\":{walls},\"removed\":{removed},\"kept\":{kept}}}}}"
        )
    }

    fn kept(&self) -> impl Iterator<Item = &Body> {
        self.bodies.iter().filter(|body| body.fate == Fate::Kept)
    }

    /// All variants: the word, the number, the finest mesh, and the spheres with which overlaps were tested, as text.
    fn variants(&self) -> impl Iterator<Item = (&'static str, usize, &TriMesh, String)> {
        let types = self.words.iter().zip(self.components);
        types.flat_map(|(&word, variants)| {
            let each = variants.all.iter().enumerate();
            each.map(move |(k, component)| {
                let spheres = list(component.widened(), |s| {
                    format!("[{},{}]", numbers(s.centre.to_array()), number(s.radius))
                });
                (word, k, &component.levels[0].mesh, spheres)
            })
        })
    }

    fn body_json(&self, body: &Body, touches: &[u32]) -> String {
        let earlier = &self.components[..body.kind as usize];
        let before: usize = earlier.iter().map(|one| one.all.len()).sum();
        let component = before + body.shape as usize;
        let matrix = matrix(body.turn * body.scale, body.place());
        let normal = numbers(body.normal.to_array());
        let (t, low, high) = (number(body.t), number(body.range.0), number(body.range.1));
        let touches = list(touches.iter(), u32::to_string);
        format!(
            "{{\"component\":{component},\"matrix\":[{matrix}],\"dart\":{},\"layer\":{},\"t\":{t},\
             \"range\":[{low},{high}],\"normal\":[{normal}],\"touches\":{touches}}}",
            body.dart, body.layer
        )
    }
}

/// A matrix of 4 x 4 numbers, column after column.
fn matrix(turn: DMat3, origin: DVec3) -> String {
    let columns = [turn.x_axis, turn.y_axis, turn.z_axis];
    let columns = columns.map(|c| format!("{},0", numbers(c.to_array())));
    format!("{},{},1", columns.join(","), numbers(origin.to_array()))
}

fn wall(wall: &Wall) -> String {
    match wall {
        Wall::Plane { normal, offset } => format!(
            "{{\"normal\":[{}],\"offset\":{}}}",
            numbers(normal.to_array()),
            number(*offset)
        ),
        Wall::Bowl { lowest, curve } => format!(
            "{{\"lowest\":[{}],\"curve\":{}}}",
            numbers(lowest.to_array()),
            number(*curve)
        ),
    }
}

/// The vertices and faces of a mesh.
fn faces(mesh: &TriMesh) -> String {
    let vertices = list(mesh.positions().iter(), |p| {
        format!("[{}]", numbers(p.to_array()))
    });
    let faces = list(mesh.triangles().iter(), |[a, b, c]| {
        format!("[{a},{b},{c}]")
    });
    format!("\"vertices\":{vertices},\"faces\":{faces}")
}

fn list<T>(all: impl Iterator<Item = T>, each: impl Fn(T) -> String) -> String {
    let all: Vec<String> = all.map(each).collect();
    format!("[{}]", all.join(","))
}

fn numbers<const N: usize>(all: [f64; N]) -> String {
    all.map(number).join(",")
}

/// The shortest decimal that reads back as the same bits.
fn number(v: f64) -> String {
    decimal::text(v)
}
