//! What all pages share and are lent as [`shared::Shared`]: the document and its history, the engines, the model,
//! files, the language with its grammar, and what is wanted of the browser. It knows no page.

pub mod place;
pub mod language;
pub mod grammar;
pub mod way;
pub mod preferences;
pub mod world;
pub mod document;
pub mod history;
pub mod keep;
pub mod files;
pub mod news;
pub mod effect;
pub mod engine;
pub mod words;
pub mod engines;
pub mod coming;
pub mod shared;
pub mod resource;
pub mod model;
#[cfg(target_arch = "wasm32")]
pub mod view;
