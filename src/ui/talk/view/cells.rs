//! The world cell by cell, as a table: what the picture shows, for those who do not see it.
use crate::domain::State;
use crate::render::Grid;
use crate::ui::page::language::Language;
use crate::ui::talk::words::Text;
use web_sys::{Event, HtmlDetailsElement};
use yew::{Callback, Html, Properties, TargetCast, component, html, use_state_eq};

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    pub(super) shown: State,
    pub(super) language: Language,
}

/// The table, made when it is opened.
#[component]
pub(super) fn Cells(props: &Props) -> Html {
    let text = Text::of(props.language);
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
            <summary>{ text.cell_by_cell }</summary>
            if *open { { table(text, &props.shown) } }
        </details>
    }
}

fn table(text: &Text, shown: &State) -> Html {
    let grid = Grid::of(shown);
    let label = |x, y| text.phrases.cell(shown, (x, y));
    html! {
        <div class="scroll" tabindex="0" role="group" aria-label={text.cell_by_cell}>
            <table>
                <caption class="unseen">{ text.cells_caption }</caption>
                <tbody>
                    { for grid.rows.iter().map(|row| html! {
                        <tr>
                            { for row.iter().map(|cell| html! {
                                <td class={cell.class.clone()} title={label(cell.x, cell.y)}>
                                    <span aria-hidden="true">{ &cell.symbol }</span>
                                    <span class="unseen">{ label(cell.x, cell.y) }</span>
                                </td>
                            }) }
                        </tr>
                    }) }
                </tbody>
            </table>
        </div>
    }
}
