//! The stages of a surface up to its cells' mesh, run by a recipe.

use crate::field::CellKind;
use crate::generators::GivenFile;
use crate::generators::scene_picture::SceneStages;
use crate::generators::surface::stages::Stages;
use crate::generators::surface::{SCHEMA, keys};
use crate::graph::Wiring;
use crate::recipe::Recipe;
use crate::shapes::Shape;
use crate::surface_cells::metrics::SurfaceMetrics;
use crate::trimesh::testing::Soup;
use glam::DVec3;
use std::fmt::Write;

/// The index of the stage that makes cells from the mesh.
const CELLS: usize = 4;

/// A surface to put cells on.
pub struct Body {
    pub name: String,
    /// The triangles, if the surface comes from a file.
    soup: Option<Soup>,
    has_bones: bool,
}

/// The parameters of the cells.
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    pub kind: CellKind,
    pub aspect: f64,
    pub cells: f64,
}

/// The stages of a surface, and the figures of its cells.
pub struct Whole {
    pub stages: Stages,
    pub figures: SurfaceMetrics,
}

/// A shape with its default numbers.
pub fn by_rule(shape: Shape) -> Body {
    Body {
        name: shape.word().to_owned(),
        soup: None,
        has_bones: !shape.bones(&[]).is_empty(),
    }
}

/// A surface from a file.
pub fn from_file(name: &str, soup: Soup) -> Body {
    Body {
        name: name.to_owned(),
        soup: Some(soup),
        has_bones: false,
    }
}

/// The soup scaled, and turned by `angle` (in radians) about a skew axis.
pub fn moved((positions, triangles): &Soup, scale: f64, angle: f64) -> Soup {
    let about = DVec3::new(0.6, 0.0, 0.8);
    let (sin, cos) = libm::sincos(angle);
    let turn = |v: DVec3| {
        let along = about * about.dot(v);
        along + cos * (v - along) + sin * about.cross(v)
    };
    let places = positions.iter().map(|&p| scale * turn(p));
    (places.collect(), triangles.clone())
}

impl Body {
    /// Runs the stages up to the cells' mesh. Rows follow the bones; without bones, borders and creases.
    pub fn whole(&self, asked: Asked) -> Whole {
        let file = self.soup.as_ref().map(file);
        let mut recipe = Recipe::new(&SCHEMA);
        if let Some(file) = &file {
            let rows = Some(vec![file.named().row()]);
            let drawn = SCHEMA.rules.draw(&mut recipe, keys::MODEL, rows);
            drawn.expect("a file's row");
        }
        let form = match file {
            Some(_) => ("on", "whole"),
            None => ("form", &*self.name),
        };
        let dir = ("dir", if self.has_bones { "bones" } else { "border" });
        let [cells, aspect] = [asked.cells, asked.aspect].map(|number| number.to_string());
        let cells = [("kind", asked.kind.word()), ("ca", &aspect), ("cn", &cells)];
        for (key, value) in [form, dir].into_iter().chain(cells) {
            recipe.set(key, value).expect("a value of its row");
        }
        let mut stages = Stages::new(&recipe);
        if let Some(file) = file {
            let files = &mut stages.shared_mut().files;
            files.give(file.digest(), file.into_bytes());
        }
        while stages.at().is_some_and(|at| at < CELLS) {
            assert_eq!(stages.failure(), None, "{}", self.name);
            stages.advance();
        }
        let (site, mesh) = (stages.site().expect("a site"), stages.mesh());
        Whole {
            figures: SurfaceMetrics::new(site.mesh(), mesh.expect("a mesh")),
            stages,
        }
    }
}

/// The soup as an OBJ file.
fn file((positions, triangles): &Soup) -> GivenFile {
    let mut text = String::new();
    for p in positions {
        let _ = writeln!(text, "v {} {} {}", p.x, p.y, p.z);
    }
    for t in triangles {
        let [a, b, c] = t.map(|v| v + 1);
        let _ = writeln!(text, "f {a} {b} {c}");
    }
    GivenFile::whole("a.obj", text.into_bytes())
}
