//! Packed files: all members are read, or the file is refused in words and nothing of it is kept.

use super::{HEADER, PRE, commands, csv, file, post};
use flate2::{Compression, write::GzEncoder};
use groundling::corpus::limits::{MAX_EMPTY_MEMBERS, MAX_FILE_BYTES};
use groundling::corpus::{Options, Reading};
use std::io::{Cursor, Write};

fn packed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

fn text(rows: usize) -> String {
    let post = post();
    let names: Vec<String> = (0..rows).map(|n| format!("go east {n}")).collect();
    let all: Vec<[&str; 6]> = names.iter().map(|name| ["A", PRE, &post, name, "x", ""]).collect();
    let rows: Vec<&[&str]> =
        std::iter::once(HEADER.as_slice()).chain(all.iter().map(|row| row.as_slice())).collect();
    file(&rows, "\n")
}

#[test]
fn all_members_of_a_packed_file_are_read() {
    let text = text(40);
    let (plain, _) = csv(&text);
    let (one, two) = text.as_bytes().split_at(text.len() / 3);
    let zeros = |n: usize| vec![0; n];
    for (what, bytes) in [
        ("one", packed(text.as_bytes())),
        ("cat a.gz b.gz", [packed(one), packed(two)].concat()),
        ("with an empty one, as block gzip ends", [packed(one), packed(two), packed(b"")].concat()),
        ("padded", [packed(text.as_bytes()), zeros(512)].concat()),
        ("padded between", [packed(one), zeros(20_000), packed(two), zeros(1)].concat()),
        ("of a line each", text.split_inclusive('\n').flat_map(|l| packed(l.as_bytes())).collect()),
    ] {
        let (corpus, flaws) = csv(&bytes);
        assert_eq!(flaws, [], "{what}");
        assert_eq!(corpus, plain, "{what}");
    }
    // Two whole files, each with its header.
    let twice = [packed(text.as_bytes()), packed(text.as_bytes())].concat();
    let (corpus, flaws) = csv(&twice);
    assert_eq!((flaws, corpus.left_out, corpus.examples.len()), (vec![], 0, 80));
    let lines = b"{\"command\": \"go\", \"pairs\": []}";
    assert!(csv(packed(lines)).1[0].to_string().contains("pairs"), "JSON is found out, too");
}

#[test]
fn a_packed_file_is_read_to_its_end_or_refused() {
    let bytes = packed(text(40).as_bytes());
    let mut wrong_sum = bytes.clone();
    let end = wrong_sum.len() - 6;
    wrong_sum[end] ^= 1;
    let mut flipped = bytes.clone();
    flipped[bytes.len() / 2] ^= 0xFF;
    let damaged = "this gzip file is cut short or damaged; pack it anew, or give the file unpacked";
    for (what, bytes, said) in [
        ("cut", bytes[..bytes.len() - 9].to_vec(), damaged),
        ("cut in its sum", bytes[..bytes.len() - 1].to_vec(), damaged),
        ("cut in the second", [bytes.clone(), bytes[..bytes.len() / 2].to_vec()].concat(), damaged),
        ("wrong sum", wrong_sum, damaged),
        ("flipped", flipped, damaged),
        ("text behind", [bytes.clone(), b"more".to_vec()].concat(), damaged),
        ("only its first bytes", vec![0x1F, 0x8B], damaged),
        ("twice", packed(&bytes), "this file is packed twice; unpack it once"),
        ("nothing inside", packed(b""), "the file is empty"),
        ("empty members", packed(b"").repeat(MAX_EMPTY_MEMBERS + 1), damaged),
    ] {
        let (corpus, flaws) = csv(&bytes);
        assert!(corpus.examples.is_empty() && corpus.rows() == 0, "{what}: nothing is kept");
        assert_eq!(flaws.len(), 1, "{what}: {flaws:?}");
        assert!(flaws[0].to_string().starts_with(said), "{what}: {}", flaws[0]);
    }
}

#[test]
fn what_unpacks_beyond_the_limit_is_refused_before_it_is_all_there() {
    let mut bomb = GzEncoder::new(Vec::new(), Compression::fast());
    bomb.write_all(text(3).as_bytes()).unwrap();
    let blank = vec![b'\n'; 1 << 20];
    (0..=MAX_FILE_BYTES >> 20).for_each(|_| bomb.write_all(&blank).unwrap());
    let bomb = bomb.finish().unwrap();
    assert!(bomb.len() < 1 << 20, "it is small: {}", bomb.len());
    let (corpus, flaws) = csv(&bomb);
    assert_eq!(
        flaws[0].to_string(),
        "the file unpacks to more than 64 MB; split it, and give all parts"
    );
    assert_eq!(corpus.rows(), 0);
}

#[test]
fn progress_counts_what_is_packed() {
    let bytes = packed(text(2_000).as_bytes());
    let mut reading = Reading::new(Cursor::new(&bytes), Options::default()).unwrap();
    let (mut before, mut seen) = (0, Vec::new());
    while reading.step() {
        assert!(reading.bytes() >= before && reading.bytes() <= bytes.len() as u64);
        if reading.bytes() > before {
            seen.push(reading.bytes());
        }
        before = reading.bytes();
    }
    assert_eq!(reading.bytes(), bytes.len() as u64);
    let (corpus, _) = reading.end();
    assert_eq!(commands(&corpus).len(), 2_000);
    assert!(seen.len() >= 2, "{seen:?}");
}
