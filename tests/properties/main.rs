//! Properties of each stage and of the whole pipeline. To run one file: `cargo test --test properties
//! fields::`.

#[path = "../common/mod.rs"]
mod common;
#[path = "../paving/mod.rs"]
mod paving;

#[cfg(target_arch = "wasm32")]
mod web;

/// Everything else is tested natively only. The digests show that WebAssembly computes the same bits, so
/// nothing here can differ there.
#[cfg(not(target_arch = "wasm32"))]
mod native {
    mod bad_links;
    mod bigger;
    mod coats;
    mod directions;
    mod even;
    mod export;
    mod fields;
    mod generators;
    mod heights;
    mod house;
    mod inspect;
    mod islands;
    mod joined;
    mod lessons;
    mod line_cells;
    mod lines;
    mod links;
    mod live;
    mod making;
    mod making_planes;
    mod maps;
    mod mesh_sizes;
    mod metrics;
    mod model_files;
    mod models;
    mod notices;
    mod outline_rings;
    mod outlines;
    mod overlays;
    mod packing;
    mod physics;
    mod pipeline;
    mod plain_words;
    mod recipes;
    mod samples;
    mod saved;
    mod scattered;
    mod scene;
    mod scene_cases;
    mod scene_light;
    mod scene_materials;
    mod scene_planes;
    mod scene_rays;
    mod shading;
    mod skin_recipes;
    mod skins;
    mod stones;
    mod studio;
    mod tiles;
    mod views;
    mod weather;
}
