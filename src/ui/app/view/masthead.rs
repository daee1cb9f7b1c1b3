//! The head of the page: its name, the views, how deep to look, undo, share, language.
use crate::ui::app::action::{Action, View};
use crate::ui::app::state::State;
use crate::ui::app::words::Text;
use crate::ui::page::language::Language;
use crate::ui::page::preferences::Depth;
use crate::ui::page::shared::Shared;
use crate::ui::page::view::sends::sends;
use crate::ui::page::view::sign::{Sign, sign};
use crate::ui::page::words::Text as Common;
use crate::ui::talk;
use web_sys::{Event, HtmlSelectElement};
use yew::{Callback, Html, TargetCast, html};

/// Where the source is, if whoever builds the site says so.
const SOURCE: Option<&str> = option_env!("SOURCE_ADDRESS");

/// The head of the page.
pub(super) fn masthead(state: &State, act: &Callback<Action>) -> Html {
    let State { shared: Shared { depth, language, history, .. }, view, .. } = state;
    let text = Text::of(*language);
    let link = |to: View, words: &'static str, href: &'static str, id: &'static str| {
        let current = (to == *view).then_some("page");
        // The address may name this view already, when a file that was dropped led elsewhere.
        let go = sends(act, Action::Go(to));
        html! { <a {href} aria-current={current} data-testid={id} onclick={go}>{ words }</a> }
    };
    let speak = act.reform(|event: Event| {
        let chosen = event.target_dyn_into::<HtmlSelectElement>().map(|select| select.value());
        Action::Speak(chosen.and_then(|code| Language::of(&code)).unwrap_or_default())
    });
    html! {
        <header class="masthead">
            <div class="name">
                <h1>{"Groundling"}</h1>
            </div>
            <nav aria-label={text.views}>
                { link(View::Talk, text.talk, "#talk", "view-talk") }
                { link(View::Train, text.train, "#train", "view-train") }
                { link(View::Help, text.help, "#help", "view-help") }
            </nav>
            <div class="tools">
                if *view == View::Talk {
                    <div class="switch" role="group" aria-label={text.depth}>
                        { for Depth::ALL.into_iter().map(|to| html! {
                            <button type="button" aria-pressed={(to == *depth).to_string()}
                                title={text.depth_help(to)} data-testid={format!("depth-{to:?}").to_ascii_lowercase()}
                                onclick={sends(act, Action::Deepen(to))}>{ text.depth_name(to) }</button>
                        }) }
                    </div>
                    { sign("undo", text.undo, Sign::Undo, !history.can_undo(), act.reform(|()| Action::Undo)) }
                    { sign("redo", text.redo, Sign::Redo, !history.can_redo(), act.reform(|()| Action::Redo)) }
                    { sign("share", Common::of(*language).share, Sign::Share, false,
                        act.reform(|()| Action::Talk(talk::Action::Share))) }
                }
                <label class="unseen" for="language">{ text.language }</label>
                <select id="language" data-testid="language" onchange={speak}>
                    { for Language::ALL.into_iter().map(|one| html! {
                        <option value={one.code()} selected={one == *language} lang={one.code()}>
                            { one.name() }
                        </option>
                    }) }
                </select>
            </div>
            if *view == View::Talk {
                <p class="pitch">
                    { text.pitch }{" "}
                    // Together, so that a line does not end in the middle of them.
                    <span class="ways">
                        { for text.links.iter().map(|(words, href)| html! { <a href={*href}>{ words }</a> }) }
                        if let Some(source) = SOURCE { <a href={source}>{ text.source }</a> }
                    </span>
                </p>
            }
        </header>
    }
}
