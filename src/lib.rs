//! Bubblestone packs squares, rectangles, circles or ellipses into any outline and turns the packing
//! into a pavement or a hide. It also covers bodies in space with cells, and heaps things on them.
//!
//! # From a link to a picture
//!
//! The work goes in stages. Each stage is a module that knows nothing of links, browsers or time, and uses only the
//! modules of the stages before it:
//!
//! 1. [`domain`] is the outline, checked, with islands, holes, constraint lines and distances.
//! 2. [`field`] gives size, direction, aspect ratio and kind of the cells at every point of the outline.
//! 3. [`packing`] places particles and moves them by the forces between them until they rest.
//! 4. [`mesh`] joins the particles' centres by triangles and quadrilaterals.
//! 5. [`cells`] makes a polygon around each centre, the dual of that mesh, fitted into the outline.
//! 6. [`solid`] builds a stone or a scale on each cell, of some [`material`].
//! 7. [`heightfield`] puts these solids into planes of height, colour and material, lets the weather
//!    go over them, and puts them in the [`light`].
//!
//! Cells on bodies in space go the same way, on a triangle mesh: `shapes` or `modelfiles` give its
//! triangles, `trimesh` is the mesh, and `surface_field`, `surface_packing`, `surface_cells` and
//! `surface_stones` do there what the folders without `surface_` do in the plane.
//!
//! Piles are made of things that lie on a shape:
//!
//! 1. `component` makes the things: closed meshes with variants, finishes and inner spheres.
//! 2. `pile_shape` makes shapes and vessels to heap them on or in; those of `shapes` and `modelfiles` serve as well.
//! 3. `pile` throws darts on the shape, turns a body at each, and lets one after the other slide until it only touches
//!    those that have settled.
//!
//! `building` is the model that masonry is laid on: faces, edges and corners over polygons, with their surfaces in
//! closed form (Legakis, Dorsey, Gortler 2001). `masonry` lays bricks and stones on it, as trees of patterns say.
//!
//! `scene` shows all bodies in space, with their light and shadows.
//!
//! [`draw`] shows what the stages have made, [`metrics`] measures it, and [`export`] writes it to files.
//!
//! # What is asked for, and what runs it
//!
//! A [`recipe`] is a checked value for every parameter, and its link. A generator
//! ([`generators`]) is a schema of parameters, presets, and an engine, which wires the stages together;
//! [`generators::ALL`] lists all generators. A [`studio`] runs the engine of a recipe in small slices.
//! A [`notice`] is a message for people, in any language. Random numbers come from [`random`] alone.
//!
//! ```
//! use bubblestone::generators;
//! use bubblestone::studio::Studio;
//!
//! let (recipe, notices) = generators::ALL.recipe("#v=1&size=128&cs=24");
//! assert!(notices.is_empty());
//! let mut studio = Studio::new(generators::ALL, recipe);
//! studio.finish(&mut || 0.0).expect("a ring has room for cells");
//! let rgba = studio.picture().expect("the picture is finished");
//! assert_eq!(rgba.len(), 4 * 128 * 128);
//! ```
//!
//! # Conventions
//!
//! Coordinates are picture units (pixels), x to the right and **y down**; angles are radians from +x
//! towards +y, clockwise on screen; rings of positive shoelace area run clockwise on screen. The
//! same recipe gives the same bits on every machine: geometry is f64, planes are f32, transcendental
//! functions come from `libm`, sorting has tie-breaks, and clocks only measure.
//!
//! # Papers
//!
//! Miyata, Itoh, Shimada (2000), A Method of Generating Pavement Textures Using the Square Packing
//! Technique; Miyata, Itoh, Shimada (2001), Generating Pavement Textures via Close Packing of Squares
//! (in Japanese); Itoh, Miyata, Shimada (2003), Generation of Organic Textures with Controlled
//! Anisotropy and Directionality via Packing Rectangular and Elliptical Cells; Sakurai, Miyata (2014),
//! Modelling of Non-Periodic Aggregates Having a Pile Structure; Legakis, Dorsey, Gortler (2001), Feature-Based
//! Cellular Texturing for Architectural Models. Each module names the sections and
//! equations that it implements.

#[cfg(house)]
pub mod building;
pub mod cells;
#[cfg(house)]
pub mod component;
mod csr;
mod decimal;
pub mod domain;
pub mod draw;
pub mod export;
pub mod field;
pub mod generators;
mod graph;
mod hash;
pub mod heightfield;
pub mod light;
#[cfg(house)]
pub mod masonry;
pub mod material;
pub mod mesh;
pub mod metrics;
#[cfg(house)]
pub mod modelfiles;
pub mod notice;
mod order;
pub mod packing;
#[cfg(house)]
pub mod pile;
#[cfg(house)]
pub mod pile_shape;
mod planar;
pub mod random;
pub mod recipe;
#[cfg(house)]
pub mod scene;
#[cfg(house)]
pub mod shapes;
pub mod solid;
pub mod studio;
#[cfg(house)]
pub mod surface_cells;
#[cfg(house)]
pub mod surface_field;
#[cfg(house)]
pub mod surface_packing;
#[cfg(house)]
pub mod surface_stones;
#[cfg(house)]
pub mod surface_views;
#[cfg(house)]
pub mod trimesh;
#[cfg(target_arch = "wasm32")]
pub mod web;

// The measurements use this crate under its public name, as the native program does.
#[cfg(all(feature = "bench", target_arch = "wasm32"))]
extern crate self as bubblestone;
#[cfg(all(feature = "bench", target_arch = "wasm32"))]
#[path = "../benches/suite.rs"]
mod suite;
