//! The page. Everything it decides is the pure [`app::reduce`]: an [`app::Action`] changes the [`app::State`] and
//! yields effects, which are data; the views (wasm only) draw the state and carry the effects out. What all pages share
//! is `page`; every page has a folder with its own state, actions, words and views, and knows no other; `app` alone
//! knows them all.
//!
//! One command, typed, parsed, planned and played, goes through these files, and comes back to none but `app`. What is
//! asked on the way (`page`, a state, words, values) answers, and hands nothing on.
//!
//! 1. `talk/view/command`: a person types and sends it; each is an action.
//! 2. `app/update`: gives an action to the page that it is of.
//! 3. `talk/update`: gives it to the part that does such.
//! 4. `talk/command/ask`: sends a request to the engine, to read what is typed or to answer what is sent.
//! 5. `app/view/effects`: carries it to the worker, which parses and plans, and brings what the worker says.
//! 6. `app/hear`: gives an answer to the page that asked.
//! 7. `talk/hear`: gives it to the part that asked.
//! 8. `talk/command/answer`: that was said, in the document; its plan begins to play, for a timer to ring.
//! 9. `talk/why/messages`: what there is to say about it.
//! 10. `talk/watch/play`: takes a step whenever `app/update` is told that the timer rang, to the end of the plan.

pub mod page;
pub mod talk;
pub mod train;
pub mod kept;
pub mod help;
pub mod collect;
pub mod robot;
pub mod app;
