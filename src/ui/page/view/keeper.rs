//! The page's side of the keeper: imports the module `keeper.js`, asks it in turn, and tells the page what it says.

use super::forms::{self, Forms};
use super::host;
use super::module::import;
use crate::ui::page::keep::ask::{Ask, News, Place};
use crate::ui::page::keep::fault::Fault;
use js_sys::{Array, JsString, Promise, Uint8Array};
use std::cell::RefCell;
use std::rc::Rc;
use wasm_bindgen::prelude::{Closure, wasm_bindgen};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::Element;
use yew::Callback;

/// The element that the list of what is kept is drawn into.
pub(crate) const LIST: &str = "kept-list";

#[wasm_bindgen]
extern "C" {
    /// The keeper's exports.
    #[derive(Clone)]
    pub(crate) type Module;
    #[wasm_bindgen(method, structural)]
    fn open(this: &Module, name: &str, told: &JsValue) -> Promise;
    #[wasm_bindgen(method, structural)]
    pub(crate) fn claim(this: &Module, name: &str, steal: bool, told: &JsValue) -> Promise;

    /// The store, open.
    #[derive(Clone)]
    pub(crate) type Store;
    #[wasm_bindgen(method, structural)]
    fn write(this: &Store, kind: &str, name: &str, text: &str) -> Promise;
    #[wasm_bindgen(method, structural)]
    fn read(this: &Store, kind: &str, name: &str) -> Promise;
    #[wasm_bindgen(method, structural)]
    fn show(this: &Store, into: &Element, language: &str) -> Promise;
    #[wasm_bindgen(method, structural)]
    pub(crate) fn write_bytes(this: &Store, kind: &str, name: &str, bytes: &Uint8Array) -> Promise;
    #[wasm_bindgen(method, structural)]
    pub(crate) fn read_bytes(this: &Store, kind: &str, name: &str) -> Promise;
    #[wasm_bindgen(method, structural)]
    pub(crate) fn list(this: &Store) -> Promise;
    #[wasm_bindgen(method, structural)]
    pub(crate) fn delete(this: &Store, kind: &str, name: &str) -> Promise;
}

/// The keeper, as far as it has come.
#[derive(Clone)]
pub(crate) struct Keeper {
    tell: Callback<News>,
    open: Rc<RefCell<Option<(Module, Store)>>>,
}

impl Keeper {
    /// What it says goes to `tell`.
    pub(crate) fn new(tell: Callback<News>) -> Keeper {
        Keeper { tell, open: Rc::default() }
    }

    /// Does what is wanted, and says what came of it.
    pub(crate) fn ask(&self, ask: Ask) {
        let keeper = self.clone();
        spawn_local(async move {
            let place = match &ask {
                Ask::Read(place) | Ask::Write(place, _) => Some(place.clone()),
                _ => None,
            };
            match keeper.done(ask).await {
                Ok(news) => news.into_iter().for_each(|news| keeper.tell.emit(news)),
                Err(error) => {
                    let fault = Fault::of(&host::words(&error));
                    keeper.tell.emit(News::Failed(place, fault));
                }
            }
        });
    }

    async fn done(&self, ask: Ask) -> Result<Option<News>, JsValue> {
        if ask == Ask::Open {
            let opened = load(&self.teller()).await?;
            *self.open.borrow_mut() = Some(opened);
            return Ok(Some(News::Open));
        }
        let Some((module, store)) = self.open.borrow().clone() else { return Ok(None) };
        let news = match ask {
            Ask::Open => return Ok(None),
            Ask::Claim { name, steal } => {
                let ours = module.claim(&scoped(&name)?, steal, &self.teller());
                News::Claimed(JsFuture::from(ours).await?.is_truthy())
            }
            Ask::Read(place) => {
                let found = read(&store, &place).await?;
                let forms: &Forms = module.unchecked_ref();
                let found = found
                    .map(|(text, damaged)| (forms::packed(forms.read_session(&text)), damaged));
                News::Read(place, found)
            }
            Ask::Write(place, packed) => {
                let text = module.unchecked_ref::<Forms>().write_session(&packed);
                write(&store, &place, &text).await?;
                News::Written
            }
            Ask::Copy(from, to) => {
                let Some((text, _)) = read(&store, &from).await? else { return Ok(None) };
                write(&store, &to, &text).await?;
                News::Written
            }
            Ask::Show(language) => {
                if let Some(into) = host::element(LIST) {
                    JsFuture::from(store.show(&into, language.code())).await?;
                }
                return Ok(None);
            }
        };
        Ok(Some(news))
    }

    /// What the keeper calls with a fault that comes later.
    fn teller(&self) -> JsValue {
        let tell = self.tell.clone();
        let told = Closure::<dyn FnMut(String)>::new(move |fault: String| {
            tell.emit(News::Failed(None, Fault::of(&fault)));
        });
        told.into_js_value()
    }
}

/// The keeper and its store, once they have come; `told` is called with a fault that comes later.
pub(crate) async fn load(told: &JsValue) -> Result<(Module, Store), JsValue> {
    let module: Module = import("keeper.js", 0).await?.unchecked_into();
    let store = JsFuture::from(module.open(&scoped("")?, told)).await?.unchecked_into();
    Ok((module, store))
}

/// Keeps a text at a place.
pub(crate) async fn write(
    store: &Store,
    Place { kind, name }: &Place,
    text: &str,
) -> Result<(), JsValue> {
    JsFuture::from(store.write(kind, name, text)).await.map(|_| ())
}

/// The text at a place, and whether its newest copy was damaged; nothing when none is kept.
pub(crate) async fn read(
    store: &Store,
    Place { kind, name }: &Place,
) -> Result<Option<(String, bool)>, JsValue> {
    let found = JsFuture::from(store.read(kind, name)).await?;
    let found = found.dyn_ref::<Array>().map(|found| (found.get(0), found.get(1)));
    Ok(found.map(|(text, damaged)| (JsString::from(text).into(), damaged.is_truthy())))
}

/// A name of this site's own: others of the same host have theirs.
pub(crate) fn scoped(name: &str) -> Result<String, JsValue> {
    // The page's own address without its file and what stands behind.
    Ok(format!("groundling {} {name}", host::beside(".")?.href()))
}
