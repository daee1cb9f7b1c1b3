//! The page as it stands: the room with the command, what is to be set up beside it, and the bar with the stop below.

use super::bar::bar;
use super::dry::{drive, dry};
use super::place::place;
use super::room::room;
use super::setup::robot;
use crate::robot::Stage;
use crate::ui::page::language::Language;
use crate::ui::page::view::sends::sends;
use crate::ui::page::view::stopped::stopped;
use crate::ui::robot::action::Action;
use crate::ui::robot::state::{Link, State};
use crate::ui::robot::words::Text;
use yew::{Callback, Html, html};

/// The whole page.
pub(super) fn page(state: &State, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let other = match state.language {
        Language::English => Language::German,
        Language::German => Language::English,
    };
    html! {
        <div class="drive" data-stage={stage(&state.pilot.driver.stage)} data-link={link(state.link)}>
            <header>
                <span class="name">{ "Groundling" }</span>
                <nav>
                    <a href="./">{ text.front }</a>
                    <a href="guide/robot.md">{ text.guide }</a>
                    <button type="button" class="link" lang={other.code()} data-testid="language"
                        onclick={sends(act, Action::Speak(other))}>{ text.other_language }</button>
                </nav>
            </header>
            <main>
                <h1>{ text.title }</h1>
                <p class="dim">{ text.intro }</p>
                { stopped(state.language, &state.talker, &act.reform(|_| Action::Restart)) }
                <div class="columns">
                    { room(state, act) }
                    <div class="steps">
                        { robot(state, act) }
                        { place(state, act) }
                        { dry(state, act) }
                        { drive(state, act) }
                    </div>
                </div>
            </main>
            { bar(state, act) }
            <p role="status" class="unseen" data-testid="announcement">{ &state.announcement }</p>
        </div>
    }
}

/// What a stage is called in the page's code.
pub(super) const fn stage(stage: &Stage) -> &'static str {
    match stage {
        Stage::Off => "off",
        Stage::Trying(_) => "trying",
        Stage::Ready => "ready",
        Stage::Driving => "driving",
        Stage::Halted(_) => "halted",
    }
}

/// What a link is called there.
const fn link(link: Link) -> &'static str {
    match link {
        Link::Off => "off",
        Link::Opening(_) => "opening",
        Link::Open => "open",
        Link::Lost(_) => "lost",
    }
}
