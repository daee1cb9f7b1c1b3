//! What stands at the foot of every page: that all of it stays on this machine, and the way to what is kept there.

use crate::ui::page::language::Language;
use crate::ui::page::words::Text;
use yew::{Html, html};

/// The foot.
pub(crate) fn foot(language: Language) -> Html {
    let text = Text::of(language);
    html! {
        <footer class="foot">
            <p>{ text.stays_here }{" "}<a href="#kept" data-testid="view-kept">{ text.what_is_kept }</a></p>
        </footer>
    }
}
