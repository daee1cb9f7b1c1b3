//! The list of what is kept, with what can be done with each.

use crate::ui::kept::action::Action;
use crate::ui::kept::words::Text;
use crate::ui::page::keep::ask::Place;
use crate::ui::page::keep::copies::Item;
use crate::ui::page::shared::Shared;
use crate::ui::page::view::files::open_file;
use crate::ui::page::view::notice::notice;
use crate::ui::page::words::Text as Common;
use js_sys::{Date, Object};
use yew::{Callback, Html, html};

/// The whole page.
pub(crate) fn kept(shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let fault = shared.keep.fault.as_ref().map(Common::of(shared.language).fault);
    let items = shared.keep.items.as_deref();
    html! {
        <main class="columns single">
            <section class="card" aria-labelledby="kept-title">
                <h2 id="kept-title">{ text.title }</h2>
                <p>{ text.about }</p>
                { notice(fault.as_deref(), "kept-fault") }
                { match items {
                    None => html! { <p>{ text.unread }</p> },
                    Some([]) => html! { <p data-testid="nothing-kept">{ text.nothing }</p> },
                    Some(items) => html! { <>
                        <div class="scroll" tabindex="0" role="group" aria-label={text.title}>
                            <table class="entries">
                                <thead><tr><th>{ text.what }</th><th>{ text.when }</th><th>{ text.size }</th><td></td></tr></thead>
                                <tbody>{ for items.iter().map(|item| row(shared, item, act)) }</tbody>
                            </table>
                        </div>
                        <p class="buttons">
                            <button type="button" class="quiet" data-testid="delete-all"
                                onclick={act.reform(|_| Action::DeleteAll)}>{ text.delete_all }</button>
                        </p>
                    </> },
                } }
                { open_file("session-file", text.open_file, ".json,.model,.csv,.jsonl", Some(text.open_help),
                    &act.reform(Action::Offered)) }
            </section>
        </main>
    }
}

fn row(shared: &Shared, item: &Item, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let Item { kind, name, bytes, at } = item;
    let what = text.item(kind, name);
    let when = Date::new(&(*at).into()).to_locale_string(shared.language.code(), &Object::new());
    let (saved, gone) = (Place::new(kind, name), Place::new(kind, name));
    html! {
        <tr data-testid="kept-item">
            <td>{ &what }</td>
            <td>{ String::from(when) }</td>
            <td>{ format!("{} KB", bytes.div_ceil(1000)) }</td>
            <td>
                <button type="button" class="link" data-testid="export" aria-label={(text.save_this)(&what)}
                    onclick={act.reform(move |_| Action::Export(saved.clone()))}>{ text.save }</button>{" "}
                <button type="button" class="link" data-testid="delete" aria-label={(text.delete_this)(&what)}
                    onclick={act.reform(move |_| Action::Delete(gone.clone()))}>{ text.delete }</button>
            </td>
        </tr>
    }
}
