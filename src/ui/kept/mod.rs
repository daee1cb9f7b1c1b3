//! The page of what is kept on this machine: what, since when, how much; to be saved as files, or deleted. A saved file is
//! opened here, too, by whatever means a person has. The page itself is a frame: the list is drawn by the program that
//! keeps (`view/list`), with its own words, so that the first view does not carry them.

pub mod words;
#[cfg(target_arch = "wasm32")]
pub mod view;
