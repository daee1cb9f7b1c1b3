//! Teaching: what is shown and said, what it added, and the list of what was taught.
use crate::ui::page::document::Draft;
use crate::ui::page::preferences::Depth;
use crate::ui::page::shared::Shared;
use crate::ui::page::view::notice::notice;
use crate::ui::page::view::sends::sends;
use crate::ui::page::way::rooms;
use crate::ui::talk::action::Action;
use crate::ui::talk::state::State;
use crate::ui::talk::teach::learn::{is_begun, is_teaching};
use crate::ui::talk::teach::unlike::{Unlike, driven};
use crate::ui::talk::words::Text;
use crate::worker::protocol::{Fit, Lesson, Meaning};
use web_sys::{HtmlInputElement, SubmitEvent};
use yew::{Callback, Html, InputEvent, TargetCast, html};

/// The lesson in preparation.
#[inline(never)] // It comes late: www/split.mjs.
pub(super) fn lesson(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let teach = &state.teach;
    let draft = shared.document.draft.as_ref();
    let shows = draft.is_some_and(Draft::shows);
    let busy = is_teaching(shared);
    let send = act.reform(|event: SubmitEvent| {
        event.prevent_default();
        Action::Teach
    });
    let typed = act.reform(|event: InputEvent| {
        let input = event.target_dyn_into::<HtmlInputElement>();
        Action::TypedLesson(input.map(|i| i.value()).unwrap_or_default())
    });
    html! {
        <div class="lesson">
            <ol class="steps">
                <li class={shows.then_some("done")}>
                    { text.show_it }
                    {" "}<button type="button" class="link" disabled={!draft.is_some_and(is_begun)} data-testid="clear-draft"
                        onclick={sends(act, Action::ClearDraft)}>{ text.show_again }</button>
                    { for draft.map(|draft| way(state, draft, text, act)) }
                </li>
                <li>
                    <label for="lesson">{ text.say_it }</label>
                    <form class="say" onsubmit={send}>
                        <input id="lesson" type="text" lang="en" autocomplete="off" autocapitalize="off"
                            spellcheck="false" data-testid="lesson" value={teach.words.clone()} oninput={typed} />
                        <button type="submit" class="primary" data-testid="teach" disabled={shared.document.base.is_none() || busy}>
                            { if busy { text.learning } else { text.teach } }
                        </button>
                    </form>
                </li>
            </ol>
            if let Some(missing) = teach.missing {
                <p class="notice" role="alert" data-testid="missing">{ text.missing(missing) }</p>
            }
            { not_taught(state, shared, act) }
        </div>
    }
}

/// What is said of the way that is driven, and the ways that are not meant.
fn way(state: &State, draft: &Draft, text: &'static Text, act: &Callback<Action>) -> Html {
    let unlike = |which, id: &'static str| {
        html! {
            <button type="button" class="quiet" data-testid={id} onclick={sends(act, Action::Unlike(which))}>{ text.unlike }</button>
        }
    };
    let rooms = |way: &String| rooms(&draft.before, way, text.phrases);
    html! {
        <>
            if driven(draft).is_some() {
                <p class="dim">{ text.way_counts }{" "}{ unlike(Unlike::Driven, "unlike") }</p>
            }
            if let Some(straight) = &state.teach.straight {
                <p data-testid="straight">{ (text.straight)(&rooms(straight)) }{" "}{ unlike(Unlike::Straight, "unlike-straight") }</p>
            }
            { for draft.contrasts.iter().map(|way| html! {
                <p class="dim" data-testid="contrast">{ (text.unlike_this)(&rooms(way)) }</p>
            }) }
        </>
    }
}

/// What came of the last lesson when it was not learned, with the readings to choose from that fit what was shown.
pub(super) fn not_taught(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let fits = state.teach.offer.as_ref().map_or(&[][..], |offer| &offer.fits);
    let notice = state.teach.notice.as_deref();
    if fits.is_empty() && notice.is_none() {
        Html::default()
    } else {
        refused(notice, fits, shared, act)
    }
}

#[inline(never)] // It comes late: www/split.mjs.
fn refused(told: Option<&str>, fits: &[Fit], shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    html! {
        <>
            { notice(told, "teach-notice") }
            if !fits.is_empty() {
                <p class="buttons">
                    { for fits.iter().enumerate().map(|(place, fit)| html! {
                        <button type="button" class="quiet" data-testid="fit"
                            onclick={sends(act, Action::TeachFit(place))}>{ text.phrases.sentence(&fit.claim) }</button>
                    }) }
                </p>
            }
        </>
    }
}

/// What was taught, and what the last lesson added to the lexicon.
pub(super) fn lessons(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    if shared.document.lessons.is_empty() { Html::default() } else { taught(state, shared, act) }
}

#[inline(never)] // It comes late: www/split.mjs.
fn taught(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let (lessons, teach) = (&shared.document.lessons, &state.teach);
    let added = teach.report.as_ref().map_or(&[][..], |report| &report.added);
    html! {
        <section class="card" aria-labelledby="lessons-title" data-testid="lessons">
            <div class="card-head">
                <h2 id="lessons-title">{ text.lessons }</h2>
                <button type="button" class="quiet" data-testid="save-lessons"
                    onclick={sends(act, Action::SaveLessons)}>{ text.save_lessons }</button>
            </div>
            <ul class="lessons">
                { for lessons.iter().enumerate().map(|(place, taught)| {
                    let command = taught.lesson.command.clone();
                    html! {
                        <li>
                            <button type="button" class="link" lang="en" data-testid="lesson-try"
                                onclick={sends(act, Action::AskExample(command.clone()))}>
                                { &taught.lesson.command }
                            </button>
                            if let Some(Meaning::Words(words)) = &taught.lesson.means {
                                <span class="dim" lang="en" data-testid="lesson-means">{ words }</span>
                            }
                            if !taught.understood { <span class="dim">{ text.not_understood }</span> }
                            <button type="button" class="link" data-testid="unteach"
                                aria-label={(text.forget_lesson)(&taught.lesson.command)}
                                onclick={sends(act, Action::Unteach(place))}>{ text.forget }</button>
                        </li>
                    }
                }) }
            </ul>
            if let Some(Lesson { command, means, .. }) = &teach.taught {
                <p class="dim" data-testid="learned">
                    { if means.is_some() { (text.now_means)(command) } else { (text.it_learned)(command, added.len()) } }
                </p>
                if teach.report.as_ref().is_some_and(|report| report.by_end) {
                    <p class="dim" data-testid="by-end">{ text.by_end }</p>
                }
                <ul class="told">
                    { for teach.report.iter().flat_map(|report| &report.told).map(|told| html! {
                        <li data-testid="told">{ text.told(told) }</li>
                    }) }
                </ul>
                if !added.is_empty() && shared.depth == Depth::Study {
                    <div class="scroll" tabindex="0" role="group" aria-label={text.entries}>
                        <table class="entries">
                            <thead><tr><th>{ text.words }</th><th>{ text.category }</th><th>{ text.meaning }</th></tr></thead>
                            <tbody>
                                { for added.iter().map(|entry| html! {
                                    <tr data-testid="added"><td lang="en">{ &entry.words }</td>
                                        <td><code>{ &entry.syntax }</code></td><td><code>{ &entry.meaning }</code></td></tr>
                                }) }
                            </tbody>
                        </table>
                    </div>
                }
            }
        </section>
    }
}
