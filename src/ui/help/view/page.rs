//! The whole page: the guide's text, which comes with the site, and why there is none.

use crate::domain::State as World;
use crate::ui::help::guide::filled;
use crate::ui::help::state::State;
use crate::ui::page::view::notice::notice;
use yew::{Html, html};

/// The guide for a world.
pub(crate) fn help(state: &State, world: &World) -> Html {
    let (text, wrong) = match &state.text {
        Some(Ok(text)) => (&**text, None),
        Some(Err(why)) => ("", Some(&**why)),
        None => ("", None),
    };
    html! {
        <main class="columns single">
            <section class="card guide" data-testid="guide">
                { notice(wrong, "guide-notice") }
                { Html::from_html_unchecked(filled(text, world).into()) }
            </section>
        </main>
    }
}
