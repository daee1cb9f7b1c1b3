//! A notice beside what it is about.

use yew::{Html, html};

/// A message where the person is looking; nothing when there is none.
pub(crate) fn notice(text: Option<&str>, id: &'static str) -> Html {
    let Some(text) = text else { return Html::default() };
    html! { <p class="notice" role="alert" data-testid={id}>{ text }</p> }
}
