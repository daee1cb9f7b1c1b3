//! What an event does that is always the same: one closure for all of them, where one each would weigh a few hundred
//! bytes that every visitor loads.

use yew::Callback;

/// An event that is this action, whatever else it says.
pub fn sends<A: Clone + 'static, E: 'static>(act: &Callback<A>, action: A) -> Callback<E> {
    act.reform(move |_| action.clone())
}
