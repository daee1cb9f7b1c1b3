//! What there is to say of the session: where it came from, and why it is not kept; each with what can be done.
use crate::ui::app::action::Action;
use crate::ui::page::keep::fault::Fault;
use crate::ui::page::keep::state::{Keep, Origin};
use crate::ui::page::shared::Shared;
use crate::ui::page::view::sends::sends;
use crate::ui::page::view::sign::{Sign, sign};
use crate::ui::page::words::Text;
use yew::{Callback, Html, html};

/// What there is to say of the session; nothing as long as all is as usual.
pub(super) fn kept(shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let Keep { origin, fault, .. } = &shared.keep;
    let press = |id: &'static str, words: &'static str, action: Action| {
        let press = sends(act, action);
        html! { <button type="button" class="link" data-testid={id} onclick={press}>{ words }</button> }
    };
    html! {
        <>
            if let Some(origin) = *origin {
                <p class="session" role="status" data-testid="resumed" data-origin={format!("{origin:?}")}>
                    <span>{ text.origins[origin as usize] }</span>{" "}
                    { match origin {
                        Origin::Last | Origin::Before => press("afresh", text.afresh, Action::Afresh),
                        Origin::Link | Origin::Left | Origin::New => press("go-back", text.go_back, Action::GoBack),
                    } }
                    { sign("close-origin", text.close, Sign::Close, false, act.reform(|()| Action::CloseOrigin)) }
                </p>
            }
            if let Some(fault) = fault {
                <p class="session" role="status" data-testid="not-kept" data-fault={fault.name().to_owned()}>
                    <span>{ (text.fault)(fault) }</span>{" "}
                    { match fault {
                        Fault::Elsewhere => press("keep-here", text.keep_here, Action::KeepHere),
                        _ => html! { <a href="#kept">{ text.what_is_kept }</a> },
                    } }
                </p>
            }
        </>
    }
}
