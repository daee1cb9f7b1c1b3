//! The link that was made, and what was wrong with the one that the page was opened by.
use crate::ui::page::shared::Shared;
use crate::ui::page::view::sends::sends;
use crate::ui::page::view::sign::{Sign, sign};
use crate::ui::page::words::Text as Common;
use crate::ui::talk::action::Action;
use crate::ui::talk::share::state::Sharing;
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use yew::{Callback, Html, html};

/// What there is to say about sharing.
pub(super) fn sharing(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let Sharing { made, notice } = &state.sharing;
    if made.is_none() && notice.is_none() {
        Html::default()
    } else {
        told(&state.sharing, shared, act)
    }
}

#[inline(never)] // It comes late: www/split.mjs.
fn told(sharing: &Sharing, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let Sharing { made, notice } = sharing;
    html! {
        <section class="card shared" aria-label={Common::of(shared.language).share} data-testid="shared">
            <div class="card-head">
                { match (made, notice) {
                    (Some(Ok(link)), _) => html! {
                        <p><strong>{ if link.copied { text.link_copied } else { text.link_made } }</strong>{" "}{ text.link_help }</p>
                    },
                    (Some(Err(why)), _) => html! { <p role="alert">{ why }</p> },
                    (None, Some(notice)) => html! { <p role="alert" data-testid="link-notice">{ notice }</p> },
                    (None, None) => Html::default(),
                } }
                { sign("close-share", text.close, Sign::Close, false, act.reform(|()| Action::CloseShare)) }
            </div>
            if let Some(Ok(link)) = made {
                <input type="text" class="address" readonly=true aria-label={text.link} value={link.address.clone()}
                    data-testid="link" />
            }
            <p class="buttons">
                <button type="button" class="quiet" data-testid="save-session"
                    onclick={sends(act, Action::SaveSession)}>{ text.save_as_file }</button>
            </p>
        </section>
    }
}
