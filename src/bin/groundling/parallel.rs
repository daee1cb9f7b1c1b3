//! Runs of an experiment side by side, a thread each: every run is a pure function, and results are put together
//! in the order of the runs. Wall and CPU time are taken here, where there are clocks.

#[cfg(not(target_arch = "wasm32"))]
use cpu_time::ThreadTime as Cpu;
use groundling::ccg::Model;
use groundling::learn::Ties;
use groundling::learn::experiment::{Event, Outcome, Run, Running};
use std::io::{self, Write};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Instant;
#[cfg(target_arch = "wasm32")]
use std::time::Instant as Cpu;

/// What a run found, and what it took.
pub(crate) struct Finished {
    /// What was run.
    pub(crate) run: Run,
    /// What it found.
    pub(crate) outcome: Outcome,
    /// Training.
    pub(crate) learning: Seconds,
    /// Judging.
    pub(crate) judging: Seconds,
}

/// What a part of a run took.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Seconds {
    /// By the clock on the wall.
    pub(crate) wall: f64,
    /// Of one processor.
    pub(crate) cpu: f64,
}

/// Two clocks, both running.
struct Clocks(Instant, Cpu);

impl Clocks {
    fn start() -> Self {
        Clocks(Instant::now(), Cpu::now())
    }

    fn read(&self) -> Seconds {
        Seconds { wall: self.0.elapsed().as_secs_f64(), cpu: self.1.elapsed().as_secs_f64() }
    }
}

/// As many threads as the machine offers.
pub(crate) fn default_jobs() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// All runs, at most `jobs` at a time; what they found, in their order. Progress goes to standard error.
pub(crate) fn run_all(runs: &[Run], seed: &Model, jobs: usize) -> Vec<Finished> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut finished = Vec::new();
        loop {
            let at = next.fetch_add(1, Ordering::Relaxed);
            let Some(run) = runs.get(at) else { return finished };
            finished.extend(run_one(run, seed.clone()).map(|(done, _)| (at, done)));
        }
    };
    let mut finished = thread::scope(|scope| {
        let n_threads = jobs.clamp(1, runs.len().max(1));
        let threads: Vec<_> = (0..n_threads).map(|_| scope.spawn(work)).collect();
        let join = |thread: thread::ScopedJoinHandle<'_, _>| {
            thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
        };
        threads.into_iter().flat_map(join).collect::<Vec<(usize, Finished)>>()
    });
    finished.sort_by_key(|(at, _)| *at);
    finished.into_iter().map(|(_, finished)| finished).collect()
}

/// One run; what it found, and the model.
pub(crate) fn run_one(run: &Run, seed: Model) -> Option<(Finished, Model)> {
    let name = &run.name;
    let say = |text: String| {
        // Standard error may be gone; the work goes on.
        let _ = writeln!(io::stderr(), "{name}: {text}");
    };
    let clocks = Clocks::start();
    let mut running = Running::new(run.clone(), seed);
    let mut learning = None;
    while !running.is_over() {
        let event = running.step();
        if running.is_trained() && learning.is_none() {
            learning = Some(clocks.read());
        }
        match event {
            Some(Event::Trained(progress, examples))
                if progress.example == examples && progress.epoch <= run.config.epochs =>
            {
                let (epoch, epochs) = (progress.epoch, run.config.epochs);
                let (valid, entries) = (progress.so_far.valid, progress.so_far.entries);
                let seconds = clocks.read().wall;
                say(format!(
                    "epoch {epoch} of {epochs}: {valid} of {examples} commands have a valid parse, \
                     {entries} entries, {seconds:.1} s"
                ));
            }
            Some(Event::Ended { outcome, model }) => {
                let (all, learning) = (clocks.read(), learning.unwrap_or_default());
                let judging =
                    Seconds { wall: all.wall - learning.wall, cpu: all.cpu - learning.cpu };
                let scores = outcome.report.scores(Ties::Abstain);
                say(format!(
                    "F1 {:.3} on {} commands",
                    scores.plain.f1(scores.total),
                    scores.total
                ));
                let (run, outcome) = (run.clone(), *outcome);
                return Some((Finished { run, outcome, learning, judging }, *model));
            }
            _ => {}
        }
    }
    None
}
