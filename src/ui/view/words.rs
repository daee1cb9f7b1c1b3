//! The page's words for every component, by context.

use crate::ui::text::{Language, Text};
use yew::{hook, use_context};

/// The words in the language of the page.
#[hook]
pub(super) fn use_text() -> &'static Text {
    use_context::<Language>().unwrap_or_default().text()
}
