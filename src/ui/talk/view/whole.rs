//! The whole Talk page: one column at heart, with the room, what was understood and the command box; and what lies
//! beside it, as deep as the person wants to look.
use super::answer::answer;
use super::command::{command, examples};
use super::past::past;
use super::planner::planner;
use super::readings::readings;
use super::room::room;
use super::rules::rules;
use super::share::sharing;
use super::stage::cells;
use super::study::study;
use super::teach::lessons;
use crate::ui::page::preferences::Depth;
use crate::ui::page::shared::Shared;
use crate::ui::talk::action::Action;
use crate::ui::talk::room::state::Mode;
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use yew::{Callback, Html, html};

/// The view in which one talks to the robot, as deep as the person wants to look.
pub(crate) fn talk(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let watched = shared.depth >= Depth::See && state.room.mode == Mode::Watch;
    html! {
        <main class="talk" data-depth={format!("{:?}", shared.depth).to_ascii_lowercase()}>
            { sharing(state, shared, act) }
            <div class="card heart">
                { room(state, shared, act) }
                <section class="command" aria-label={Text::of(shared.language).tell}>
                    { answer(state, shared, act) }
                    { command(state, shared, act) }
                    { examples(state, shared, act) }
                </section>
                { cells(state, shared) }
            </div>
            <div class="column side">
                { lessons(state, shared, act) }
                { past(state, shared, act) }
                if watched {
                    { readings(state, shared, act) }
                    { planner(state, shared, act) }
                    { rules(shared, act) }
                }
            </div>
            if shared.depth == Depth::Study { { study(state, shared, act) } }
        </main>
    }
}
