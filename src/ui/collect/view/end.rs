//! The ends of a study, what was not sent yet, and when it is over.

use super::item::button;
use super::start::paragraphs;
use crate::study::End;
use crate::study::ends::target;
use crate::study::url::Origin;
use crate::ui::collect::action::Action;
use crate::ui::collect::state::{Over, State};
use crate::ui::collect::words::Text;
use yew::{Callback, Html, html};

/// An end, by its place in the study.
pub(super) fn end(state: &State, at: usize, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let Some(((study, source), sitting)) = state.study.as_ref().zip(state.sitting.as_ref()) else {
        return Html::default();
    };
    let Some(end) = study.ends.get(at) else { return Html::default() };
    let address = match end {
        End::Return { url } => Some(url.clone()),
        end => target(study, *source, end, &state.link).ok().flatten(),
    };
    let host = address.and_then(|url| Origin::of(&url)).map_or(String::new(), |o| o.host());
    let ending = &state.ending;
    let save = || button("save-answers", "plain", text.save, act, Action::Save);
    let inner = match end {
        _ if state.is_preview() => html! {
            <>
                <p>{ text.end_preview }</p>
                <p class="buttons">{ button("end", "primary", text.next, act, Action::End) }</p>
            </>
        },
        _ if ending.refusal.is_some() => html! {
            <>
                <p class="notice bad" role="alert" data-testid="refusal">
                    { ending.refusal.as_ref().map(|refusal| (text.refusal)(refusal)) }
                </p>
                <p class="buttons">
                    { save() }
                    { button("ended", "quiet", text.file_sent, act, Action::Ended) }
                </p>
            </>
        },
        End::Endpoint { .. } => html! {
            if let Some(why) = ending.failed.as_ref().filter(|_| !ending.is_sending) {
                <p class="notice" role="alert" data-testid="outbox">{ (text.not_sent)(why, ending.tries) }</p>
                <p class="buttons">
                    { button("again", "primary", text.try_again, act, Action::Again) }
                    { save() }
                </p>
            } else {
                <p role="status" data-testid="sending">{ (text.sending)(&host) }</p>
            }
        },
        End::Form { .. } => html! {
            <>
                <p>{ (text.form)(&host) }</p>
                <p class="buttons">{ button("end", "primary", text.submit, act, Action::End) }</p>
            </>
        },
        End::Code => html! {
            <>
                <p>{ text.code }</p>
                <p class="code" data-testid="code">{ sitting.code(study) }</p>
                <p class="buttons">
                    { button("end", "plain", text.copy, act, Action::End) }
                    { button("ended", "primary", text.go_on, act, Action::Ended) }
                    <span role="status">{ if ending.is_done { text.copied } else { "" } }</span>
                </p>
            </>
        },
        End::File => html! {
            <>
                <p>{ text.file }</p>
                <p class="buttons">
                    { button("end", "primary", text.save, act, Action::End) }
                    if ending.is_done { { button("ended", "plain", text.file_sent, act, Action::Ended) } }
                </p>
            </>
        },
        End::Return { .. } => html! {
            <>
                <p>{ (text.back)(&host) }</p>
                <p class="buttons">{ button("end", "primary", text.go_back, act, Action::End) }</p>
            </>
        },
    };
    html! {
        <section class="card" aria-labelledby="heading">
            <h1 id="heading" tabindex="-1">{ text.end_title }</h1>
            { inner }
        </section>
    }
}

/// It is over.
pub(super) fn over(state: &State, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let thanks = state.study.as_ref().and_then(|(study, _)| study.words.thanks.as_deref());
    let inner = match &state.over {
        Some(Over::Withdrawn) => html! { <p data-testid="withdrawn">{ text.withdrawn }</p> },
        Some(Over::Done(code)) => html! {
            <>
                { for thanks.map(paragraphs) }
                if let Some(code) = code {
                    <p>{ text.over_code }</p>
                    <p class="code" data-testid="code">{ code }</p>
                }
                <p class="dim" data-testid="erased">{ text.erased }</p>
            </>
        },
        None => html! {
            <>
                <p class="notice" data-testid="outbox">{ text.over_form }</p>
                <p class="buttons">
                    { button("end", "plain", text.submit, act, Action::End) }
                    { button("ended", "quiet", text.delete, act, Action::Ended) }
                </p>
            </>
        },
    };
    let title = if state.over == Some(Over::Withdrawn) { text.withdraw } else { text.thanks };
    html! {
        <section class="card" aria-labelledby="heading" data-testid="over">
            <h1 id="heading" tabindex="-1">{ title }</h1>
            { inner }
        </section>
    }
}
