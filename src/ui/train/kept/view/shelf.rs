//! The workbench's way to the store: the same module `keeper.js` that the page has, asked for bytes.

use crate::ui::page::keep::ask::Place;
use crate::ui::page::keep::fault::Fault;
use crate::ui::page::view::host;
use crate::ui::page::view::keeper::{Module, Store, load, scoped};
use crate::ui::train::kept::ask::{Ask, News};
use js_sys::{Array, Uint8Array};
use std::cell::RefCell;
use std::rc::Rc;
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use yew::Callback;

/// The name that the tab which keeps runs claims.
const CLAIM: &str = "workbench";

/// The store, as far as it has come.
#[derive(Clone)]
pub(crate) struct Shelf {
    tell: Callback<News>,
    open: Rc<RefCell<Option<(Module, Store)>>>,
}

impl Shelf {
    /// What it says goes to `tell`.
    pub(crate) fn new(tell: Callback<News>) -> Shelf {
        Shelf { tell, open: Rc::default() }
    }

    /// Does what is wanted, and says what came of it.
    pub(crate) fn ask(&self, ask: Ask) {
        let shelf = self.clone();
        spawn_local(async move {
            let place = match &ask {
                Ask::Read(place) | Ask::Write(place, _) | Ask::Delete(place) => Some(place.clone()),
                Ask::Open | Ask::Claim(_) | Ask::List => None,
            };
            shelf.tell.emit(match shelf.done(ask).await {
                Ok(news) => news,
                Err(error) => News::Failed(place, Fault::of(&host::words(&error))),
            });
        });
    }

    async fn done(&self, ask: Ask) -> Result<News, JsValue> {
        if ask == Ask::Open {
            let opened = load(&self.teller()).await?;
            *self.open.borrow_mut() = Some(opened);
            return Ok(News::Open);
        }
        let open = self.open.borrow().clone();
        let (module, store) = open.ok_or_else(|| JsValue::from_str(Fault::None.name()))?;
        Ok(match ask {
            Ask::Open => News::Open,
            Ask::Claim(steal) => {
                let ours = module.claim(&scoped(CLAIM)?, steal, &self.teller());
                News::Claimed(JsFuture::from(ours).await?.is_truthy())
            }
            Ask::List => {
                let list = JsFuture::from(store.list()).await?.as_string().unwrap_or_default();
                News::List(serde_json::from_str(&list).unwrap_or_default())
            }
            Ask::Read(place) => {
                let found = JsFuture::from(store.read_bytes(&place.kind, &place.name)).await?;
                let found = found.dyn_ref::<Array>().map(|found| {
                    (Uint8Array::new(&found.get(0)).to_vec(), found.get(1).is_truthy())
                });
                News::Read(place, found)
            }
            Ask::Write(place, bytes) => {
                let Place { kind, name } = &place;
                let bytes = Uint8Array::from(&*bytes);
                JsFuture::from(store.write_bytes(kind, name, &bytes)).await?;
                News::Written(place)
            }
            Ask::Delete(place) => {
                JsFuture::from(store.delete(&place.kind, &place.name)).await?;
                News::Deleted(place)
            }
        })
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
