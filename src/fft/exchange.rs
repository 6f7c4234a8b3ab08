//! Exchange of tiles between the ranks that store their rows and the ranks that multiply their columns.

use std::ops::Range;

use crate::fft::plan::Plan;
use crate::fft::precision::Real;
use crate::fft::tiles::{TILE_WORDS, Tile};
use crate::memory::fallible::unwrap_or_abort;
use crate::parallel::ranks::WireFormat;
use crate::parallel::ranks::partition::{RowPartition, part, rounds};
use crate::parallel::{self, Blocks, Work};

/// Approximate number of tiles that a rank sends per round. Packed tiles take memory in addition to the tiles
/// themselves.
const ROUND_TILES: usize = 2048;

/// Number of tiles that a task packs or unpacks.
const TASK_TILES: usize = 16;

impl<T: Real> Plan<T> {
    /// Returns the range of the tiles in a column that contain rows of a given rank.
    fn tile_rows_of(&self, share: &RowPartition, rank: usize) -> Range<usize> {
        let rows = share.rows_of(rank);
        let place = |row: usize| self.tile_rows.partition_point(|&first| first < row);
        if rows.is_empty() {
            return 0..0;
        }
        place(rows.start)..place(rows.end)
    }

    /// Returns the range of tiles in a column that contain local rows.
    pub(super) fn own_tile_rows(&self) -> Range<usize> {
        match &self.frame.share {
            Some(share) => self.tile_rows_of(share, share.team().rank()),
            None => 0..self.tiles_down(),
        }
    }

    /// Returns the number of rounds of an exchange, equal on all ranks.
    fn rounds(&self, share: &RowPartition) -> usize {
        let tiles = |rank: usize| {
            let by_rows = self.tile_rows_of(share, rank).len() * self.tiles_across();
            by_rows.max(self.tile_columns_of(rank).len() * self.tiles_along())
        };
        let most = (0..share.team().size()).map(tiles).max();
        rounds(most.unwrap_or(0), ROUND_TILES)
    }

    /// Sends the tiles to the ranks that multiply their columns, and receives the tiles of the local columns. Bands that
    /// contain only zeros are not sent.
    pub(super) fn deal_columns(
        &self,
        share: &RowPartition,
        by_rows: &mut [Tile],
        by_columns: &mut [Tile],
        occupied: &mut [bool],
        spare: &mut Vec<Tile>,
    ) {
        let (from, to) = (self.in_rows(by_rows), self.in_columns(by_columns));
        let sent = |rank| [self.tile_columns_of(rank), self.own_tile_rows()];
        let received = |rank| [self.own_tile_columns(), self.tile_rows_of(share, rank)];
        self.transpose_tiles(share, [from, to], sent, received, Some(occupied), spare);
    }

    /// Sends the tiles back to the ranks of their rows, and receives the tiles of the local rows.
    pub(super) fn tiles_to_rows(
        &self,
        share: &RowPartition,
        by_columns: &mut [Tile],
        by_rows: &mut [Tile],
        spare: &mut Vec<Tile>,
    ) {
        let (from, to) = (self.in_columns(by_columns), self.in_rows(by_rows));
        let sent = |rank| [self.own_tile_columns(), self.tile_rows_of(share, rank)];
        let received = |rank| [self.tile_columns_of(rank), self.own_tile_rows()];
        self.transpose_tiles(share, [from, to], sent, received, None, spare);
    }

    /// Transfers tiles from one order to the other. `sent` returns the columns and rows of the tiles that go to a rank.
    /// `received` returns the columns and rows of the tiles that come from a rank. If `occupied` is given, one bit per
    /// band is sent first. Only the nonzero bands follow.
    fn transpose_tiles(
        &self,
        share: &RowPartition,
        [mut from, mut to]: [TileOrder<'_>; 2],
        sent: impl Fn(usize) -> [Range<usize>; 2],
        received: impl Fn(usize) -> [Range<usize>; 2],
        mut occupied: Option<&mut [bool]>,
        spare: &mut Vec<Tile>,
    ) {
        let team = share.team();
        let (me, ranks) = (team.rank(), team.size());
        let others = (0..ranks).filter(|rank| *rank != me);
        let [own_columns, own_rows] = sent(me);
        for column in own_columns {
            for row in own_rows.clone() {
                std::mem::swap(from.at(column, row), to.at(column, row));
            }
        }
        let rounds = self.rounds(share);
        // Received blocks are reused as buffers for the next round.
        let mut blocks = vec![Vec::new(); ranks];
        let mut is_expected = vec![false; ranks];
        for round in 0..rounds {
            // The first round sends the bits of the occupied bands.
            let tells = round == 0 && occupied.is_some();
            let mut left = Vec::new();
            for rank in others.clone() {
                let [columns, rows] = sent(rank);
                let first = spare.len();
                for column in part(&columns, round, rounds) {
                    for row in rows.clone() {
                        let tile = std::mem::take(from.at(column, row));
                        if holds(occupied.as_deref(), row) {
                            spare.push(tile);
                        } else {
                            left.push(tile);
                        }
                    }
                }
                let told = occupied.as_deref().filter(|_| tells && !columns.is_empty());
                let bits: Vec<u64> = told.map_or_else(Vec::new, |all| packed(&all[rows]).collect());
                pack(&mut blocks[rank], &bits, &spare[first..]);
                let [columns, mut rows] = received(rank);
                is_expected[rank] = if tells {
                    !columns.is_empty() && !rows.is_empty()
                } else {
                    let comes = |row| holds(occupied.as_deref(), row);
                    !part(&columns, round, rounds).is_empty() && rows.any(comes)
                };
            }
            spare.append(&mut left);
            blocks = team.all_to_all(blocks, &is_expected);
            for rank in others.clone() {
                let [columns, rows] = received(rank);
                let mut words = &blocks[rank][..];
                let mut bits = 0;
                if let Some(occupied) = occupied
                    .as_deref_mut()
                    .filter(|_| tells && !columns.is_empty())
                {
                    unpack(&mut words, &mut occupied[rows.clone()]);
                    bits = rows.len().div_ceil(64);
                }
                let columns = part(&columns, round, rounds);
                let comes = |row: &usize| holds(occupied.as_deref(), *row);
                let filled = rows.clone().filter(comes).count() * columns.len();
                if blocks[rank].len() != bits + filled * TILE_WORDS {
                    team.out_of_step(rank);
                }
                while spare.len() < rows.len() * columns.len() {
                    spare.push(unwrap_or_abort(Tile::zero()));
                }
                let first = spare.len() - filled;
                fill(&mut spare[first..], words);
                // Tiles are removed from the end of `spare`, so the loop starts with the last tile.
                for column in columns.clone().rev() {
                    for row in rows.clone().rev().filter(comes) {
                        *to.at(column, row) = spare.pop().unwrap_or_default();
                    }
                }
                for column in columns {
                    for row in rows.clone().filter(|row| !comes(row)) {
                        *to.at(column, row) = spare.pop().unwrap_or_default();
                    }
                }
            }
        }
    }

    /// Returns the tiles of the local rows, ordered row by row.
    fn in_rows<'a>(&self, tiles: &'a mut [Tile]) -> TileOrder<'a> {
        TileOrder {
            tiles,
            first: [0, self.own_tile_rows().start],
            strides: [1, self.tiles_across()],
        }
    }

    /// Returns the tiles of the local columns, ordered column by column.
    fn in_columns<'a>(&self, tiles: &'a mut [Tile]) -> TileOrder<'a> {
        TileOrder {
            tiles,
            first: [self.own_tile_columns().start, 0],
            strides: [self.tiles_along(), 1],
        }
    }
}

/// Tiles, and their positions by column and row.
struct TileOrder<'a> {
    tiles: &'a mut [Tile],
    first: [usize; 2],
    strides: [usize; 2],
}

impl TileOrder<'_> {
    fn at(&mut self, column: usize, row: usize) -> &mut Tile {
        let across = (column - self.first[0]) * self.strides[0];
        &mut self.tiles[across + (row - self.first[1]) * self.strides[1]]
    }
}

/// Returns whether a band might contain a nonzero value. Returns `true` for every band if `occupied` is `None`.
fn holds(occupied: Option<&[bool]>, band: usize) -> bool {
    occupied.is_none_or(|occupied| occupied[band])
}

/// Packs some words and the tiles into a block.
fn pack(block: &mut Vec<u64>, first: &[u64], tiles: &[Tile]) {
    block.resize(first.len() + tiles.len() * TILE_WORDS, 0);
    let (head, words) = block.split_at_mut(first.len());
    head.copy_from_slice(first);
    let data = Blocks {
        items: words,
        width: TASK_TILES * TILE_WORDS,
    };
    in_tasks(tiles.len(), data, &|task, part| {
        let words = part.items.chunks_exact_mut(TILE_WORDS);
        for (tile, words) in tiles[task * TASK_TILES..].iter().zip(words) {
            words.copy_from_slice(tile.words());
        }
    });
}

/// Copies the received words into tiles. Tiles without data, from a disconnected rank, remain unchanged.
fn fill(tiles: &mut [Tile], words: &[u64]) {
    let count = tiles.len();
    let data = Blocks {
        items: tiles,
        width: TASK_TILES,
    };
    in_tasks(count, data, &|task, part| {
        let words = words.chunks_exact(TILE_WORDS).skip(task * TASK_TILES);
        for (tile, words) in part.items.iter_mut().zip(words) {
            tile.words_mut().copy_from_slice(words);
        }
    });
}

/// Runs the work in parallel on the given number of tiles.
fn in_tasks<'a, T: Send>(tiles: usize, data: Blocks<'a, T>, work: &Work<'_, Blocks<'a, T>, ()>) {
    parallel::sweep(0..tiles.div_ceil(TASK_TILES), data, work, &|(), ()| ());
}

/// Packs one bit per band into words.
fn packed(occupied: &[bool]) -> impl Iterator<Item = u64> {
    occupied.chunks(64).map(|bands| {
        let bits = bands.iter().rev();
        bits.fold(0, |word, &occupied| word << 1 | u64::from(occupied))
    })
}

fn unpack(words: &mut &[u64], occupied: &mut [bool]) {
    for bands in occupied.chunks_mut(64) {
        let word = u64::read(words);
        for (bit, band) in bands.iter_mut().enumerate() {
            *band = word >> bit & 1 != 0;
        }
    }
}
