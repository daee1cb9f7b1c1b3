//! Looks at rows as a person wants.

use super::action::Look;
use super::sheet::{Open, Sheet};
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{Request, View};
use std::rc::Rc;

/// Does what a person wants.
pub fn look(sheet: &mut Sheet, desk: &mut Desk, action: Look) {
    let table = &mut sheet.table;
    match action {
        Look::Text(text) => table.look(|view| view.text = text),
        Look::Task(task) => table.look(|view| view.task = task),
        Look::Worker(worker) => table.look(|view| view.worker = worker),
        Look::Status(status) => table.look(|view| view.status = status),
        Look::Outcome(outcome) => table.look(|view| view.outcome = outcome),
        Look::Rule(rule) => table.look(|view| view.rule = rule),
        Look::Half(half) => table.look(|view| view.half = half),
        Look::All => table.look(|view| {
            let (sort, descending) = (view.sort, view.descending);
            *view = View { sort, descending, ..View::default() };
        }),
        Look::Sort(sort) => table.look(|view| {
            view.descending = view.sort == sort && !view.descending;
            view.sort = sort;
        }),
        Look::Scrolled(top, count) => table.scrolled(top, count),
        Look::Move(by) => table.go(i64::from(table.current) + by),
        Look::End(is_last) => table.go(if is_last { i64::MAX } else { 0 }),
        Look::Open(place) => {
            table.current = place;
            turn(sheet, desk);
        }
        Look::OpenHere => turn(sheet, desk),
        Look::PickHere => {
            if let Some(row) = table.line(table.current).map(|line| line.row) {
                let is_picked = table.picked.contains(&row);
                table.pick(row, !is_picked);
            }
        }
        Look::Row(row) => {
            table.look(|view| *view = View::default());
            table.go(row.into());
            sheet.open = Some(open(row, desk, sheet.is_audited));
            desk.want(Effect::Reveal("row-title"));
        }
        Look::Close => sheet.open = None,
        Look::Pick(row, is_picked) => table.pick(row, is_picked),
        Look::PickNone => table.picked = Rc::default(),
    }
    ask(sheet, desk);
}

/// Asks for the rows in sight, if they are not known.
pub fn ask(sheet: &mut Sheet, desk: &mut Desk) {
    if let Some((view, offset, count)) = sheet.table.ask() {
        desk.ask(Request::Window { view, offset, count });
    }
}

/// Opens the row that the keyboard is at, or closes it.
fn turn(sheet: &mut Sheet, desk: &mut Desk) {
    let row = sheet.table.line(sheet.table.current).map(|line| line.row);
    let is_open = sheet.open.as_ref().map(|open| open.row) == row;
    sheet.open = row.filter(|_| !is_open).map(|row| open(row, desk, sheet.is_audited));
    desk.want(Effect::Reveal("row-title"));
}

/// Asks for all that there is to say of a row.
pub fn open(row: u32, desk: &mut Desk, is_audited: bool) -> Open {
    desk.ask(Request::ShowRow { row: row as usize });
    if is_audited {
        desk.ask(Request::ReadRow { row });
    }
    Open { row, pairs: None, reading: None }
}
