//! The frame of the list, and the button that opens a saved file.

use crate::ui::page::files::{Given, Offered, given};
use crate::ui::page::shared::Shared;
use crate::ui::page::view::files::open_file;
use crate::ui::page::view::keeper::LIST;
use crate::ui::page::words::Text;
use yew::{Callback, Html, html};

/// The whole page.
pub(crate) fn kept(shared: &Shared, give: &Callback<Given>) -> Html {
    let text = Text::of(shared.language);
    let give = give.clone();
    let offer = Callback::from(move |files: Vec<Offered>| {
        for Offered { name, bytes } in files {
            let given = bytes.and_then(|bytes| given(&name, bytes)).ok().flatten();
            // What is none is told as a session that cannot be read.
            give.emit(given.unwrap_or_else(|| Given::Session(String::new())));
        }
    });
    html! {
        <main class="columns single">
            <section class="card" aria-label={text.what_is_kept}>
                <div id={LIST} />
                { open_file("session-file", text.open_saved, ".json,.model", None, &offer) }
            </section>
        </main>
    }
}
