//! The frame of the list, and the button that opens a saved file.

use crate::ui::page::files::Offered;
use crate::ui::page::shared::Shared;
use crate::ui::page::view::files::open_file;
use crate::ui::page::view::keeper::LIST;
use crate::ui::page::words::Text;
use yew::{Callback, Html, html};

/// The whole page.
pub(crate) fn kept(shared: &Shared, offer: &Callback<Vec<Offered>>) -> Html {
    let text = Text::of(shared.language);
    html! {
        <main class="columns single">
            <section class="card" aria-label={text.what_is_kept}>
                <div id={LIST} />
                { open_file("session-file", text.open_saved, ".json,.model,.csv,.jsonl", None, offer) }
            </section>
        </main>
    }
}
