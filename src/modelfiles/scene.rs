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

/// The notice that something in the file is invalid.
pub(super) fn broken(what: &str, number: usize) -> Notice {
    Notice::new(Code::FileBroken)
        .with("kind", "GLB".to_owned())
        .with("what", format!("{what} {number}"))
}

/// Extensions without which a file cannot be read, and those that can be ignored.
const COMPRESSED: [&str; 2] = ["KHR_draco_mesh_compression", "EXT_meshopt_compression"];
const HARMLESS: [&str; 4] = [
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "KHR_texture_basisu",
    "EXT_texture_webp",
];
/// The most draws: a hostile file may draw the same things over and over.
const MOST_DRAWS: usize = 100_000;
/// The deepest nesting of nodes.
const DEPTH: usize = 128;

/// Collects all draws of a file's scene. `bytes` is the length of the binary chunk.
pub(super) struct ModelScene<'a> {
    json: &'a Json,
    bytes: usize,
    draws: Vec<Draw>,
    visits: usize,
}

impl<'a> ModelScene<'a> {
    pub fn draws(json: &'a Json, bytes: usize) -> Result<Vec<Draw>, Notice> {
        for needed in json.list_of("extensionsRequired") {
            let name = needed.text().unwrap_or("?");
            let code = match name {
                name if COMPRESSED.contains(&name) => Code::FileCompressed,
                name if HARMLESS.contains(&name) || name.starts_with("KHR_materials") => continue,
                _ => Code::FileNeeds,
            };
            let quoted = crate::notice::quote(name);
            return Err(Notice::new(code)
                .with("kind", "GLB".to_owned())
                .with("name", quoted));
        }
        let mut scene = Self {
            json,
            bytes,
            draws: Vec::new(),
            visits: 0,
        };
        for root in scene.roots() {
            scene.visit(root, &Affine::NONE, DEPTH)?;
        }
        Ok(scene.draws)
    }

    /// The root nodes of the default scene; without a scene, the nodes that are no other's child.
    fn roots(&self) -> Vec<usize> {
        let number = self.json.index_of("scene").unwrap_or(0);
        if let Some(scene) = self.json.list_of("scenes").get(number) {
            let nodes = scene.list_of("nodes").iter();
            return nodes.map(|n| n.index().unwrap_or(usize::MAX)).collect();
        }
        let nodes = self.json.list_of("nodes");
        let mut is_root = vec![true; nodes.len()];
        for child in nodes.iter().flat_map(|node| node.list_of("children")) {
            if let Some(root) = child.index().and_then(|n| is_root.get_mut(n)) {
                *root = false;
            }
        }
        (0..nodes.len()).filter(|&n| is_root[n]).collect()
    }

    fn visit(&mut self, number: usize, outer: &Affine, depth: usize) -> Result<(), Notice> {
        let json = self.json;
        let node = json.list_of("nodes").get(number);
        self.visits += 1;
        // In a broken file nodes may contain each other.
        let (Some(node), 1..) = (node, depth) else {
            return Err(broken("node", number));
        };
        if self.visits > MOST_DRAWS {
            return Err(broken("node", number));
        }
        let frame = outer.then(&Affine::of(node));
        if let Some(mesh) = node.index_of("mesh") {
            let meshes = json.list_of("meshes");
            let mesh = meshes.get(mesh).ok_or_else(|| broken("mesh", mesh))?;
            for primitive in mesh.list_of("primitives") {
                self.primitive(primitive, frame)?;
            }
        }
        for child in node.list_of("children") {
            let child = child.index().ok_or_else(|| broken("node", number))?;
            self.visit(child, &frame, depth - 1)?;
        }
        Ok(())
    }

    fn primitive(&mut self, primitive: &Json, frame: Affine) -> Result<(), Notice> {
        let mode = match primitive.get("mode").map(|mode| mode.index()) {
            None | Some(Some(4)) => Mode::Triangles,
            Some(Some(5)) => Mode::Strip,
            Some(Some(6)) => Mode::Fan,
            // Points and lines are skipped.
            _ => return Ok(()),
        };
        let extensions = primitive.get("extensions");
        if let Some(name) = COMPRESSED
            .iter()
            .find(|name| extensions.and_then(|e| e.get(name)).is_some())
        {
            let compressed = Notice::new(Code::FileCompressed).with("kind", "GLB".to_owned());
            return Err(compressed.with("name", crate::notice::quote(name)));
        }
        let Some(places) = primitive
            .get("attributes")
            .and_then(|all| all.index_of("POSITION"))
        else {
            return Ok(());
        };
        let corners = match primitive.get("indices") {
            None => None,
            Some(number) => Some(self.view(number.index().unwrap_or(usize::MAX), 1)?),
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
        self.draws.push(Draw {
            places,
            corners,
            mode,
            frame,
        });
        Ok(())
    }

    /// The view of an accessor with `group` components.
    fn view(&self, number: usize, group: usize) -> Result<BufferView, Notice> {
        let bad = || broken("accessor", number);
        let accessor = self.json.list_of("accessors").get(number).ok_or_else(bad)?;
        if accessor.get("sparse").is_some() {
            let needs = Notice::new(Code::FileNeeds).with("kind", "GLB".to_owned());
            return Err(needs.with("name", "\"sparse\"".to_owned()));
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
