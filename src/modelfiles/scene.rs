//! The scene of a GLB file: all triangles that it draws.

use super::accessor::{BufferView, ComponentType};
use super::affine::Affine;
use super::glb_notices::{broken, needs};
use super::json::Json;
use crate::notice::{Code, Notice};

/// Triangles to draw: views of the file's numbers, and where they are placed.
pub(super) struct Draw {
    pub places: BufferView,
    pub corners: Option<BufferView>,
    pub mode: Mode,
    pub frame: Affine,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Mode {
    Triangles,
    Strip,
    Fan,
}

/// Extensions that compress the geometry, so that it cannot be read, and extensions that can be
/// ignored.
const COMPRESSED: [&str; 2] = ["KHR_draco_mesh_compression", "EXT_meshopt_compression"];
const HARMLESS: [&str; 4] = [
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "KHR_texture_basisu",
    "EXT_texture_webp",
];
/// The most draws and visited nodes: a hostile file may draw the same things over and over.
const MOST_DRAWS: usize = 100_000;
/// The most primitives, including those that draw no triangles.
const MOST_PRIMITIVES: usize = 10 * MOST_DRAWS;
/// The deepest nesting of nodes.
const DEPTH: usize = 128;

/// Collects all draws of a file's scene, in slices.
pub(super) struct ModelScene {
    json: Json,
    /// The length of the binary chunk.
    bytes: usize,
    draws: Vec<Draw>,
    /// How many nodes and primitives have been visited.
    visits: usize,
    primitives: usize,
    /// The root nodes (`None` if an index is invalid), and how many of them have been visited.
    roots: Vec<Option<usize>>,
    root: usize,
    /// The nodes from a root down to the current node, which is the last.
    path: Vec<Visit>,
}

/// A node that is being visited.
struct Visit {
    node: usize,
    frame: Affine,
    /// Index of the next primitive of the node's mesh, and index of its next child.
    primitive: usize,
    child: usize,
}

impl ModelScene {
    /// Starts with the head of a file, and the length of its binary chunk.
    ///
    /// # Errors
    /// If the file needs an extension that cannot be read.
    pub fn new(json: Json, bytes: usize) -> Result<Self, Notice> {
        for needed in json.list_of("extensionsRequired") {
            let name = needed.text().unwrap_or("?");
            let code = match name {
                name if COMPRESSED.contains(&name) => Code::FileCompressed,
                name if HARMLESS.contains(&name) || name.starts_with("KHR_materials") => continue,
                _ => Code::FileNeeds,
            };
            return Err(needs(code, name));
        }
        let roots = roots(&json);
        Ok(Self {
            json,
            bytes,
            draws: Vec::new(),
            visits: 0,
            primitives: 0,
            roots,
            root: 0,
            path: Vec::new(),
        })
    }

    /// Does up to `amount` steps; returns the draws at the end.
    pub fn advance(&mut self, amount: usize) -> Option<Result<Vec<Draw>, Notice>> {
        for _ in 0..amount {
            match self.step() {
                Ok(true) => {}
                Ok(false) => return Some(Ok(std::mem::take(&mut self.draws))),
                Err(why) => return Some(Err(why)),
            }
        }
        None
    }

    /// Looks at the next primitive, or goes to the next node; false if there is none.
    fn step(&mut self) -> Result<bool, Notice> {
        let Some(visit) = self.path.last_mut() else {
            let Some(root) = self.roots.get(self.root) else {
                return Ok(false);
            };
            self.root += 1;
            self.enter(*root, Affine::NONE)?;
            return Ok(true);
        };
        let node = &self.json.list_of("nodes")[visit.node];
        if let Some(mesh) = node.index_of("mesh") {
            let meshes = self.json.list_of("meshes");
            let mesh = meshes.get(mesh).ok_or_else(|| broken("mesh", mesh))?;
            if let Some(primitive) = mesh.list_of("primitives").get(visit.primitive) {
                visit.primitive += 1;
                self.primitives += 1;
                if self.primitives > MOST_PRIMITIVES {
                    return Err(broken("primitive", self.draws.len()));
                }
                let frame = visit.frame;
                let draw = self.draw(primitive, frame)?;
                self.draws.extend(draw);
                return Ok(true);
            }
        }
        if let Some(child) = node.list_of("children").get(visit.child) {
            visit.child += 1;
            let child = child.index().ok_or_else(|| broken("node", visit.node))?;
            let frame = visit.frame;
            self.enter(Some(child), frame)?;
        } else {
            self.path.pop();
        }
        Ok(true)
    }

    fn enter(&mut self, number: Option<usize>, outer: Affine) -> Result<(), Notice> {
        let nodes = self.json.list_of("nodes");
        let node = number.and_then(|number| nodes.get(number));
        self.visits += 1;
        // In a broken file nodes may contain each other.
        let is_inside = self.path.len() < DEPTH && self.visits <= MOST_DRAWS;
        match (number, node.filter(|_| is_inside)) {
            (Some(number), Some(node)) => self.path.push(Visit {
                frame: outer.then(&Affine::of(node)),
                node: number,
                primitive: 0,
                child: 0,
            }),
            _ => return Err(broken("node", number)),
        }
        Ok(())
    }

    fn view(&self, number: usize, group: usize) -> Result<BufferView, Notice> {
        BufferView::of_accessor((&self.json, self.bytes), number, group)
    }

    /// The draw of a primitive, if it has triangles.
    fn draw(&self, primitive: &Json, frame: Affine) -> Result<Option<Draw>, Notice> {
        let mode = match primitive.get("mode").map(|mode| mode.index()) {
            None | Some(Some(4)) => Mode::Triangles,
            Some(Some(5)) => Mode::Strip,
            Some(Some(6)) => Mode::Fan,
            // Points and lines are skipped.
            _ => return Ok(None),
        };
        let extensions = primitive.get("extensions");
        if let Some(name) = COMPRESSED
            .iter()
            .find(|name| extensions.and_then(|e| e.get(name)).is_some())
        {
            return Err(needs(Code::FileCompressed, name));
        }
        let Some(places) = primitive
            .get("attributes")
            .and_then(|all| all.index_of("POSITION"))
        else {
            return Ok(None);
        };
        let corners = match primitive.get("indices") {
            None => None,
            Some(number) => {
                let number = number.index().ok_or_else(|| broken("accessor", None))?;
                Some(self.view(number, 1)?)
            }
        };
        let places = self.view(places, 3)?;
        if places.kind == ComponentType::U32
            || corners.is_some_and(|view| {
                !matches!(
                    view.kind,
                    ComponentType::U8 | ComponentType::U16 | ComponentType::U32
                )
            })
        {
            return Err(broken("primitive", self.draws.len()));
        }
        if self.draws.len() == MOST_DRAWS {
            return Err(broken("primitive", self.draws.len()));
        }
        Ok(Some(Draw {
            places,
            corners,
            mode,
            frame,
        }))
    }
}

/// The root nodes of the default scene. Without a scene: the nodes that are no child of another
/// node.
fn roots(json: &Json) -> Vec<Option<usize>> {
    let number = json.index_of("scene").unwrap_or(0);
    if let Some(scene) = json.list_of("scenes").get(number) {
        return scene.list_of("nodes").iter().map(Json::index).collect();
    }
    let nodes = json.list_of("nodes");
    let mut is_root = vec![true; nodes.len()];
    for child in nodes.iter().flat_map(|node| node.list_of("children")) {
        if let Some(root) = child.index().and_then(|n| is_root.get_mut(n)) {
            *root = false;
        }
    }
    let roots = (0..nodes.len()).filter(|&n| is_root[n]);
    roots.map(Some).collect()
}
