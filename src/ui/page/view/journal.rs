//! The journal of those who take part in studies, in IndexedDB: notes, one under each key. Every change is asked to be
//! strict: that it is kept is said when it would outlast a power cut, where the browser can promise that. The page that
//! asks writes it; what is kept is listed and deleted elsewhere, too.

use super::host;
use super::store::{fault_of, finish, of};
use crate::ui::page::keep::copies::Item;
use crate::ui::page::keep::fault::Fault;
use idb::{
    Database, DatabaseEvent, Factory, KeyRange, ObjectStore, ObjectStoreParams, Query, Transaction,
};
use js_sys::{Array, Object, Reflect};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

/// The version of the store's form.
const VERSION: u32 = 1;
/// The store of everything: notes, what is over, and pseudonyms, each under a key that says so.
const STORE: &str = "notes";
/// What a sitting is called where things that are kept are listed.
pub(crate) const KIND: &str = "sitting";

#[wasm_bindgen]
extern "C" {
    type Strict;
    #[wasm_bindgen(method, catch)]
    fn transaction(
        this: &Strict,
        stores: &Array,
        mode: &str,
        options: &Object,
    ) -> Result<JsValue, JsValue>;
}

/// The journal, open.
pub(crate) struct Journal {
    /// Held for its listeners.
    _held: Database,
    database: JsValue,
}

impl Journal {
    /// Opens it, making it if there is none; `gone` is called when a newer build wants it.
    pub(crate) async fn open(gone: impl FnOnce() + 'static) -> Result<Journal, Fault> {
        let base = host::beside(".").map_err(|_| Fault::None)?.href();
        let factory = Factory::new().map_err(|_| Fault::None)?;
        let name = format!("groundling collect {base}");
        let mut request = factory.open(&name, Some(VERSION)).map_err(|_| Fault::None)?;
        request.on_upgrade_needed(|event| {
            // A store that cannot be made is missed by the first who looks for it.
            let _ = event
                .database()
                .and_then(|database| database.create_object_store(STORE, ObjectStoreParams::new()));
        });
        let opened = request.await.map_err(|error| match fault_of(&error) {
            Fault::Other(_) => Fault::None,
            fault => fault,
        })?;
        let database = JsValue::from(opened);
        let mut held = Database::try_from(database.clone()).map_err(of)?;
        held.on_version_change(move |event| {
            if let Some(target) = event.target() {
                let _ = Database::try_from(target).map(|held| held.close());
            }
            gone();
        });
        Ok(Journal { _held: held, database })
    }

    /// The sittings of which something is kept, the latest first.
    ///
    /// # Errors
    /// When the store is gone.
    pub(crate) async fn sittings(&self) -> Result<Vec<Item>, Fault> {
        let mut items: Vec<Item> = Vec::new();
        for (name, text) in self.notes("").await? {
            if items.last().is_none_or(|item| item.name != name) {
                items.push(Item { kind: KIND.to_owned(), name, bytes: 0, at: 0.0 });
            }
            if let Some(item) = items.last_mut() {
                item.bytes += text.len();
                item.at = item.at.max(time(&text));
            }
        }
        items.sort_by(|one, other| other.at.total_cmp(&one.at));
        Ok(items)
    }

    /// The notes of a sitting, or of all, each with the sitting's name, in order.
    ///
    /// # Errors
    /// When the store is gone.
    pub(crate) async fn notes(&self, sitting: &str) -> Result<Vec<(String, String)>, Fault> {
        let (_, store) = self.begin()?;
        let keys = store.get_all_keys(Some(notes_of(sitting)?), None).map_err(of)?;
        let keys = keys.await.map_err(of)?;
        let all = store.get_all(Some(notes_of(sitting)?), None).map_err(of)?;
        let all = all.await.map_err(of)?;
        let named = |key: &JsValue| {
            let key = key.as_string()?;
            Some(key.strip_prefix("note/")?.rsplit_once('/')?.0.to_owned())
        };
        let pairs = keys.iter().zip(&all);
        Ok(pairs.filter_map(|(key, text)| Some((named(key)?, text.as_string()?))).collect())
    }

    /// Forgets all of it: notes, pseudonyms, and what is over.
    ///
    /// # Errors
    /// When the store is gone.
    pub(crate) async fn clear(&self) -> Result<(), Fault> {
        let (transaction, store) = self.begin()?;
        store.clear().map_err(of)?.await.map_err(of)?;
        finish(transaction).await
    }

    /// Erases what is kept of a sitting; where it is over, that stays, with its code.
    pub(crate) async fn erase(&self, sitting: &str, over: Option<&str>) -> Result<(), Fault> {
        let (transaction, store) = self.begin()?;
        let notes = store.delete(notes_of(sitting)?).map_err(of)?;
        notes.await.map_err(of)?;
        let key = JsValue::from(format!("over/{sitting}"));
        if let Some(code) = over {
            let put = store.put(&code.into(), Some(&key)).map_err(of)?;
            put.await.map_err(of)?;
        }
        finish(transaction).await
    }

    /// A transaction whose end means that all of it is on the disk.
    pub(crate) fn begin(&self) -> Result<(Transaction, ObjectStore), Fault> {
        let options = Object::new();
        let strict = Reflect::set(&options, &"durability".into(), &"strict".into());
        let raw = strict.and_then(|_| {
            let database: &Strict = self.database.unchecked_ref();
            database.transaction(&Array::of1(&STORE.into()), "readwrite", &options)
        });
        let raw = raw.map_err(|error| Fault::Other(host::words(&error)))?;
        let transaction = Transaction::try_from(raw).map_err(of)?;
        let store = transaction.object_store(STORE).map_err(of)?;
        Ok((transaction, store))
    }
}

/// The keys of a sitting's notes, or of all.
pub(crate) fn notes_of(sitting: &str) -> Result<Query, Fault> {
    let slash = if sitting.is_empty() { "" } else { "/" };
    let [from, to] = ["", "~"].map(|end| JsValue::from(format!("note/{sitting}{slash}{end}")));
    KeyRange::bound(&from, &to, None, None).map(Query::from).map_err(of)
}

/// When a note was written, as far as it says so.
fn time(note: &str) -> f64 {
    #[derive(serde::Deserialize)]
    struct Timed {
        at: Option<f64>,
    }
    let kinds: Result<std::collections::BTreeMap<String, Timed>, _> = serde_json::from_str(note);
    kinds.ok().and_then(|kinds| kinds.into_values().next()?.at).unwrap_or(0.0)
}
