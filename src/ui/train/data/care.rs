//! Decides something of rows, as a person wants: of those that were picked, or of all that are looked at.

use super::action::Care;
use super::sheet::Sheet;
use crate::ui::train::desk::Desk;
use crate::worker::protocol::{Half, Request, Rules, Verdict, View};

/// Does what a person wants.
pub fn care(sheet: &mut Sheet, desk: &mut Desk, action: Care) {
    let request = match action {
        Care::Approve => decided(sheet, Verdict::Approve),
        Care::Reject(why) => decided(sheet, Verdict::Reject(why)),
        Care::Reopen => decided(sheet, Verdict::Reopen),
        Care::Put(half) => decided(sheet, Verdict::Put(half)),
        Care::Divide(split) => Request::Divide { split },
        Care::HoldOut(file) => {
            let view = View { file: Some(file), ..View::default() };
            Request::DecideAll { view, verdict: Verdict::Put(Half::HeldOut) }
        }
        Care::Undo => Request::Undo,
        Care::Redo => Request::Redo,
        Care::Mark => Request::Mark { rules: Rules::default() },
        Care::Audit => {
            let model = desk.in_use.as_ref().map(|model| model.report.model.clone());
            let request = Request::Audit { model, rules: Rules::default(), known: Vec::new() };
            return desk.send(request, false);
        }
    };
    desk.ask(request);
}

fn decided(sheet: &Sheet, verdict: Verdict) -> Request {
    let table = &sheet.table;
    if table.picked.is_empty() {
        return Request::DecideAll { view: table.view.clone(), verdict };
    }
    Request::Decide { rows: table.picked.iter().copied().collect(), verdict }
}
