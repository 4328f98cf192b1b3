//! The scene of a GLB file: its draws, and the views of its numbers.

use super::json::Json;
use crate::notice::{Code, Notice};
use glam::DVec3;

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

/// A view of numbers: `count` groups, one every `stride` bytes.
#[derive(Clone, Copy)]
pub(super) struct BufferView {
    pub start: usize,
    pub stride: usize,
    pub count: usize,
    pub kind: ComponentType,
    pub is_normalized: bool,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum ComponentType {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl ComponentType {
    fn of(number: usize) -> Option<Self> {
        Some(match number {
            5120 => ComponentType::I8,
            5121 => ComponentType::U8,
            5122 => ComponentType::I16,
            5123 => ComponentType::U16,
            5125 => ComponentType::U32,
            5126 => ComponentType::F32,
            _ => return None,
        })
    }

    pub fn bytes(self) -> usize {
        match self {
            ComponentType::I8 | ComponentType::U8 => 1,
            ComponentType::I16 | ComponentType::U16 => 2,
            ComponentType::U32 | ComponentType::F32 => 4,
        }
    }
}

/// An affine map: three axes and an origin.
#[derive(Clone, Copy)]
pub(super) struct Affine([DVec3; 4]);

impl Affine {
    const NONE: Self = Self([DVec3::X, DVec3::Y, DVec3::Z, DVec3::ZERO]);

    fn turn(&self, v: DVec3) -> DVec3 {
        self.0[0] * v.x + self.0[1] * v.y + self.0[2] * v.z
    }

    pub fn place(&self, p: DVec3) -> DVec3 {
        self.turn(p) + self.0[3]
    }

    fn then(&self, inner: &Affine) -> Self {
        let [x, y, z, at] = inner.0;
        Self([self.turn(x), self.turn(y), self.turn(z), self.place(at)])
    }

    /// Whether it mirrors.
    pub fn mirrors(&self) -> bool {
        self.0[0].cross(self.0[1]).dot(self.0[2]) < 0.0
    }

    /// The local transform of a node.
    fn of(node: &Json) -> Self {
        let numbers = |name: &str| -> Vec<f64> {
            let list = node.list_of(name).iter();
            list.map(|x| x.number().unwrap_or(f64::NAN)).collect()
        };
        if let [a, b, c, _, d, e, f, _, g, h, i, _, x, y, z, _] = numbers("matrix")[..] {
            let v = DVec3::new;
            return Self([v(a, b, c), v(d, e, f), v(g, h, i), v(x, y, z)]);
        }
        let at = match numbers("translation")[..] {
            [x, y, z] => DVec3::new(x, y, z),
            _ => DVec3::ZERO,
        };
        let scale = match numbers("scale")[..] {
            [x, y, z] => DVec3::new(x, y, z),
            _ => DVec3::ONE,
        };
        let [x, y, z] = match numbers("rotation")[..] {
            [x, y, z, w] => turned(x, y, z, w),
            _ => [DVec3::X, DVec3::Y, DVec3::Z],
        };
        Self([x * scale.x, y * scale.y, z * scale.z, at])
    }
}

/// The axes of a rotation by a quaternion.
fn turned(x: f64, y: f64, z: f64, w: f64) -> [DVec3; 3] {
    let square = x * x + y * y + z * z + w * w;
    let s = if square > 0.0 { 2.0 / square } else { 0.0 };
    [
        DVec3::new(
            1.0 - s * (y * y + z * z),
            s * (x * y + z * w),
            s * (x * z - y * w),
        ),
        DVec3::new(
            s * (x * y - z * w),
            1.0 - s * (x * x + z * z),
            s * (y * z + x * w),
        ),
        DVec3::new(
            s * (x * z + y * w),
            s * (y * z - x * w),
            1.0 - s * (x * x + y * y),
        ),
    ]
}

/// The notice that something in the file is invalid. Its number is not known if the file names it wrongly.
pub(super) fn broken(what: &str, number: impl Into<Option<usize>>) -> Notice {
    let what = match number.into() {
        Some(number) => format!("{what} {number}"),
        None => what.to_owned(),
    };
    Notice::new(Code::FileBroken)
        .with("kind", "GLB".to_owned())
        .with("what", what)
}

/// The notice that a file needs what cannot be read, whose name a visitor will search for.
fn needs(code: Code, name: &str) -> Notice {
    Notice::new(code)
        .with("kind", "GLB".to_owned())
        .with("name", crate::notice::quote_long(name))
}

/// Extensions without which a file cannot be read, and those that can be ignored.
const COMPRESSED: [&str; 2] = ["KHR_draco_mesh_compression", "EXT_meshopt_compression"];
const HARMLESS: [&str; 4] = [
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "KHR_texture_basisu",
    "EXT_texture_webp",
];
/// The most draws and visited nodes: a hostile file may draw the same things over and over.
const MOST_DRAWS: usize = 100_000;
/// The most primitives, with those that draw no triangles.
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
    /// The root nodes, and how many of them have been visited.
    roots: Vec<Option<usize>>,
    root: usize,
    /// The current node, after those that contain it.
    path: Vec<Visit>,
}

/// A node that is being visited.
struct Visit {
    node: usize,
    frame: Affine,
    /// The next primitive of its mesh, and its next child.
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

    /// The view of an accessor with `group` components.
    fn view(&self, number: usize, group: usize) -> Result<BufferView, Notice> {
        let bad = || broken("accessor", number);
        let accessor = self.json.list_of("accessors").get(number).ok_or_else(bad)?;
        if accessor.get("sparse").is_some() {
            return Err(needs(Code::FileNeeds, "sparse"));
        }
        let wanted = if group == 3 { "VEC3" } else { "SCALAR" };
        if accessor.get("type").and_then(Json::text) != Some(wanted) {
            return Err(bad());
        }
        let kind = accessor
            .index_of("componentType")
            .and_then(ComponentType::of)
            .ok_or_else(bad)?;
        let count = accessor.index_of("count").ok_or_else(bad)?;
        let at = accessor.index_of("bufferView").ok_or_else(bad)?;
        let view = self.json.list_of("bufferViews").get(at).ok_or_else(bad)?;
        let buffer = view.index_of("buffer").ok_or_else(bad)?;
        let buffers = self.json.list_of("buffers");
        let uri = buffers.get(buffer).ok_or_else(bad)?.get("uri");
        if uri.is_some() {
            return Err(Code::FileInParts.into());
        }
        if buffer != 0 {
            return Err(bad());
        }
        let offset = |json: &Json| match json.get("byteOffset") {
            None => Some(0),
            Some(offset) => offset.index(),
        };
        let start = offset(view).ok_or_else(bad)?;
        let length = view.index_of("byteLength").ok_or_else(bad)?;
        let inner = offset(accessor).ok_or_else(bad)?;
        let size = group * kind.bytes();
        let stride = match view.get("byteStride") {
            None => size,
            Some(stride) => stride
                .index()
                .filter(|&stride| stride >= size)
                .ok_or_else(bad)?,
        };
        // All numbers are below 2^32, so the product of two fits into 64 bits.
        let all = |numbers: [usize; 3]| numbers.map(|n| n as u64);
        let [first, last, each] = all([inner, count.saturating_sub(1), stride]);
        let end = first + last * each + if count == 0 { 0 } else { size as u64 };
        if end > length as u64 || start as u64 + length as u64 > self.bytes as u64 {
            return Err(bad());
        }
        Ok(BufferView {
            start: start + inner,
            stride,
            count,
            kind,
            is_normalized: accessor.get("normalized") == Some(&Json::Yes),
        })
    }
}

/// The root nodes of the default scene; without a scene, the nodes that are no other's child.
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
