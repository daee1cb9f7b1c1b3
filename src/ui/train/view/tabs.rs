//! The parts of the workbench as tabs: the arrow keys go from one to the next.

use crate::ui::page::language::Language;
use crate::ui::page::view::host;
use crate::ui::train::action::Tab;
use crate::ui::train::words::Text;
use web_sys::KeyboardEvent;
use yew::{Callback, Html, html};

/// The tabs, of which one is open.
pub(super) fn tabs(language: Language, open: Tab, turn: &Callback<Tab>) -> Html {
    let text = Text::of(language);
    let pressed = {
        let turn = turn.clone();
        Callback::from(move |event: KeyboardEvent| {
            let step = match event.key().as_str() {
                "ArrowRight" => 1,
                "ArrowLeft" => Tab::ALL.len() - 1,
                _ => return,
            };
            let at = Tab::ALL.iter().position(|tab| *tab == open).unwrap_or(0);
            if let Some(to) = Tab::ALL.get((at + step) % Tab::ALL.len()) {
                turn.emit(*to);
                host::focus(&format!("tab-{}", to.name()));
            }
        })
    };
    html! {
        <div class="tabs" role="tablist" aria-label={text.parts} onkeydown={pressed}>
            { for Tab::ALL.into_iter().map(|tab| {
                let id = format!("tab-{}", tab.name());
                let is_open = tab == open;
                html! {
                    <button type="button" role="tab" id={id.clone()} data-testid={id} aria-controls="part"
                        aria-selected={is_open.to_string()} tabindex={if is_open { "0" } else { "-1" }}
                        onclick={turn.reform(move |_| tab)}>{ (text.tab)(tab) }</button>
                }
            }) }
        </div>
    }
}
