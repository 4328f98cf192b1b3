//! Templates for the JSON of GLB files.

/// Templates for the JSON that describes the binary chunk; numbers replace each @. The numbers of an attribute are
/// the count of vertices, their offset, and their least and greatest coordinates.
pub(super) struct Layout {
    /// Bytes of a vertex.
    pub stride: usize,
    /// The attributes of a vertex: their offset, and their accessor.
    pub attributes: &'static [(usize, &'static str)],
    pub mesh: &'static str,
    pub material: &'static str,
    /// Whether a vertex has a colour.
    pub has_colours: bool,
}

macro_rules! accessor {
    ($view:literal, $kind:literal, $more:literal) => {
        concat!(
            r#",{"bufferView":"#,
            $view,
            r#","type":""#,
            $kind,
            r#"","count":@,"byteOffset":@,"componentType":"#,
            $more,
            "}"
        )
    };
}

pub(super) const POSITIONS: &str = accessor!(0, "VEC3", r#"5126,"min":[@,@,@],"max":[@,@,@]"#);
pub(super) const PLACES: &str = accessor!(0, "VEC2", "5126");
pub(super) const INDICES: &str = accessor!(1, "SCALAR", "@");

pub(super) const PLAIN: Layout = Layout {
    stride: 40,
    attributes: &[
        (0, POSITIONS),
        (12, accessor!(0, "VEC3", "5126")),
        (24, accessor!(0, "VEC4", r#"5123,"normalized":true"#)),
        (32, PLACES),
    ],
    mesh: concat!(
        r#",{"primitives":[{"attributes":{"POSITION":@,"NORMAL":@,"COLOR_0":@,"TEXCOORD_0":@},"#,
        r#""indices":@,"material":@}]}"#,
    ),
    material: r#""metallicFactor":0,"roughnessFactor":@}}]"#,
    has_colours: true,
};
#[cfg(house)]
pub(super) const BARE: Layout = Layout {
    stride: 32,
    attributes: &[
        (0, POSITIONS),
        (12, accessor!(0, "VEC3", "5126")),
        (24, accessor!(0, "VEC4", r#"5123,"normalized":true"#)),
    ],
    mesh: concat!(
        r#",{"primitives":[{"attributes":{"POSITION":@,"NORMAL":@,"COLOR_0":@},"#,
        r#""indices":@,"material":@}]}"#,
    ),
    material: PLAIN.material,
    has_colours: true,
};
/// As [`BARE`], for surfaces that are white all over.
#[cfg(house)]
pub(super) const WHITE: Layout = Layout {
    stride: 24,
    attributes: &[(0, POSITIONS), (12, accessor!(0, "VEC3", "5126"))],
    mesh: concat!(
        r#",{"primitives":[{"attributes":{"POSITION":@,"NORMAL":@},"#,
        r#""indices":@,"material":@}]}"#,
    ),
    material: PLAIN.material,
    has_colours: false,
};
pub(super) const PLACED: Layout = Layout {
    stride: 20,
    attributes: &[
        (0, POSITIONS),
        (
            0,
            r#",{"bufferView":2,"type":"VEC3","componentType":5126,"count":@}"#,
        ),
        (
            0,
            r#",{"bufferView":3,"type":"VEC4","componentType":5126,"count":@}"#,
        ),
        (12, PLACES),
    ],
    mesh: concat!(
        r#",{"primitives":[{"attributes":{"POSITION":@,"NORMAL":@,"TANGENT":@,"TEXCOORD_0":@},"#,
        r#""indices":@,"material":@}]}"#,
    ),
    material: concat!(
        r#""baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":2}},"#,
        r#""normalTexture":{"index":1},"occlusionTexture":{"index":2}}],"#,
        r#""samplers":[{"magFilter":9729,"minFilter":9987,"wrapS":@,"wrapT":@}],"#,
        r#""textures":[{"sampler":0,"source":0},{"sampler":0,"source":1},"#,
        r#"{"sampler":0,"source":2}],"images":["#,
        r#"{"name":"colour","mimeType":"image/png","bufferView":4},"#,
        r#"{"name":"normal","mimeType":"image/png","bufferView":5},"#,
        r#"{"name":"orm","mimeType":"image/png","bufferView":6}]"#,
    ),
    has_colours: false,
};
pub(super) const HEAD: &str = concat!(
    r#"{"asset":{"version":"2.0","generator":"Bubblestone"},"scene":0,"scenes":[{"nodes":[0]}],"#,
    r#""materials":[{"name":"Bubblestone","pbrMetallicRoughness":{"#,
);
pub(super) const BUFFERS: &str = concat!(
    r#","buffers":[{"byteLength":@}],"bufferViews":["#,
    r#"{"buffer":0,"byteLength":@,"byteStride":@,"target":34962},"#,
    r#"{"buffer":0,"byteOffset":@,"byteLength":@,"target":34963}"#,
);
pub(super) const SHARED: &str = concat!(
    r#",{"buffer":0,"byteOffset":@,"byteLength":@,"byteStride":12,"target":34962},"#,
    r#"{"buffer":0,"byteOffset":@,"byteLength":@,"byteStride":16,"target":34962}"#,
);
pub(super) const IMAGE: &str = r#",{"buffer":0,"byteOffset":@,"byteLength":@}"#;
pub(super) const LISTS: [&str; 5] = [
    r#"],"nodes":[{"name":"Bubblestone","children":["#,
    "]}",
    r#"],"meshes":["#,
    r#"],"accessors":["#,
    "]}",
];

#[cfg(house)]
pub(super) const BODY: [&str; 3] = [
    r#","mesh":@"#,
    r#","rotation":[@,@,@,@],"translation":[@,@,@]"#,
    r#","scale":[@,@,@]"#,
];
/// The end of the first node, with its place.
#[cfg(house)]
pub(super) const ROOT: &str = r#"],"scale":[@,@,@],"translation":[@,@,@]}"#;
/// A scale this close to 1 is not written.
#[cfg(house)]
pub(super) const NO_SCALE: f32 = 1e-6;
#[cfg(house)]
pub(super) const PAINTED: &str = concat!(
    r#""pbrMetallicRoughness":{"baseColorFactor":[@,@,@,@],"#,
    r#""metallicFactor":@,"roughnessFactor":@}"#,
);
#[cfg(house)]
pub(super) const BLENDED: &str = r#","alphaMode":"BLEND""#;
