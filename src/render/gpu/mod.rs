//! The GPU; wasm only. `canvas` is the one file that knows it and is linked by the program `renderer` and by tests
//! alone; the page knows `link`, which loads that program.

mod canvas;
pub mod link;

pub use canvas::{Backend, Gpu, GpuError, read_back};
