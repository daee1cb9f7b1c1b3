//! The address of the page: which view is open stands behind its `#`, or a whole session, packed.

use crate::ui::app::action::{Action, View};
use crate::ui::page::view::packed::{pack, unpack};
use crate::ui::page::view::{forms, host};
use crate::ui::talk;
use crate::ui::talk::share::session::LONGEST_LINK;
use crate::ui::talk::share::state::Link;
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::spawn_local;
use yew::Callback;

/// What stands before a session in a link.
const SESSION: &str = "#s=";

/// Tells the page what its address says, now and whenever it changes.
pub(super) fn watch(act: &Callback<Action>) {
    read(act);
    // Who comes with a link, or asks for a view, knows the page already.
    if hash().is_empty() {
        act.emit(Action::Talk(talk::Action::Demo));
        let touched = act.reform(|()| Action::Talk(talk::Action::Touched));
        host::once_touched(Callback::from(move |()| {
            talk::view::give_back();
            touched.emit(());
        }));
    }
    let act = act.clone();
    let changed = Closure::<dyn FnMut()>::new(move || read(&act));
    if let Some(window) = web_sys::window() {
        window.set_onhashchange(Some(changed.as_ref().unchecked_ref()));
    }
    // The page listens as long as it lives.
    changed.forget();
}

/// What stands behind the address, with its `#`.
fn hash() -> String {
    web_sys::window().and_then(|w| w.location().hash().ok()).unwrap_or_default()
}

fn read(act: &Callback<Action>) {
    let hash = hash();
    if let Some(packed) = hash.strip_prefix(SESSION) {
        act.emit(Action::Linked(hash.trim_start_matches('#').to_owned()));
        let (packed, act) = (packed.to_owned(), act.clone());
        spawn_local(
            async move { act.emit(Action::Talk(talk::Action::Open(opened(&packed).await))) },
        );
    } else if let Some(said) = hash.strip_prefix("#say=") {
        // Said once: the browser comes back to the talk, and not to this.
        replace("#talk");
        let said = js_sys::decode_uri_component(said).map(String::from).unwrap_or_default();
        act.emit(Action::Go(View::Talk));
        act.emit(Action::Talk(talk::Action::AskExample(said)));
    } else if let Some(view) = View::of(hash.trim_start_matches('#')) {
        act.emit(Action::Go(view));
    }
}

/// Makes a link that holds a session, puts it into the address bar and onto the clipboard.
pub(super) fn share(packed: Vec<u8>, act: Callback<Action>) {
    spawn_local(async move {
        let link = match made(&packed).await {
            Ok(address) => {
                let copied = host::copy(&address).await;
                Ok(Link { address, copied })
            }
            Err(why) => Err(why),
        };
        act.emit(Action::Talk(talk::Action::Shared(link)));
    });
}

async fn made(session: &[u8]) -> Result<String, String> {
    link(&forms::forms().await?.write_session(session)).await
}

async fn link(text: &str) -> Result<String, String> {
    let broken = |error: JsValue| host::words(&error);
    let window = web_sys::window().ok_or("there is no window")?;
    let packed = pack(&window, text).await.map_err(broken)?;
    if packed.len() > LONGEST_LINK {
        return Err(format!(
            "This is too much for a link ({} characters, at most {LONGEST_LINK}): save it as a file.",
            packed.len()
        ));
    }
    let location = window.location();
    let address = location.href().map_err(broken)?;
    let bare = address.split('#').next().unwrap_or_default();
    let address = format!("{bare}{SESSION}{packed}");
    replace(&address);
    Ok(address)
}

/// Replaces the address, without a new entry in the history, and without being told of it.
fn replace(address: &str) {
    if let Some(history) = web_sys::window().and_then(|w| w.history().ok()) {
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(address));
    }
}

async fn opened(packed: &str) -> Result<Vec<u8>, String> {
    forms::session(unpack(packed, LONGEST_LINK).await?).await
}
