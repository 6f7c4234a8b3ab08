//! All use of threads is confined to this module.
//!
//! Work is cut into tasks by index. Where a sum is formed, the cut does not depend on the number of
//! threads, so the bits of a result do not depend on it either. Only `rayon::join` is used: it runs in
//! the caller's pool and allocates nothing there.
//!
//! The way into a pool is [`enter`], and [`enter_with`] for work on more than [`SERIAL_CELL_LIMIT`] cells. Everything
//! else shares its tasks in the pool that its thread belongs to, and on a thread of no pool does them one after the other.

pub(crate) mod layout;
pub mod ranks;
pub(crate) mod reduce;

use std::ops::Range;
use std::sync::OnceLock;
#[cfg(feature = "parallel")]
use std::sync::atomic::{AtomicBool, Ordering};

use crate::error::Result;

/// Samples per task of vector work; the summation tree follows these chunks.
pub(crate) const CHUNK: usize = 4096;

/// Cells up to which all work on a contact stays on the thread that calls, its operators, fields and stresses included: to
/// share it would only take time.
///
/// A program that hands solves to a pool of its own saves the way there for contacts of no more cells. Many contacts in one
/// call ([`History::step_all`](crate::History::step_all)) and stresses at more points than this
/// ([`at_points`](crate::subsurface::at_points)) are shared.
///
/// ```
/// assert!(stickslip::Grid::square(64, 1.0)?.cells() <= stickslip::SERIAL_CELL_LIMIT);
/// # Ok::<(), stickslip::Error>(())
/// ```
pub const SERIAL_CELL_LIMIT: usize = CHUNK;

/// Whether work outside of pools stays on its thread.
#[cfg(feature = "parallel")]
static STAYS_OUTSIDE: AtomicBool = AtomicBool::new(false);

/// Keeps work that is called outside of rayon's pools on the thread that calls, in this process from now on.
///
/// Without this, work on more than [`SERIAL_CELL_LIMIT`] cells that is called outside of a pool goes to rayon's global
/// pool, whose threads are made at its first use. They do not live on in a forked process, which would wait for them for
/// ever: a program that forks, or that is to start no thread, calls this first. Work that is called in a pool, by
/// `rayon::ThreadPool::install`, is shared there as before. Results have the same bits either way.
///
/// ```
/// use stickslip::*;
/// disable_global_pool();
/// let grid = Grid::square(80, 8.0)?;
/// let steel = Material::new(1.0, 0.3)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let ball = surface::sphere(grid, 10.0)?;
/// let contact = NormalProblem::builder(&bodies, &ball, NormalControl::Force(0.5)).build()?.solve()?;
/// assert!((contact.force() / 0.5 - 1.0).abs() < 1e-9);
/// # Ok::<(), Error>(())
/// ```
pub fn disable_global_pool() {
    #[cfg(feature = "parallel")]
    STAYS_OUTSIDE.store(true, Ordering::Relaxed);
}

/// Whether tasks are shared: the thread belongs to a pool, which has others.
fn is_in_pool() -> bool {
    #[cfg(feature = "parallel")]
    {
        rayon::current_thread_index().is_some()
    }
    #[cfg(not(feature = "parallel"))]
    {
        false
    }
}

/// Whether work on this thread has no pool to go to.
fn is_alone() -> bool {
    #[cfg(feature = "parallel")]
    {
        !is_in_pool() && STAYS_OUTSIDE.load(Ordering::Relaxed)
    }
    #[cfg(not(feature = "parallel"))]
    {
        true
    }
}

/// Runs both, in a pool at once if a thread is free there.
fn join<A: Send, B: Send>(a: impl FnOnce() -> A + Send, b: impl FnOnce() -> B + Send) -> (A, B) {
    if is_in_pool() {
        shared(a, b)
    } else {
        let a = a();
        (a, b())
    }
}

/// Runs both in the caller's pool. What they are is hidden from rayon, whose part is then compiled once
/// and not once for each of the many things that run.
fn shared<A: Send, B: Send>(a: impl FnOnce() -> A + Send, b: impl FnOnce() -> B + Send) -> (A, B) {
    let (mut a, mut b) = (Some(a), Some(b));
    let (mut from_a, mut from_b) = (None, None);
    join_tasks(
        &mut || {
            from_a = a.take().map(|a| a());
        },
        &mut || from_b = b.take().map(|b| b()),
    );
    let results = from_a.zip(from_b);
    results.expect("each task runs once")
}

#[cfg(feature = "parallel")]
fn join_tasks(a: &mut (dyn FnMut() + Send), b: &mut (dyn FnMut() + Send)) {
    rayon::join(a, b);
}

#[cfg(not(feature = "parallel"))]
fn join_tasks(a: &mut (dyn FnMut() + Send), b: &mut (dyn FnMut() + Send)) {
    a();
    b();
}

/// Runs work inside the caller's pool, where cutting it further costs next to nothing; on a thread of no pool in the
/// global one, unless the program [avoids](disable_global_pool) it.
pub(crate) fn enter<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    if is_in_pool() || is_alone() {
        work()
    } else {
        shared(work, || ()).0
    }
}

/// A useful number of simultaneous tasks; only for work whose result does not depend on how it is cut.
pub(crate) fn lanes() -> usize {
    if is_in_pool() { 4 * threads() } else { 1 }
}

/// Threads of the pool that [`enter`] goes to.
pub(crate) fn threads() -> usize {
    #[cfg(feature = "parallel")]
    if !is_alone() {
        return rayon::current_num_threads();
    }
    1
}

/// Runs work on a pool of so many threads of its own, which it may block.
///
/// # Panics
/// If the threads cannot be made.
pub(crate) fn apart<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    #[cfg(feature = "parallel")]
    {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("the threads of a rank").install(work)
    }
    #[cfg(not(feature = "parallel"))]
    {
        let _ = threads;
        work()
    }
}

/// Whether work on so many cells is too short to share.
pub(crate) fn is_short(cells: usize) -> bool {
    cells <= SERIAL_CELL_LIMIT
}

/// [`enter`] for work on so many cells, which is done at once where it is too short to share.
pub(crate) fn enter_with<T: Send>(cells: usize, work: impl FnOnce() -> T + Send) -> T {
    if is_short(cells) { work() } else { enter(work) }
}

/// Data that can be cut at a task boundary.
pub(crate) trait Split: Send + Sized {
    /// The first `tasks` tasks, and the rest.
    fn split(self, tasks: usize) -> (Self, Self);
}

impl Split for () {
    fn split(self, _: usize) -> (Self, Self) {
        ((), ())
    }
}

/// A mutable slice of which each task owns `width` consecutive items (the last task may own fewer).
#[derive(Debug)]
pub(crate) struct Blocks<'a, T> {
    pub(crate) items: &'a mut [T],
    pub(crate) width: usize,
}

impl<T: Send> Split for Blocks<'_, T> {
    fn split(self, tasks: usize) -> (Self, Self) {
        let middle = (tasks * self.width).min(self.items.len());
        let (low, high) = self.items.split_at_mut(middle);
        let width = self.width;
        (Self { items: low, width }, Self { items: high, width })
    }
}

/// A mutable slice of which task `t` owns the items `starts[t]..starts[t + 1]`.
#[derive(Debug)]
pub(crate) struct UnevenChunks<'a, T> {
    pub(crate) items: &'a mut [T],
    pub(crate) starts: &'a [usize],
}

impl<T: Send> Split for UnevenChunks<'_, T> {
    fn split(self, tasks: usize) -> (Self, Self) {
        let (low, high) = self.items.split_at_mut(self.starts[tasks] - self.starts[0]);
        (
            Self {
                items: low,
                starts: &self.starts[..=tasks],
            },
            Self {
                items: high,
                starts: &self.starts[tasks..],
            },
        )
    }
}

impl<A: Split, B: Split> Split for (A, B) {
    fn split(self, tasks: usize) -> (Self, Self) {
        let ((a, c), (b, d)) = (self.0.split(tasks), self.1.split(tasks));
        ((a, b), (c, d))
    }
}

impl<A: Split, B: Split, C: Split> Split for (A, B, C) {
    fn split(self, tasks: usize) -> (Self, Self) {
        let ((a, b), c) = (self.0.split(tasks), (self.1, self.2).split(tasks));
        ((a, c.0.0, c.0.1), (b, c.1.0, c.1.1))
    }
}

impl<A: Split, const N: usize> Split for [A; N] {
    fn split(self, tasks: usize) -> (Self, Self) {
        let mut high = [const { None }; N];
        let mut places = high.iter_mut();
        let low = self.map(|part| {
            let (low, rest) = part.split(tasks);
            if let Some(place) = places.next() {
                *place = Some(rest);
            }
            low
        });
        // `map` visits each part once, and there is a place for each.
        (low, high.map(|part| part.expect("every part was split")))
    }
}

/// What a task does with its part of the data. Behind a reference of this type, the tree of tasks is compiled once for each
/// kind of data and not once for each work: a call costs nothing beside the work of a chunk.
pub(crate) type Work<'a, D, T> = dyn Fn(usize, D) -> T + Sync + 'a;

/// How two results become one.
pub(crate) type Combine<'a, T> = dyn Fn(T, T) -> T + Sync + 'a;

/// Runs `work(task, its part of data)` for every task and combines the results pairwise in a
/// fixed tree, which gives the same bits on any number of threads. On a thread of no pool it stays there.
pub(crate) fn sweep<D: Split, T: Send>(
    tasks: Range<usize>,
    data: D,
    work: &Work<'_, D, T>,
    combine: &Combine<'_, T>,
) -> T {
    if tasks.len() <= 1 {
        return work(tasks.start, data);
    }
    let [(first, low), (second, high)] = halves(tasks, data);
    let (low, high) = join(
        || sweep(first, low, work, combine),
        || sweep(second, high, work, combine),
    );
    combine(low, high)
}

/// [`sweep`] on the calling thread alone.
pub(crate) fn in_turn<D: Split, T>(
    tasks: Range<usize>,
    data: D,
    work: &dyn Fn(usize, D) -> T,
    combine: &dyn Fn(T, T) -> T,
) -> T {
    if tasks.len() <= 1 {
        return work(tasks.start, data);
    }
    let [(first, low), (second, high)] = halves(tasks, data);
    let low = in_turn(first, low, work, combine);
    combine(low, in_turn(second, high, work, combine))
}

/// [`sweep`] of work on so many cells, on the calling thread alone where it is too short to share.
pub(crate) fn sweep_cells<D: Split, T: Send>(
    cells: usize,
    tasks: Range<usize>,
    data: D,
    work: &Work<'_, D, T>,
    combine: &Combine<'_, T>,
) -> T {
    if is_short(cells) {
        in_turn(tasks, data, work, combine)
    } else {
        sweep(tasks, data, work, combine)
    }
}

fn halves<D: Split>(tasks: Range<usize>, data: D) -> [(Range<usize>, D); 2] {
    let half = tasks.len() / 2;
    let middle = tasks.start + half;
    let (low, high) = data.split(half);
    [(tasks.start..middle, low), (middle..tasks.end, high)]
}

/// A slice of vector work with one chunk per task.
pub(crate) fn blocks<T>(items: &mut [T]) -> Blocks<'_, T> {
    Blocks {
        items,
        width: CHUNK,
    }
}

/// [`sweep`] over chunks of `0..len`, read-only: `fold(index range) -> T`.
pub(crate) fn fold<T: Send>(
    len: usize,
    leaf: impl Fn(Range<usize>) -> T + Sync,
    combine: impl Fn(T, T) -> T + Sync,
) -> T {
    sweep(
        0..len.div_ceil(CHUNK),
        (),
        &|task, ()| leaf(task * CHUNK..((task + 1) * CHUNK).min(len)),
        &combine,
    )
}

/// [`fold`] over the rows of a field of `width` columns: `leaf(row range) -> T`.
pub(crate) fn fold_rows<T: Send>(
    rows: usize,
    width: usize,
    leaf: impl Fn(Range<usize>) -> T + Sync,
    combine: impl Fn(T, T) -> T + Sync,
) -> T {
    let per_task = (CHUNK / width).max(1);
    let rows_of = |task: usize| task * per_task..((task + 1) * per_task).min(rows);
    let leaf = |task: usize, ()| leaf(rows_of(task));
    sweep(0..rows.div_ceil(per_task), (), &leaf, &combine)
}

/// Runs `update(first index, chunk)` on chunks of one slice.
pub(crate) fn update<T: Send>(items: &mut [T], update: impl Fn(usize, &mut [T]) + Sync) {
    let tasks = items.len().div_ceil(CHUNK);
    sweep(
        0..tasks,
        blocks(items),
        &|task, block: Blocks<'_, T>| update(task * CHUNK, block.items),
        &|(), ()| (),
    );
}

/// Copies one slice into another of its length.
pub(crate) fn copy(from: &[f64], to: &mut [f64]) {
    update(to, |first, chunk| {
        chunk.copy_from_slice(&from[first..first + chunk.len()]);
    });
}

/// Runs `update(row, its items)` on the rows of a field of `width` columns.
pub(crate) fn rows<T: Send>(
    items: &mut [T],
    width: usize,
    update: impl Fn(usize, &mut [T]) + Sync,
) {
    let per_task = (CHUNK / width).max(1);
    let tasks = (items.len() / width).div_ceil(per_task);
    let data = Blocks {
        items,
        width: per_task * width,
    };
    let work = |task: usize, block: Blocks<'_, T>| {
        for (row, items) in (task * per_task..).zip(block.items.chunks_exact_mut(width)) {
            update(row, items);
        }
    };
    sweep(0..tasks, data, &work, &|(), ()| ());
}

/// The value in the cell, computed outside the cell's lock: a thread of the caller's pool that waits
/// for the lock, while the tasks of the computing thread wait for that thread, would never wake. Two
/// threads that arrive together both compute it, and one result is kept.
pub(crate) fn get_or_make<T>(cell: &OnceLock<T>, make: impl FnOnce() -> Result<T>) -> Result<&T> {
    if let Some(value) = cell.get() {
        return Ok(value);
    }
    let value = make()?;
    Ok(cell.get_or_init(|| value))
}
