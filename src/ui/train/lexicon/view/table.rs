//! A table that is scrolled sideways where it is too wide.

use yew::{Html, html};

/// A table with its name, its heads, and its rows.
pub(super) fn table(name: &str, heads: &[&'static str], rows: Vec<Html>) -> Html {
    if rows.is_empty() {
        return Html::default();
    }
    html! {
        <>
            <h3>{ name }</h3>
            <div class="scroll" tabindex="0" role="region" aria-label={name.to_owned()}>
                <table class="figures">
                    <thead><tr>{ for heads.iter().map(|head| html! { <th scope="col">{ *head }</th> }) }</tr></thead>
                    <tbody>{ for rows }</tbody>
                </table>
            </div>
        </>
    }
}
