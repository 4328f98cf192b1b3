//! What must hold of each stage and of all together. One file of them: `cargo test --test properties fields::`.

#[path = "../common/mod.rs"]
mod common;
#[path = "../paving/mod.rs"]
mod paving;

// Natively and in WebAssembly.
mod live;
mod metrics;
mod pipeline;
mod scattered;
#[cfg(target_arch = "wasm32")]
mod web;

/// What is the same bits in WebAssembly, as the digests say, or needs files.
#[cfg(not(target_arch = "wasm32"))]
mod native {
    mod bad_links;
    mod bigger;
    mod coats;
    mod even;
    mod export;
    mod fields;
    mod heights;
    mod house;
    mod inspect;
    mod islands;
    mod line_cells;
    mod lines;
    mod links;
    mod making;
    mod making_planes;
    mod maps;
    mod mesh_sizes;
    mod model_files;
    mod models;
    mod outline_rings;
    mod outlines;
    mod overlays;
    mod packing;
    mod plain_words;
    mod recipes;
    mod samples;
    mod scene;
    mod scene_cases;
    mod scene_light;
    mod scene_planes;
    mod scene_rays;
    mod shading;
    mod skin_recipes;
    mod skins;
    mod stones;
    mod tiles;
    mod views;
    mod weather;
}
