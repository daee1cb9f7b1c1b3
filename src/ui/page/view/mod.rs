//! What the views of all pages are made of; wasm only. Views are functions of the state that send actions; only what
//! has something of its own to remember (a canvas, what is folded open) is a component, since each costs what every
//! visitor loads.

pub mod host;
pub mod drawn;
pub mod save;
pub mod worker;
pub mod stopped;
pub mod files;
pub mod sends;
pub mod sign;
pub mod select;
pub mod fields;
pub mod notice;
pub mod sketch;
pub mod picture;
pub mod store;
pub mod journal;
pub mod patience;
pub mod claim;
pub mod module;
pub mod forms;
pub mod packed;
pub mod keeper;
pub mod foot;
