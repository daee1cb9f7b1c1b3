//! The list of what is kept, drawn into the page's frame, with what can be done with each. Linked by the program `keeper`
//! alone.

use crate::ui::kept::words::Text;
use crate::ui::page::keep::copies::Item;
use crate::ui::page::keep::fault::Fault;
use crate::ui::page::language::Language;
use crate::ui::page::view::journal::{Journal, KIND};
use crate::ui::page::view::save::save_bytes;
use crate::ui::page::view::store::Store;
use js_sys::{Date, Object};
use std::rc::Rc;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::Closure;
use wasm_bindgen_futures::spawn_local;
use web_sys::{Element, Event, HtmlElement};

/// Draws the list into an element, in a language.
///
/// # Errors
/// When the store is gone.
pub async fn show(store: Rc<Store>, into: HtmlElement, language: Language) -> Result<(), Fault> {
    draw(&store, &into, language, "").await?;
    let element = into.clone();
    let pressed = Closure::<dyn FnMut(Event)>::new(move |event: Event| {
        let Some(button) = event.target().and_then(|target| target.dyn_into::<Element>().ok())
        else {
            return;
        };
        let of = |name: &str| button.get_attribute(name).unwrap_or_default();
        let (does, kind, name) = (of("data-testid"), of("data-kind"), of("data-name"));
        let (store, element) = (store.clone(), element.clone());
        spawn_local(async move {
            // What went wrong with the store is told by the page when it next keeps something.
            let _ = act(&store, &element, language, (&does, &kind, &name)).await;
        });
    });
    into.set_onclick(Some(pressed.as_ref().unchecked_ref()));
    pressed.forget();
    Ok(())
}

/// Does what a button is for.
async fn act(
    store: &Store,
    into: &HtmlElement,
    language: Language,
    (does, kind, name): (&str, &str, &str),
) -> Result<(), Fault> {
    match does {
        "export" if kind == KIND => {
            let notes = Journal::open(|| ()).await?.notes(name).await?;
            let lines: String = notes.into_iter().map(|(_, note)| note + "\n").collect();
            let _ = save_bytes(&format!("{kind}-{name}.jsonl"), lines.as_bytes());
        }
        "export" => {
            if let Some((bytes, _)) = store.read(kind, name).await? {
                let end = match kind {
                    "session" | "run" | "experiment" | "robot" => "json",
                    "model" => "model",
                    _ => "txt",
                };
                let _ = save_bytes(&format!("{kind}-{name}.{end}"), &bytes);
            }
        }
        "delete" | "delete-all" => {
            match kind {
                KIND => Journal::open(|| ()).await?.erase(name, None).await?,
                "" => {
                    store.delete("", "").await?;
                    Journal::open(|| ()).await?.clear().await?;
                }
                _ => store.delete(kind, name).await?,
            }
            draw(store, into, language, Text::of(language).deleted).await?;
        }
        _ => {}
    }
    Ok(())
}

async fn draw(
    store: &Store,
    into: &HtmlElement,
    language: Language,
    said: &str,
) -> Result<(), Fault> {
    let text = Text::of(language);
    let mut items = store.list().await?;
    items.extend(Journal::open(|| ()).await?.sittings().await?);
    let rows: String = items.iter().map(|item| row(text, language, item)).collect();
    let Text { title, about, what, when, size, delete_all, nothing, .. } = text;
    let list = if items.is_empty() {
        format!("<p data-testid=\"nothing-kept\">{nothing}</p>")
    } else {
        format!(
            "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"{title}\"><table class=\"entries\">\
            <thead><tr><th>{what}</th><th>{when}</th><th>{size}</th><td></td></tr></thead><tbody>{rows}</tbody></table>\
            </div><p class=\"buttons\"><button type=\"button\" class=\"quiet\" data-testid=\"delete-all\">{delete_all}\
            </button></p>"
        )
    };
    into.set_inner_html(&format!(
        "<h2>{title}</h2><p>{about}</p><p class=\"dim\" role=\"status\">{said}</p>{list}"
    ));
    Ok(())
}

fn row(text: &Text, language: Language, Item { kind, name, bytes, at }: &Item) -> String {
    let what = escaped(&text.item(kind, name));
    let when = Date::new(&(*at).into()).to_locale_string(language.code(), &Object::new());
    let (kind, name) = (escaped(kind), escaped(name));
    let button = |does: &str, words: &str| {
        format!(
            "<button type=\"button\" class=\"link\" data-testid=\"{does}\" data-kind=\"{kind}\" data-name=\"{name}\" \
            aria-label=\"{words}: {what}\">{words}</button>"
        )
    };
    format!(
        "<tr data-testid=\"kept-item\"><td>{what}</td><td>{}</td><td>{} KB</td><td>{} {}</td></tr>",
        String::from(when),
        bytes.div_ceil(1000),
        button("export", text.save),
        button("delete", text.delete),
    )
}

/// Words that stand for themselves in a page.
fn escaped(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}
