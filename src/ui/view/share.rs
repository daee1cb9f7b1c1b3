//! The link that was made, and what was wrong with the one that the page was opened by.

use super::sign::{Sign, sign};
use crate::ui::share::Sharing;
use crate::ui::{Action, State};
use yew::{Callback, Html, html};

/// What there is to say about sharing.
pub(super) fn shared(state: &State, act: &Callback<Action>) -> Html {
    let text = state.text();
    let Sharing { made, notice } = &state.sharing;
    if made.is_none() && notice.is_none() {
        return Html::default();
    }
    html! {
        <section class="card shared" aria-label={text.share} data-testid="shared">
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
                    onclick={act.reform(|_| Action::SaveSession)}>{ text.save_as_file }</button>
            </p>
        </section>
    }
}
