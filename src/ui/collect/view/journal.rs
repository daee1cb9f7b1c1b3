//! The journal in IndexedDB. Every change is asked to be strict: that a note is kept is said when it would outlast a power
//! cut, where the browser can promise that. A note's place is taken once: who finds it taken is not the tab that has the
//! sitting.

use crate::study::journal::Note;
use crate::ui::collect::action::Kept;
use crate::ui::page::keep::fault::Fault;
use crate::ui::page::view::host;
use crate::ui::page::view::store::{fault_of, finish, of};
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
pub(super) struct Journal {
    /// Held for its listeners.
    _held: Database,
    database: JsValue,
}

impl Journal {
    /// Opens it, making it if there is none; `gone` is called when a newer build wants it.
    pub(super) async fn open(gone: impl FnOnce() + 'static) -> Result<Journal, Fault> {
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

    /// The pseudonym of this browser in a study: made by chance, once.
    pub(super) async fn pseudonym(&self, study: &str) -> Result<String, Fault> {
        let (transaction, store) = self.begin()?;
        let key = JsValue::from(format!("me/{study}"));
        let found = store.get(key.clone()).map_err(of)?.await.map_err(of)?;
        if let Some(known) = found.and_then(|found| found.as_string()) {
            return Ok(known);
        }
        let made = chance();
        let put = store.put(&made.clone().into(), Some(&key)).map_err(of)?;
        put.await.map_err(of)?;
        finish(transaction).await?;
        Ok(made)
    }

    /// What is kept of a sitting.
    pub(super) async fn read(&self, sitting: &str) -> Result<Kept, Fault> {
        let (_, store) = self.begin()?;
        let over = store.get(JsValue::from(format!("over/{sitting}"))).map_err(of)?;
        let over = over.await.map_err(of)?.and_then(|over| over.as_string());
        let all = store.get_all(Some(notes_of(sitting)?), None).map_err(of)?;
        let all = all.await.map_err(of)?;
        // What stands behind a note that cannot be read belongs to nothing.
        let note = |text: &JsValue| serde_json::from_str::<Note>(&text.as_string()?).ok();
        Ok(Kept { notes: all.iter().map_while(note).collect(), over })
    }

    /// Keeps a note at its place.
    pub(super) async fn keep(&self, sitting: &str, place: u32, note: &Note) -> Result<(), Fault> {
        let (transaction, store) = self.begin()?;
        // Texts and numbers: JSON can hold them all.
        let text = serde_json::to_string(note).unwrap_or_default();
        let key = JsValue::from(format!("note/{sitting}/{place:08}"));
        let added = store.add(&text.into(), Some(&key)).map_err(of)?.await;
        added.map_err(|error| match fault_of(&error) {
            Fault::Other(words) if words.contains("Constraint") || words.contains("exists") => {
                Fault::Elsewhere
            }
            fault => fault,
        })?;
        finish(transaction).await
    }

    /// Erases what is kept of a sitting; where it is over, that stays, with its code.
    pub(super) async fn erase(&self, sitting: &str, over: Option<&str>) -> Result<(), Fault> {
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
    fn begin(&self) -> Result<(Transaction, ObjectStore), Fault> {
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

/// The keys of a sitting's notes.
fn notes_of(sitting: &str) -> Result<Query, Fault> {
    let [from, to] = ["", "~"].map(|end| JsValue::from(format!("note/{sitting}/{end}")));
    KeyRange::bound(&from, &to, None, None).map(Query::from).map_err(of)
}

/// A name by chance.
fn chance() -> String {
    let mut bytes = [0u8; 8];
    let crypto = web_sys::window().and_then(|window| window.crypto().ok());
    // Every browser that runs this has it; without it all of a study would be one person.
    let drawn = crypto.map(|crypto| crypto.get_random_values_with_u8_array(&mut bytes));
    if !matches!(drawn, Some(Ok(_))) {
        bytes = js_sys::Math::random().to_bits().to_le_bytes();
    }
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
