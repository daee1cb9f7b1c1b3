//! Files: choosing and dropping them. What they are is decided in `page::files`.

use crate::ui::page::files::{Fault, Offered, admit};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Event, File, FileList, HtmlInputElement};
use yew::{Callback, Html, TargetCast, html};

/// A file to choose: the label is the button, the input itself is unseen but takes the focus.
pub(crate) fn open_file(
    id: &'static str,
    label: &'static str,
    accept: &'static str,
    hint: Option<&str>,
    offer: &Callback<Vec<Offered>>,
) -> Html {
    let offer = offer.clone();
    let chosen = Callback::from(move |event: Event| {
        let Some(input) = event.target_dyn_into::<HtmlInputElement>() else { return };
        read_all(input.files(), &offer);
        // The same file can then be chosen again after it was mended.
        input.set_value("");
    });
    html! {
        <p class="open-file">
            <input class="unseen" type="file" {id} data-testid={id}
                {accept} multiple=true onchange={chosen} />
            <label class="plain" for={id}>{ label }</label>
            if let Some(hint) = hint { <span class="dim">{ hint }</span> }
        </p>
    }
}

/// Reads the files given and offers them to the page, all at once.
pub(crate) fn read_all(files: Option<FileList>, offer: &Callback<Vec<Offered>>) {
    let Some(list) = files else { return };
    // A list empties itself when its input does.
    let files: Vec<File> = (0..list.length()).filter_map(|at| list.get(at)).collect();
    let offer = offer.clone();
    spawn_local(async move {
        let mut all = Vec::with_capacity(files.len());
        for file in files {
            all.push(Offered { name: file.name(), bytes: read(&file).await });
        }
        offer.emit(all);
    });
}

async fn read(file: &File) -> Result<Vec<u8>, Fault> {
    admit(file.size())?;
    let buffer = JsFuture::from(file.array_buffer()).await.map_err(|_| Fault::Unreadable)?;
    Ok(js_sys::Uint8Array::new(&buffer).to_vec())
}
