//! The journal as the page that asks keeps it. A note's place is taken once: who finds it taken is not the tab that has
//! the sitting.

use crate::study::journal::Note;
use crate::ui::collect::action::Kept;
use crate::ui::page::keep::fault::Fault;
use crate::ui::page::view::journal::Journal;
use crate::ui::page::view::store::{fault_of, finish, of};
use wasm_bindgen::JsValue;

impl Journal {
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
        let all = self.notes(sitting).await?;
        // What stands behind a note that cannot be read belongs to nothing.
        let note = |(_, text): &(String, String)| serde_json::from_str::<Note>(text).ok();
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
