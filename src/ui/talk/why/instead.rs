//! What a task over time demands on the way where that leaves none, and what can be done instead.

use super::help::Help;
use super::message::{Message, message};
use crate::ui::talk::words::Text;
use crate::worker::protocol::PlanText;

/// What a task over time demands on the way that leaves none, or is broken, and what could be done instead.
pub(super) fn instead(text: &Text, plan: &PlanText) -> Option<Message> {
    let demands = &plan.instead.as_ref()?.demands;
    let (kind, (what, fix)) = match plan.reason.as_deref()? {
        "unreachable" => ("blocked", text.why.blocked),
        "already_broken" => ("already_broken", text.why.already_broken),
        "broken" => ("broken", text.why.broken),
        _ => return None,
    };
    let words: Vec<String> = demands.iter().map(|one| text.phrases.claim(one)).collect();
    let help = Help::Instead(demands.clone(), kind != "blocked");
    Some(message(kind, (what(&text.phrases.list(&words)), fix), None, vec![help]))
}
