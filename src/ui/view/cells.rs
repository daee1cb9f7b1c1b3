//! The world cell by cell, as a table: what the picture shows, for those who do not see it.

use crate::domain::State;
use crate::render::Grid;
use web_sys::{Event, HtmlDetailsElement};
use yew::{Callback, Html, Properties, TargetCast, component, html, use_state_eq};

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    pub(super) shown: State,
}

/// The table, made when it is opened.
#[component]
pub(super) fn Cells(props: &Props) -> Html {
    let open = use_state_eq(|| false);
    let toggled = {
        let open = open.clone();
        Callback::from(move |event: Event| {
            let details = event.target_dyn_into::<HtmlDetailsElement>();
            open.set(details.is_some_and(|d| d.open()));
        })
    };
    html! {
        <details class="cells" ontoggle={toggled} data-testid="cells">
            <summary>{"Cell by cell"}</summary>
            if *open { { table(&Grid::of(&props.shown)) } }
        </details>
    }
}

fn table(grid: &Grid) -> Html {
    html! {
        <div class="scroll" tabindex="0" role="group" aria-label="The room, cell by cell">
            <table>
                <caption class="unseen">{"The room, from the north row to the south, cells from the west."}</caption>
                <tbody>
                    { for grid.rows.iter().map(|row| html! {
                        <tr>
                            { for row.iter().map(|cell| html! {
                                <td class={cell.class.clone()} title={cell.label.clone()}>
                                    <span aria-hidden="true">{ &cell.symbol }</span>
                                    <span class="unseen">{ &cell.label }</span>
                                </td>
                            }) }
                        </tr>
                    }) }
                </tbody>
            </table>
        </div>
    }
}
