//! The rosbridge of the tests' own as a program, for tests that are not Rust: it says where it listens and what comes in, a
//! JSON value a line, and does what it is told, a line each (`mute`, `cut`, `close`, `say TEXT`, `carry X Y SIDE`, `report` …).
#![cfg_attr(
    not(target_arch = "wasm32"),
    allow(clippy::print_stdout, reason = "its output is what it is for")
)]

#[cfg(not(target_arch = "wasm32"))]
#[path = "peer.rs"]
mod peer;

#[cfg(not(target_arch = "wasm32"))]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    use groundling::domain::text;
    use serde_json::json;
    use std::io::BufRead;

    let world = text::read_legal(include_str!("../../assets/worlds/three-rooms.txt"))?;
    let port = std::env::args().nth(1).and_then(|port| port.parse().ok()).unwrap_or(0);
    let peer = peer::Peer::start(&world, port)?;
    println!("{}", json!({ "listening": peer.address() }));
    let told = peer.clone();
    std::thread::spawn(move || {
        let mut at = 0;
        loop {
            for (from, frame) in told.log(at) {
                println!("{}", json!({ "from": from, "frame": frame }));
                at += 1;
            }
            std::thread::sleep(std::time::Duration::from_millis(5));
        }
    });
    for line in std::io::stdin().lock().lines() {
        if let Some(report) = peer.command(&line?) {
            println!("{}", json!({ "report": report }));
        }
    }
    Ok(())
}

#[cfg(target_arch = "wasm32")]
fn main() {}
