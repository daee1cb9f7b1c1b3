//! Studies: the tasks that people are asked to put into words, the pairs of states that show them, and what comes of
//! asking. A study is one file (`file`), drawn from tasks or from a corpus (`make`). Whoever takes part comes by a link
//! (`link`), is asked some of it (`plan`), and leaves notes (`journal`) that become answers (`answer`), which go where
//! the study says and nowhere else (`ends`). Answers are read (`gather`), merged (`merge`), judged by a model (`judge`), flagged
//! (`flags`), decided, counted (`review`, `coverage`, `pay`) and written (`export`). Others' files become the same
//! (`survey`). All of it is pure: the pages bring the clock, the store and the network.

pub mod tasks;
pub mod pairs;
mod runs;
mod world;
pub mod url;
pub mod showing;
pub mod file;
pub mod make;
pub mod plan;
pub mod link;
pub mod ends;
pub mod answer;
pub mod journal;
pub mod gather;
pub mod merge;
pub mod judge;
mod tongue;
pub mod flags;
pub mod coverage;
pub mod review;
pub mod pay;
pub mod export;
pub mod survey;
pub mod rehearse;

pub use answer::{Answer, Care};
pub use file::{End, Item, Study, StudyError};
pub use flags::{Flag, flags};
pub use link::Link;
pub use merge::{Merged, merge};
pub use pairs::{DrawError, Drawing, Drawn, draw};
pub use review::{Review, Row};
pub use showing::Showing;
pub use tasks::{Look, Paint, Saying, StudyTask, TASKS, TaskFileError, read_tasks};
