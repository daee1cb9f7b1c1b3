//! Buttons that are a sign, with their meaning for those who do not see it or do not know it.

use yew::{Callback, Html, html};

/// A sign on a button.
#[derive(Clone, Copy)]
pub(crate) enum Sign {
    Undo,
    Redo,
    Reset,
    Share,
    First,
    Back,
    Play,
    Pause,
    Forward,
    Dice,
    Close,
    Pencil,
    Hand,
}

impl Sign {
    /// Its outline in a square of 24.
    const fn path(self) -> &'static str {
        match self {
            Sign::Undo => {
                "M9 4 3.5 9.5 9 15v-4h5.5a3.5 3.5 0 0 1 0 7H11v2h3.5a5.5 5.5 0 0 0 0-11H9z"
            }
            Sign::Redo => {
                "m15 4 5.5 5.5L15 15v-4H9.5a3.5 3.5 0 0 0 0 7H13v2H9.500a5.500 5.500 0 0 1 0-11H15z"
            }
            Sign::Reset => "M12 5V1L7 6l5 5V7a5 5 0 1 1-5 5H5a7 7 0 1 0 7-7z",
            Sign::Share => {
                "M17 15.200a3 3 0 0 0-2.200 1L9 12.900a3 3 0 0 0 0-1.800l5.800-3.300A3 3 0 1 0 14 6v.100L8.200 9.500a3 3 0 1 0 0 5l5.800 3.400A3 3 0 1 0 17 15.200z"
            }
            Sign::First => "M5 5h2v14H5zM19 5v14L9 12z",
            Sign::Back => "M16 5v14L6 12z",
            Sign::Play => "M7 4v16l13-8z",
            Sign::Pause => "M6 5h4v14H6zM14 5h4v14h-4z",
            Sign::Forward => "M8 5l10 7L8 19z",
            Sign::Dice => {
                "M5 3h14a2 2 0 0 1 2 2v14a2 2 0 0 1-2 2H5a2 2 0 0 1-2-2V5a2 2 0 0 1 2-2zm0 2v14h14V5zm3 1.500a1.500 1.500 0 1 1 0 3 1.500 1.500 0 0 1 0-3zm8 0a1.500 1.500 0 1 1 0 3 1.500 1.500 0 0 1 0-3zm-4 4a1.500 1.500 0 1 1 0 3 1.500 1.500 0 0 1 0-3zm-4 4a1.500 1.500 0 1 1 0 3 1.500 1.500 0 0 1 0-3zm8 0a1.500 1.500 0 1 1 0 3 1.500 1.500 0 0 1 0-3z"
            }
            Sign::Pencil => {
                "M4 16.500 15.500 5l3.500 3.500L7.500 20H4zM16.500 4l1.500-1.500L21.500 6 20 7.500z"
            }
            Sign::Hand => "M3 9l9-5 9 5-9 5zM7 13v4c3 2 7 2 10 0v-4l-5 2.800zM20 11h1v6h-1z",
            Sign::Close => {
                "M6.400 5 12 10.600 17.600 5 19 6.400 13.400 12l5.600 5.600-1.400 1.400-5.600-5.600L6.400 19 5 17.600 10.600 12 5 6.400z"
            }
        }
    }
}

/// A button that is a sign.
pub(crate) fn sign(
    id: &'static str,
    label: &'static str,
    sign: Sign,
    off: bool,
    go: Callback<()>,
) -> Html {
    html! {
        <button type="button" class="sign" aria-label={label} title={label} data-testid={id} disabled={off}
            onclick={go.reform(|_| ())}>
            { picture(sign) }
        </button>
    }
}

/// A sign alone.
pub(crate) fn picture(sign: Sign) -> Html {
    html! { <svg viewBox="0 0 24 24" aria-hidden="true"><path d={sign.path()} /></svg> }
}
