//! Thread parallelism of the crate.
//!
//! Work is split into tasks by index. The tasks of a sum do not depend on the number of threads, so results are bitwise
//! identical for any number of threads. Only `rayon::join` is used, which runs in the caller's pool and allocates no memory.
//!
//! Work enters a pool through [`enter`], or through [`enter_with`] if it has more than [`SERIAL_CELL_LIMIT`] cells. All other
//! functions distribute their tasks over the pool of the current thread. On a thread outside a pool they run the tasks
//! sequentially.

pub(crate) mod layout;
pub mod ranks;
pub(crate) mod reduce;

use std::ops::Range;
use std::sync::OnceLock;
#[cfg(feature = "parallel")]
use std::sync::atomic::{AtomicBool, Ordering};

use crate::error::Result;

/// Number of samples in a chunk. Each task of vector work has one chunk, and the leaves of the summation tree are the chunks.
pub(crate) const CHUNK: usize = 4096;

/// Number of cells up to which all work on a contact runs on the calling thread, including its operators, fields and stresses.
/// Sharing so little work between threads would cost more time than it saves.
///
/// A program with its own pool need not enter the pool to solve contacts with at most this number of cells. Only two calls share
/// such work: [`History::step_all`](crate::History::step_all) with many contacts, and [`at_points`](crate::subsurface::at_points)
/// with more points than this number.
///
/// ```
/// assert!(stickslip::Grid::square(64, 1.0)?.cells() <= stickslip::SERIAL_CELL_LIMIT);
/// # Ok::<(), stickslip::Error>(())
/// ```
pub const SERIAL_CELL_LIMIT: usize = CHUNK;

/// Whether work outside of pools stays on its thread.
#[cfg(feature = "parallel")]
static STAYS_OUTSIDE: AtomicBool = AtomicBool::new(false);

/// Keeps work that is called outside of rayon's pools on the calling thread. The setting applies to the whole process and cannot
/// be reversed.
///
/// By default, work on more than [`SERIAL_CELL_LIMIT`] cells that is called outside of a pool runs in rayon's global pool. The
/// threads of the global pool are created at its first use. They do not exist in a forked process, which would wait for them
/// forever. A program that forks, or that must not start threads, calls this function first. Work started inside a pool with
/// `rayon::ThreadPool::install` still runs on the threads of that pool. Results are bitwise identical in both cases.
///
/// ```
/// use stickslip::*;
/// disable_global_pool();
/// let grid = Grid::square(80, 8.0)?;
/// let steel = Material::new(1.0, 0.3)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let ball = surface::sphere(grid, 10.0)?;
/// let contact = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(0.5)).build()?.solve()?;
/// assert!((contact.force() / 0.5 - 1.0).abs() < 1e-9);
/// # Ok::<(), Error>(())
/// ```
pub fn disable_global_pool() {
    #[cfg(feature = "parallel")]
    STAYS_OUTSIDE.store(true, Ordering::Relaxed);
}

/// Returns whether tasks are shared, which is the case on a thread of a pool.
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

/// Returns whether work on this thread must not enter a pool.
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

/// Runs both closures, concurrently if this thread belongs to a pool with a free thread.
fn join<A: Send, B: Send>(a: impl FnOnce() -> A + Send, b: impl FnOnce() -> B + Send) -> (A, B) {
    if is_in_pool() {
        shared(a, b)
    } else {
        let a = a();
        (a, b())
    }
}

/// Runs both closures in the caller's pool. The types of the closures are hidden from rayon, so that its code is compiled once
/// and not once per pair of closures.
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

/// Runs work inside the caller's pool, in which further splitting is cheap. On a thread outside a pool, uses the global pool
/// unless the program has [disabled](disable_global_pool) it.
pub(crate) fn enter<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    if is_in_pool() || is_alone() {
        work()
    } else {
        shared(work, || ()).0
    }
}

/// Returns a useful number of simultaneous tasks, for work whose result does not depend on the number of tasks.
pub(crate) fn lanes() -> usize {
    if is_in_pool() { 4 * threads() } else { 1 }
}

/// Returns the number of threads of the pool that [`enter`] uses.
pub(crate) fn threads() -> usize {
    #[cfg(feature = "parallel")]
    if !is_alone() {
        return rayon::current_num_threads();
    }
    1
}

/// Runs work on a separate pool with the given number of threads, which the work may block.
///
/// # Panics
/// Panics if the threads cannot be created.
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

/// Returns whether work on this number of cells is too short to share.
pub(crate) fn is_short(cells: usize) -> bool {
    cells <= SERIAL_CELL_LIMIT
}

/// Runs work like [`enter`], or directly on the calling thread if its number of cells is too small to share.
pub(crate) fn enter_with<T: Send>(cells: usize, work: impl FnOnce() -> T + Send) -> T {
    if is_short(cells) { work() } else { enter(work) }
}

/// Data that can be split at a task boundary.
pub(crate) trait Split: Send + Sized {
    /// Splits off the first `tasks` tasks.
    fn split(self, tasks: usize) -> (Self, Self);
}

impl Split for () {
    fn split(self, _: usize) -> (Self, Self) {
        ((), ())
    }
}

/// A mutable slice in which each task owns `width` consecutive items. The last task may own fewer.
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

/// A mutable slice in which task `t` owns the items `starts[t]..starts[t + 1]`.
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
        // `map` visits each part once, and `places` has one entry per part.
        (low, high.map(|part| part.expect("every part was split")))
    }
}

/// Work of a task on its part of the data. Behind a reference to this type, the tree of tasks is compiled once per type of data
/// and not once per closure. The cost of the dynamic call is negligible compared with the work of a chunk.
pub(crate) type Work<'a, D, T> = dyn Fn(usize, D) -> T + Sync + 'a;

/// Combination of two results into one.
pub(crate) type Combine<'a, T> = dyn Fn(T, T) -> T + Sync + 'a;

/// Calls `work(task, its part of data)` for every task and combines the results pairwise in a fixed tree. The result is therefore
/// bitwise identical for any number of threads. If the thread is outside a pool, it runs all tasks itself.
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

/// Runs the tasks like [`sweep`], but on the calling thread alone.
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

/// Runs the tasks like [`sweep`], or on the calling thread alone if the number of cells is too small to share.
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

/// Splits a slice of vector work into one chunk per task.
pub(crate) fn blocks<T>(items: &mut [T]) -> Blocks<'_, T> {
    Blocks {
        items,
        width: CHUNK,
    }
}

/// Runs [`sweep`] over chunks of `0..len`, read-only: `leaf(index range) -> T`.
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

/// Runs [`fold`] over the rows of a field with `width` columns: `leaf(row range) -> T`.
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

/// Calls `update(first index, chunk)` for the chunks of a slice.
pub(crate) fn update<T: Send>(items: &mut [T], update: impl Fn(usize, &mut [T]) + Sync) {
    let tasks = items.len().div_ceil(CHUNK);
    sweep(
        0..tasks,
        blocks(items),
        &|task, block: Blocks<'_, T>| update(task * CHUNK, block.items),
        &|(), ()| (),
    );
}

/// Copies a slice into another slice of equal length.
pub(crate) fn copy(from: &[f64], to: &mut [f64]) {
    update(to, |first, chunk| {
        chunk.copy_from_slice(&from[first..first + chunk.len()]);
    });
}

/// Calls `update(row, its items)` for the rows of a field with `width` columns.
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

/// Returns the value of the cell, after computing and storing it if the cell is empty. The computation runs outside the lock of
/// the cell, because otherwise a deadlock would be possible. A thread of the caller's pool could wait for the lock while the
/// tasks of the computing thread wait for that thread. If two threads find the cell empty at the same time, both compute the
/// value, and one result is kept.
pub(crate) fn get_or_make<T>(cell: &OnceLock<T>, make: impl FnOnce() -> Result<T>) -> Result<&T> {
    if let Some(value) = cell.get() {
        return Ok(value);
    }
    let value = make()?;
    Ok(cell.get_or_init(|| value))
}
