//! The store in IndexedDB: an index of copies and what they hold, texts or bytes, so that what is kept can be listed
//! without being read. Linked by the program `keeper`; what its errors mean, `collect` knows by it as well.

use crate::ui::page::keep::copies::{COPIES, Entry, Item, items, key, newest_first, next};
use crate::ui::page::keep::fault::Fault;
use idb::{
    Database, DatabaseEvent, Error, Factory, ObjectStore, ObjectStoreParams, Transaction,
    TransactionMode, TransactionResult,
};
use js_sys::{Date, Promise, Uint8Array};
use std::cell::Cell;
use std::rc::Rc;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::DomException;

/// The version of the store's form. It counts from 2, so that there is an older one to be tried with.
const VERSION: u32 = 2;
const INDEX: &str = "index";
const TEXTS: &str = "texts";

/// Bytes whose checksum is made at once: some milliseconds of work.
const PART: usize = 2_000_000;

/// What is to be kept.
#[derive(Clone, Copy, Debug)]
pub enum Content<'a> {
    /// A text.
    Text(&'a str),
    /// Bytes.
    Bytes(&'a [u8]),
}

impl Content<'_> {
    const fn bytes(&self) -> &[u8] {
        match self {
            Content::Text(text) => text.as_bytes(),
            Content::Bytes(bytes) => bytes,
        }
    }

    fn value(&self) -> JsValue {
        match self {
            Content::Text(text) => (*text).into(),
            Content::Bytes(bytes) => Uint8Array::from(*bytes).into(),
        }
    }
}

/// The store, open.
pub struct Store(Database);

impl Store {
    /// Opens the store of this name, making it if there is none. Where a page of an older build holds it, `blocked` is
    /// called and opening waits; when a newer build wants it, it is given up and `gone` is called.
    ///
    /// # Errors
    /// When there is none to be had, or a newer build made it.
    pub async fn open(
        name: &str,
        blocked: impl FnOnce() + 'static,
        gone: impl FnOnce() + 'static,
    ) -> Result<Store, Fault> {
        let factory = Factory::new().map_err(|_| Fault::None)?;
        let mut request = factory.open(name, Some(VERSION)).map_err(|_| Fault::None)?;
        request.on_blocked(|_| blocked());
        let failed = Rc::new(Cell::new(false));
        let upgrading = failed.clone();
        request.on_upgrade_needed(move |event| {
            let made = event.database().and_then(|database| {
                let has = database.store_names();
                for name in [INDEX, TEXTS].into_iter().filter(|name| !has.iter().any(|n| n == name))
                {
                    database.create_object_store(name, ObjectStoreParams::new())?;
                }
                Ok(())
            });
            upgrading.set(made.is_err());
        });
        let mut database = request.await.map_err(|error| match fault_of(&error) {
            Fault::Other(_) => Fault::None,
            fault => fault,
        })?;
        if failed.get() {
            return Err(Fault::None);
        }
        database.on_version_change(move |event| {
            // What holds the store is closed, so that the newer build can go on.
            if let Some(target) = event.target() {
                let _ = Database::try_from(target).map(|held| held.close());
            }
            gone();
        });
        Ok(Store(database))
    }

    /// Keeps something under a kind and a name.
    ///
    /// # Errors
    /// When there is no room, or the store is gone.
    pub async fn write(&self, kind: &str, name: &str, content: Content<'_>) -> Result<(), Fault> {
        let sum = sum(content.bytes()).await;
        let (transaction, index, texts) = self.begin(TransactionMode::ReadWrite)?;
        let (copy, number) = next(&entries(&index, kind, name).await?);
        let bytes = content.bytes().len();
        let (kind, name, at) = (kind.to_owned(), name.to_owned(), Date::now());
        let place = JsValue::from(key(&kind, &name, copy));
        let entry = Entry { kind, name, copy, number, bytes, sum, at };
        // Strings and numbers only: JSON can hold them all.
        let entry = serde_json::to_string(&entry).unwrap_or_default();
        texts.put(&content.value(), Some(&place)).map_err(of)?.await.map_err(of)?;
        index.put(&entry.into(), Some(&place)).map_err(of)?.await.map_err(of)?;
        finish(transaction).await
    }

    /// The bytes under a kind and a name, and whether the newest copy of them was damaged.
    ///
    /// # Errors
    /// When every copy is damaged, or the store is gone.
    pub async fn read(&self, kind: &str, name: &str) -> Result<Option<(Vec<u8>, bool)>, Fault> {
        let (_, index, _) = self.begin(TransactionMode::ReadOnly)?;
        let entries = newest_first(entries(&index, kind, name).await?);
        let is_kept = !entries.is_empty();
        for (turn, entry) in entries.into_iter().enumerate() {
            let place = JsValue::from(key(kind, name, entry.copy));
            // While a checksum is made a transaction ends by itself.
            let (_, _, texts) = self.begin(TransactionMode::ReadOnly)?;
            let kept = texts.get(place).map_err(of)?.await.map_err(of)?.unwrap_or_default();
            let text = kept.as_string().map(String::into_bytes);
            let bytes = || kept.dyn_ref::<Uint8Array>().map(Uint8Array::to_vec);
            let bytes = text.or_else(bytes).unwrap_or_default();
            if sum(&bytes).await == entry.sum {
                return Ok(Some((bytes, turn > 0)));
            }
        }
        if is_kept { Err(Fault::Damaged) } else { Ok(None) }
    }

    /// What is kept, the latest first.
    ///
    /// # Errors
    /// When the store is gone.
    pub async fn list(&self) -> Result<Vec<Item>, Fault> {
        let (_, index, _) = self.begin(TransactionMode::ReadOnly)?;
        let all = index.get_all(None, None).map_err(of)?.await.map_err(of)?;
        Ok(items(all.iter().filter_map(entry).collect()))
    }

    /// Deletes what is kept under a kind and a name; all of it, if the kind is empty.
    ///
    /// # Errors
    /// When the store is gone.
    pub async fn delete(&self, kind: &str, name: &str) -> Result<(), Fault> {
        let (transaction, index, texts) = self.begin(TransactionMode::ReadWrite)?;
        for store in [index, texts] {
            if kind.is_empty() {
                store.clear().map_err(of)?.await.map_err(of)?;
                continue;
            }
            for copy in 0..COPIES {
                let place = JsValue::from(key(kind, name, copy));
                store.delete(place).map_err(of)?.await.map_err(of)?;
            }
        }
        finish(transaction).await
    }

    fn begin(
        &self,
        mode: TransactionMode,
    ) -> Result<(Transaction, ObjectStore, ObjectStore), Fault> {
        let transaction = self.0.transaction(&[INDEX, TEXTS], mode).map_err(of)?;
        let index = transaction.object_store(INDEX).map_err(of)?;
        let texts = transaction.object_store(TEXTS).map_err(of)?;
        Ok((transaction, index, texts))
    }
}

/// BLAKE3 of bytes, in hexadecimal, made in parts: the page goes on between them.
async fn sum(bytes: &[u8]) -> String {
    let mut hasher = blake3::Hasher::new();
    for (turn, part) in bytes.chunks(PART).enumerate() {
        if turn > 0 {
            let soon = Promise::new(&mut |done, _| {
                let set = web_sys::window().map(|window| window.set_timeout_with_callback(&done));
                // Without a timer it goes on at once.
                if !matches!(set, Some(Ok(_))) {
                    let _ = done.call0(&JsValue::NULL);
                }
            });
            let _ = JsFuture::from(soon).await;
        }
        hasher.update(part);
    }
    hasher.finalize().to_hex().to_string()
}

/// The copies that there are of a text.
async fn entries(index: &ObjectStore, kind: &str, name: &str) -> Result<Vec<Entry>, Fault> {
    let mut entries = Vec::new();
    for copy in 0..COPIES {
        let found = index.get(JsValue::from(key(kind, name, copy))).map_err(of)?;
        entries.extend(found.await.map_err(of)?.as_ref().and_then(entry));
    }
    Ok(entries)
}

fn entry(value: &JsValue) -> Option<Entry> {
    serde_json::from_str(&value.as_string()?).ok()
}

/// Waits until everything of a transaction is kept.
///
/// # Errors
/// When it is not, most of all for want of room.
pub(crate) async fn finish(transaction: Transaction) -> Result<(), Fault> {
    match transaction.commit().map_err(of)?.await.map_err(of)? {
        TransactionResult::Committed => Ok(()),
        // Nothing here takes a change back: the browser did, which it does for want of room.
        TransactionResult::Aborted => Err(Fault::Full),
    }
}

/// What an error of the browser means here.
pub(crate) fn of(error: Error) -> Fault {
    fault_of(&error)
}

/// What an error of the browser means here.
pub(crate) fn fault_of(error: &Error) -> Fault {
    let name = match error {
        Error::DomException(exception) => exception.name(),
        Error::AddFailed(value)
        | Error::UpdateFailed(value)
        | Error::IndexedDbOpenFailed(value)
        | Error::TransactionOpenFailed(value) => {
            value.dyn_ref::<DomException>().map(DomException::name).unwrap_or_default()
        }
        _ => String::new(),
    };
    match &*name {
        "VersionError" => Fault::Newer,
        "QuotaExceededError" => Fault::Full,
        "SecurityError" | "InvalidStateError" => Fault::None,
        _ => Fault::Other(error.to_string()),
    }
}
