//! Files: choosing and dropping them. What they are is decided in `page::files`.

use crate::ui::page::files::{Fault, Given, Kind, Offered, admit, given, kind};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Blob, DragEvent, Event, File, FileList, HtmlInputElement};
use yew::{Callback, Html, TargetCast, html};

/// What a file is shows within so many bytes.
const HEAD: f64 = 256.0;

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
        read_all(listed(input.files()), &offer);
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

/// The files that were dropped.
pub(crate) fn dropped(event: &DragEvent) -> Vec<File> {
    listed(event.data_transfer().and_then(|data| data.files()))
}

/// Reads the files given and offers them, all at once.
pub(crate) fn read_all(files: Vec<File>, offer: &Callback<Vec<Offered>>) {
    let offer = offer.clone();
    spawn_local(async move {
        let mut all = Vec::with_capacity(files.len());
        for file in files {
            let bytes = match admit(file.size()) {
                Ok(()) => read(&file).await,
                Err(fault) => Err(fault),
            };
            all.push(Offered { name: file.name(), bytes });
        }
        offer.emit(all);
    });
}

/// Takes from files what the robot can be given; the rest, which has not been read, is brought elsewhere.
pub(crate) fn sort(files: Vec<File>, give: Callback<Given>, bring: Callback<Vec<File>>) {
    spawn_local(async move {
        let mut rest = Vec::new();
        for file in files {
            match for_the_robot(&file).await {
                Some(text) => give.emit(text),
                None => rest.push(file),
            }
        }
        if !rest.is_empty() {
            bring.emit(rest);
        }
    });
}

async fn for_the_robot(file: &File) -> Option<Given> {
    admit(file.size()).ok()?;
    let head = file.slice_with_f64_and_f64(0.0, HEAD).ok()?;
    if kind(&file.name(), &read(&head).await.ok()?) == Kind::Corpus {
        return None;
    }
    given(&file.name(), read(file).await.ok()?).ok().flatten()
}

async fn read(file: &Blob) -> Result<Vec<u8>, Fault> {
    let buffer = JsFuture::from(file.array_buffer()).await.map_err(|_| Fault::Unreadable)?;
    Ok(js_sys::Uint8Array::new(&buffer).to_vec())
}

/// The files of a list, which empties itself when its input does.
fn listed(files: Option<FileList>) -> Vec<File> {
    let Some(list) = files else { return Vec::new() };
    (0..list.length()).filter_map(|at| list.get(at)).collect()
}
