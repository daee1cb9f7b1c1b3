//! Mapping columns by hand: the first rows of a file under what each of its columns is to be.

use super::files::link;
use crate::ui::page::view::fields::choice;
use crate::ui::train::data::action::{Action, Map};
use crate::ui::train::data::mapping::{Column, Desk};
use crate::ui::train::data::words::Text;
use yew::{Callback, Html, html};

/// The columns that are being mapped.
pub(super) fn mapping(desk: &Desk, text: &Text, act: &Callback<Action>) -> Html {
    let act = act.reform(Action::Map);
    let all = Column::all(desk.pairs());
    let names: Vec<String> = all.iter().map(|column| (text.column)(*column)).collect();
    let is_complete = desk.mapping().is_complete();
    let file = desk.files.first().map_or("", |file| &file.name);
    // Columns with something in them come first: a platform's own are many, and mostly empty.
    let is_empty = |at: &usize| {
        desk.preview.rows.iter().all(|row| row.get(*at).is_none_or(|cell| cell.is_empty()))
    };
    let (empty, mut order): (Vec<usize>, Vec<usize>) =
        (0..desk.preview.columns.len()).partition(is_empty);
    order.extend(empty);
    let header = |at: usize| {
        let name = desk.preview.columns.get(at).map_or("", String::as_str);
        let column = desk.columns.get(at).copied().unwrap_or(Column::Unused);
        let chosen = all.iter().position(|one| *one == column).unwrap_or(0);
        let (choose, all) = (act.clone(), all.clone());
        let choose = Callback::from(move |place: usize| {
            let column = all.get(place).copied().unwrap_or(Column::Unused);
            choose.emit(Map::Choose(at, column));
        });
        html! {
            <th scope="col">{ choice(format!("column-{at}").into(), (text.column_is)(name).into(), &names, chosen, choose) }</th>
        }
    };
    html! {
        <section class="card" aria-labelledby="mapping-title" data-testid="mapping">
            <h2 id="mapping-title">{ text.map }</h2>
            <p>{ (text.map_help)(file) }</p>
            <div class="scroll" tabindex="0" role="region" aria-label={file.to_owned()}>
                <table class="preview">
                    <thead><tr>{ for order.iter().map(|at| header(*at)) }</tr></thead>
                    <tbody>
                        { for desk.preview.rows.iter().map(|row| html! {
                            <tr>{ for order.iter().map(|at| html! { <td>{ row.get(*at) }</td> }) }</tr>
                        }) }
                    </tbody>
                </table>
            </div>
            if !is_complete { <p class="notice" data-testid="mapping-missing">{ text.map_missing }</p> }
            <p class="buttons">
                <button type="button" class="primary" data-testid="map-use" disabled={!is_complete}
                    onclick={act.reform(|_| Map::Use)}>{ text.map_use }</button>
                <button type="button" class="quiet" data-testid="map-save" disabled={!is_complete}
                    onclick={act.reform(|_| Map::Save)}>{ text.map_save }</button>
                { link(text.cancel, "map-leave", act.reform(|()| Map::Leave)) }
            </p>
            <p class="dim">{ text.map_again }</p>
        </section>
    }
}
