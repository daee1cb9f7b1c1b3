//! Mechanical Turk's batch-results CSV with the quirks of real files: columns in any order and
//! found by name, rows without their last cells, answers of crowd-html forms as JSON in one cell.

use super::admit::{Options, decision, empty, something};
use super::cells::Cells;
use super::draft::{Draft, Found, Place, Shown};
use super::example::{Decision, Row};
use super::flaw::{Flaw, Wrong, some};
use super::form::{form_command, said};
use super::formula::unguarded;
use super::header::Header;
use super::limits::{MAX_CELL_BYTES, MAX_COLUMNS};
use super::mapping::Mapping;
use super::record::{Fault, Record, Records, Step};
use super::role::COMMAND;
use super::source::Source;
use std::io::Read;

/// A reader of a batch-results file, row by row.
pub(super) struct Reader<R> {
    records: Records<R>,
    options: Options,
    header: Option<Header>,
    /// What stands before the rows, as it stands in the file.
    head: Vec<u8>,
}

impl<R: Read> Reader<R> {
    /// A reader at the beginning of a file.
    pub(super) fn new(source: Source<R>, options: Options) -> Self {
        Reader { records: Records::new(source), options, header: None, head: Vec::new() }
    }

    /// The columns, once they are read.
    pub(super) fn header(&self) -> Option<&Header> {
        self.header.as_ref()
    }

    /// What stands before the rows, as it stands in the file, once it is read.
    pub(super) fn head(&self) -> &[u8] {
        &self.head
    }

    /// Bytes of the file that were read so far, for progress.
    pub(super) fn bytes(&self) -> u64 {
        self.records.bytes()
    }

    /// Goes on by a bounded part.
    ///
    /// # Errors
    /// Why the file cannot be used.
    pub(super) fn step(&mut self) -> Result<Found, Flaw> {
        let fault = |fault: Fault| Flaw::of_file(refusal(&fault));
        match (self.records.step().map_err(fault)?, &self.header) {
            (Step::Working, _) => Ok(Found::Nothing),
            (Step::Record(record), None) => {
                self.header = Some(header(&record, &self.options.mapping)?);
                self.head = [self.records.said(), &record.raw].concat();
                Ok(Found::Nothing)
            }
            (Step::Record(record), Some(header)) if is_header(header, &record) => {
                again(header, &record).map(|()| Found::Nothing)
            }
            (Step::Record(mut record), Some(header)) => {
                if let Some(flaw) = misshapen(header, &record) {
                    if record.lines > 1 {
                        self.records.resume_at_second_line().map_err(fault)?;
                        let first = record.raw.iter().position(|&byte| byte == b'\n');
                        record.raw.truncate(first.map_or(usize::MAX, |end| end + 1));
                    }
                    return Ok(Found::Row(Row::bad(flaw, record.raw)));
                }
                Ok(row(header, record, &self.options))
            }
            (Step::Unclosed(line, raw), header) => {
                let wrong = Wrong::with_mend(
                    "a quote opened in this row is never closed",
                    "close it, or double it if it belongs to the text",
                );
                let flaw = Flaw::of_row(line, None, wrong);
                if header.is_none() { Err(flaw) } else { Ok(Found::Row(Row::bad(flaw, raw))) }
            }
            (Step::Over, None) => Err(Flaw::of_file(empty())),
            (Step::Over, Some(_)) => Ok(Found::Over),
        }
    }
}

/// What to do about a file that cannot be read to its end.
fn refusal(fault: &Fault) -> Wrong {
    let mend = match fault {
        Fault::Unreadable(fault) => return fault.wrong(),
        Fault::Wide => "see whether this is a corpus, and one row a line",
        Fault::Hopeless => "every quote that opens must close, and one inside a cell is doubled",
    };
    Wrong::with_mend(fault.to_string(), mend)
}

fn header(record: &Record, mapping: &Mapping) -> Result<Header, Flaw> {
    let of_header = |wrong: Wrong| Flaw { line: record.line, ..Flaw::of_file(wrong) };
    if !record.cut.is_empty() {
        let wrong = Wrong::with_mend(
            "the first line is no header: a cell of it is too large",
            "see whether this is a corpus, and one row a line",
        );
        return Err(of_header(wrong));
    }
    Header::new(names(record).map(str::to_owned).collect(), mapping).map_err(of_header)
}

/// The cells of a record as names of columns. Another file's mark may stand before the first, and before its quotes.
fn names(record: &Record) -> impl Iterator<Item = &str> {
    record.cells.iter().map(|name| match name.strip_prefix('\u{feff}') {
        Some(first) => first.trim_matches('"').trim(),
        None => name.trim(),
    })
}

/// Whether a record is a header and no row: it names a column of states, where a state would stand.
fn is_header(header: &Header, record: &Record) -> bool {
    let pre = header.pairs.first().map(|(pre, _)| *pre);
    let first = pre.or(header.runs.first().copied()).map(|at| header.name(at));
    first.is_some_and(|first| names(record).any(|name| name == first))
}

/// Two files in one: the second begins with the header again, which is no row. With other columns it is another table.
fn again(header: &Header, record: &Record) -> Result<(), Flaw> {
    let named = |name: &&str| !name.is_empty();
    let first: Vec<&str> = header.columns.iter().map(String::as_str).filter(named).collect();
    let second: Vec<&str> = names(record).filter(named).collect();
    if first == second {
        return Ok(());
    }
    let (more, lacks) = (beyond(&second, &first), beyond(&first, &second));
    let how = match (more.is_empty(), lacks.is_empty()) {
        (true, true) => "in another order".to_owned(),
        (false, _) => format!("with other columns: {more}"),
        (true, false) => format!("without {lacks}"),
    };
    let (line, what) = (record.line, format!("a header stands here again, {how}"));
    let mend = "split the file before this line, and give both parts";
    Err(Flaw { line, ..Flaw::of_file(Wrong::with_mend(what, mend)) })
}

/// The names that the others do not have.
fn beyond(names: &[&str], others: &[&str]) -> String {
    some(names.iter().copied().filter(|name| !others.contains(name)))
}

/// What a record says.
fn row(header: &Header, mut record: Record, options: &Options) -> Found {
    let raw = std::mem::take(&mut record.raw);
    let cell = |at: Option<usize>| record.cells.get(at?);
    let decided = decision(cell(header.status), cell(header.approve), cell(header.reason));
    if !options.with_rejected && matches!(decided, Decision::Rejected(_)) {
        return Found::Row(Box::new(Row { rejected: true, ..Row::default() }));
    }
    let mut draft = Draft::new(record.line, raw);
    draft.decision = decided;
    for &at in record.not_text.iter().filter(|&&at| header.is_read(at)) {
        let wrong = Wrong::with_mend("the cell is not UTF-8 text", "save the file as CSV in UTF-8");
        draft.blame(Some(header.name(at)), wrong);
    }
    for &at in &record.cut {
        let wrong = format!("the cell is larger than {} MB", MAX_CELL_BYTES >> 20);
        if header.is_read(at) {
            draft.blame(Some(header.name(at)), wrong);
        } else {
            draft.wonder(Some(header.name(at)), format!("{wrong} (left empty)"));
        }
    }
    let is_bad = |at: Option<usize>| {
        let is_in = |all: &[usize]| at.is_some_and(|at| all.binary_search(&at).is_ok());
        is_in(&record.not_text) || is_in(&record.cut)
    };
    if !is_bad(header.command) && !is_bad(header.form) {
        let (column, command) = command(header, &record);
        draft.say(column, command);
    }
    let text = |at: usize| cell(Some(at)).and_then(something).unwrap_or_default();
    let place = |at: usize| Place { column: header.name(at).to_owned(), text: text(at).to_owned() };
    let mut shown = Vec::new();
    // A row may have fewer demonstrations than the file has columns.
    let runs = header.runs.iter().copied().filter(|&at| !is_bad(Some(at)) && !text(at).is_empty());
    let runs: Vec<Shown> = runs.map(|at| Shown::Run(place(at))).collect();
    for &(pre, post) in &header.pairs {
        if is_bad(Some(pre)) || is_bad(Some(post)) {
            continue;
        }
        if text(pre).is_empty() && text(post).is_empty() && !(shown.is_empty() && runs.is_empty()) {
            continue;
        }
        if record.cells.len() <= pre.max(post) {
            let (got, want) = (record.n_cells, header.columns.len());
            let wrong = format!("the row ends after {got} of {want} cells");
            draft.blame(Some(header.name(pre.max(post))), wrong);
            continue;
        }
        shown.push(Shown::Pair(place(pre), place(post)));
    }
    shown.extend(runs);
    if let (true, Some(&first), true) =
        (shown.is_empty(), header.runs.first(), header.pairs.is_empty())
    {
        draft.blame(Some(header.name(first)), "the row shows nothing".to_owned());
    }
    draft.show(shown);
    let owned = |at: Option<usize>| cell(at).map(|cell| unguarded(cell).to_owned());
    (draft.id, draft.task, draft.worker) =
        (owned(header.id), owned(header.task), owned(header.worker));
    let kept = header.roles.iter().enumerate().filter(|(_, role)| !role.is_kept_apart());
    draft.rest = kept.map(|(at, _)| cell(Some(at)).unwrap_or_default()).collect::<Cells>();
    Found::Draft(Box::new(draft))
}

/// Why a record is not this table's: its quotes or commas are wrong.
fn misshapen(header: &Header, record: &Record) -> Option<Flaw> {
    let want = header.columns.len();
    if let Some(at) = record.stray {
        // As R's write.table does.
        let has_backslash = record.cells.get(at).is_some_and(|text| text.contains('\\'));
        let mend = match has_backslash {
            true => "double the quotes that stand in the text (R: write.csv does)",
            false => "a quote is missing, or stands in the text and must be doubled",
        };
        let wrong = Wrong::with_mend("text follows a closing quote", mend);
        return Some(Flaw::of_row(record.line, Some(header.name(at)), wrong));
    }
    // Commas too many at the end of a row are no cells.
    let got = record.n_cells.min(MAX_COLUMNS);
    let is_empty = |at: usize| record.cells.get(at).is_none_or(|text| text.trim().is_empty());
    (!(want..got).all(is_empty)).then(|| {
        let wrong = format!("the row has {} cells, the header {want}", record.n_cells);
        let wrong = Wrong::with_mend(wrong, "quote the cells that hold a comma");
        Flaw::of_row(record.line, None, wrong)
    })
}

/// The command of a row, and the column that it stands in or should.
fn command<'a>(header: &'a Header, record: &Record) -> (&'a str, Result<String, Wrong>) {
    let text = |at: Option<usize>| record.cells.get(at?).and_then(something);
    let name = |at: Option<usize>| at.map_or(COMMAND, |at| header.name(at));
    match (text(header.command), text(header.form)) {
        (Some(command), _) => (name(header.command), said(unguarded(command))),
        (None, Some(form)) => (name(header.form), form_command(form)),
        (None, None) => (name(header.command.or(header.form)), Ok(String::new())),
    }
}
