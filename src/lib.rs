//! Bubblestone packs squares, rectangles, circles or ellipses into any outline and turns the packing
//! into a pavement.
//!
//! The way of the data, one module each: a [`recipe`] names an outline ([`domain`]) and fields of
//! size and direction ([`field`]); particles pack it ([`packing`]); their centres become a [`mesh`],
//! the mesh [`cells`], each cell a stone ([`solid`]) of some [`material`]; stones are put into data
//! planes, and the planes are lit ([`heightfield`]). [`generators`] wire these stages together, and
//! [`studio`] runs any of them in small slices.
//!
//! It implements Miyata, Itoh, Shimada (2000), A Method of Generating Pavement Textures Using the
//! Square Packing Technique, and Miyata, Itoh, Shimada (2001), Generating Pavement Textures via
//! Close Packing of Squares; the dual cells are those of Itoh, Miyata, Shimada (2003), Generation
//! of Organic Textures with Controlled Anisotropy and Directionality via Packing Rectangular and
//! Elliptical Cells.
//!
//! Coordinates are picture units (pixels), x to the right and **y down**; angles are radians from +x
//! towards +y, clockwise on screen; rings of positive shoelace area run clockwise on screen. The
//! same recipe gives the same bits on every machine.
//!
//! ```
//! use bubblestone::generators;
//! use bubblestone::studio::Studio;
//!
//! let (recipe, notices) = generators::ALL.recipe("#v=1&size=128&cs=24");
//! assert!(notices.is_empty());
//! let mut studio = Studio::new(generators::ALL, recipe);
//! studio.finish(&mut || 0.0).unwrap();
//! assert_eq!(studio.digest().len(), 16);
//! ```

pub mod cells;
mod decimal;
pub mod domain;
pub mod draw;
pub mod export;
pub mod field;
pub mod generators;
mod graph;
pub mod heightfield;
pub mod material;
pub mod mesh;
pub mod metrics;
pub mod notice;
mod order;
pub mod packing;
mod planar;
pub mod random;
pub mod recipe;
pub mod solid;
pub mod studio;
#[cfg(target_arch = "wasm32")]
pub mod web;

// The measurements name this crate as the native program does.
#[cfg(all(feature = "bench", target_arch = "wasm32"))]
extern crate self as bubblestone;
#[cfg(all(feature = "bench", target_arch = "wasm32"))]
#[path = "../benches/suite.rs"]
mod suite;
