//! The engine behind the page: one protocol, one job, pumped by the page's worker, the command line and tests alike.

pub mod protocol;
