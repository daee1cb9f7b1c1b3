//! Pictures of a world: a pure scene (state → quads in cells), its motion between two states, the same world
//! as a grid of cells for those who do not see the picture, and one file that knows the GPU.
//!
//! The page builds a [`Scene`] and hands it through `link` to the renderer, a wasm module of its own that is
//! loaded when the first picture is wanted; nothing but `gpu` and the program `renderer` links the GPU.

pub mod palette;
pub mod floor;
pub mod quad;
pub mod options;
pub mod walls;
pub mod pose;
mod overlay;
mod things;
pub mod scene;
pub mod motion;
pub mod grid;
#[cfg(target_arch = "wasm32")]
pub mod gpu;

pub use floor::{Extent, Floor, Ground};
#[cfg(target_arch = "wasm32")]
pub use gpu::link;
pub use grid::{Cell, Grid};
pub use motion::Motion;
pub use options::{Arrow, Ghost, Options, Spread, Thing, spread};
pub use palette::{Rgba, Theme};
pub use pose::Pose;
pub use quad::{Figure, Quad};
pub use scene::{Fit, Scene};
