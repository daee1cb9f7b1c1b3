//! What is read of a file at most, in one place: a file beyond one of these is refused in words, and nothing of it is
//! used.

/// The largest file that is read, in bytes; of a packed one, what it unpacks to.
pub const MAX_FILE_BYTES: u64 = 64 << 20;
/// The largest cell (or state of JSON) that is read, in bytes.
pub const MAX_CELL_BYTES: usize = 1 << 20;
/// The longest object of JSON that is read, in bytes.
pub const MAX_OBJECT_BYTES: usize = 8 * MAX_CELL_BYTES;
/// The most brackets of JSON that may be open at once.
pub const MAX_DEPTH: usize = 100;
/// The most columns of a table, and keys of an object that is a row: the columns of a spreadsheet.
pub const MAX_COLUMNS: usize = 16_384;
/// The most rows that are read from one file.
pub const MAX_ROWS: usize = 100_000;
/// The longest command that is kept, in characters; how many words a parser takes is the parser's affair.
pub const MAX_COMMAND_CHARS: usize = 2_000;
/// The most demonstrations of one row.
pub const MAX_PAIRS: usize = 100;
/// The most flaws of a file that are kept; its rows are counted all the same.
pub const MAX_FLAWS: usize = 1_000;
/// The most bytes of a file's bad rows that are kept to be mended.
pub const MAX_BAD_BYTES: usize = 16 << 20;
/// The most members of a packed file in a row that hold nothing.
pub const MAX_EMPTY_MEMBERS: usize = 10_000;
