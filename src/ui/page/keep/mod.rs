//! What the page keeps on this machine, in one store of named texts. `copies` says how one text is kept twice with a
//! checksum, `fault` what can go wrong, `ask` what is wanted of the store and what it says, `state` how it stands. The
//! store itself is IndexedDB (`view/store`), in a program of its own (`bin/keeper`) that comes after the page. It knows
//! nothing of what the texts are: another page keeps its own under another kind.

pub mod copies;
pub mod fault;
pub mod ask;
pub mod state;
