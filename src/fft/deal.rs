//! The tiles on their way between ranks: from who has the rows to who has the columns, and back.

use std::ops::Range;

use crate::fft::plan::Plan;
use crate::fft::real::Real;
use crate::fft::tiles::{TILE_WORDS, Tile};
use crate::ranks::Words;
use crate::share::Share;

/// Tiles of a block, about: it is packed and unpacked beside the tiles themselves.
const BLOCK_TILES: usize = 2048;

/// How the tiles of one rank go to another: some columns of them at a time.
struct Pieces {
    columns: usize,
    count: usize,
}

impl Pieces {
    /// Those of columns that begin with `all`.
    fn of(&self, piece: usize, all: &Range<usize>) -> Range<usize> {
        let first = all.start + piece * self.columns;
        first.min(all.end)..(first + self.columns).min(all.end)
    }
}

impl<T: Real> Plan<T> {
    /// Which tiles of a column are of the rows of a rank.
    fn tile_rows_of(&self, share: &Share, rank: usize) -> Range<usize> {
        let rows = share.rows_of(rank);
        let place = |row: usize| self.tile_rows.partition_point(|&first| first < row);
        if rows.is_empty() {
            return 0..0;
        }
        place(rows.start)..place(rows.end)
    }

    /// Which tiles of a column are of the rows held here.
    pub(super) fn own_tile_rows(&self) -> Range<usize> {
        match &self.frame.share {
            Some(share) => self.tile_rows_of(share, share.team().rank()),
            None => 0..self.tiles_down(),
        }
    }

    /// The same for all ranks, so that all swap as many blocks.
    fn pieces(&self, share: &Share) -> Pieces {
        let ranks = 0..share.team().size();
        let highest = ranks
            .clone()
            .map(|rank| self.tile_rows_of(share, rank).len());
        let widest = ranks.map(|rank| self.tile_columns_of(rank).len());
        let columns = (BLOCK_TILES / highest.max().unwrap_or(1).max(1)).max(1);
        Pieces {
            columns,
            count: widest.max().unwrap_or(0).div_ceil(columns),
        }
    }

    /// Hands the tiles to who multiplies their columns, and takes those of the columns here. Bands that hold nothing are
    /// not sent.
    pub(super) fn deal_columns(
        &self,
        share: &Share,
        by_rows: &mut [Tile],
        by_columns: &mut [Tile],
        occupied: &mut [bool],
        spare: &mut Vec<Tile>,
    ) {
        let team = share.team();
        let (me, ranks) = (team.rank(), team.size());
        let (across, along) = (self.tiles_across(), self.tiles_along());
        let (own_rows, own_columns) = (self.own_tile_rows(), self.own_tile_columns());
        for column in own_columns.clone() {
            for row in own_rows.clone() {
                let tile = &mut by_rows[(row - own_rows.start) * across + column];
                let place = (column - own_columns.start) * along + row;
                std::mem::swap(tile, &mut by_columns[place]);
            }
        }
        let pieces = self.pieces(share);
        for step in 1..ranks {
            let (to, from) = ((me + step) % ranks, (me + ranks - step) % ranks);
            let (to_columns, from_rows) =
                (self.tile_columns_of(to), self.tile_rows_of(share, from));
            for piece in 0..pieces.count {
                let mut block = Vec::new();
                if piece == 0 && !to_columns.is_empty() {
                    block.extend(packed(&occupied[own_rows.clone()]));
                }
                for column in pieces.of(piece, &to_columns) {
                    for row in own_rows.clone() {
                        let tile = &mut by_rows[(row - own_rows.start) * across + column];
                        let tile = std::mem::take(tile);
                        if occupied[row] {
                            block.extend_from_slice(tile.words());
                        }
                        spare.push(tile);
                    }
                }
                let block = team.swap(block, to, from);
                let mut words = &block[..];
                if piece == 0 && !own_columns.is_empty() {
                    unpack(&mut words, &mut occupied[from_rows.clone()]);
                }
                for column in pieces.of(piece, &own_columns) {
                    for row in from_rows.clone() {
                        let mut tile = spare.pop().unwrap_or_else(Tile::zero);
                        if occupied[row] {
                            fill(&mut tile, &mut words);
                        }
                        by_columns[(column - own_columns.start) * along + row] = tile;
                    }
                }
            }
        }
    }

    /// Hands the tiles back to who has their rows, and takes those of the rows here.
    pub(super) fn deal_rows(
        &self,
        share: &Share,
        by_columns: &mut [Tile],
        by_rows: &mut [Tile],
        spare: &mut Vec<Tile>,
    ) {
        let team = share.team();
        let (me, ranks) = (team.rank(), team.size());
        let (across, along) = (self.tiles_across(), self.tiles_along());
        let (own_rows, own_columns) = (self.own_tile_rows(), self.own_tile_columns());
        for column in own_columns.clone() {
            for row in own_rows.clone() {
                let tile = &mut by_columns[(column - own_columns.start) * along + row];
                let place = (row - own_rows.start) * across + column;
                std::mem::swap(tile, &mut by_rows[place]);
            }
        }
        let pieces = self.pieces(share);
        for step in 1..ranks {
            let (to, from) = ((me + step) % ranks, (me + ranks - step) % ranks);
            let (to_rows, from_columns) =
                (self.tile_rows_of(share, to), self.tile_columns_of(from));
            for piece in 0..pieces.count {
                let mut block = Vec::new();
                for column in pieces.of(piece, &own_columns) {
                    for row in to_rows.clone() {
                        let tile = &mut by_columns[(column - own_columns.start) * along + row];
                        let tile = std::mem::take(tile);
                        block.extend_from_slice(tile.words());
                        spare.push(tile);
                    }
                }
                let block = team.swap(block, to, from);
                let mut words = &block[..];
                for column in pieces.of(piece, &from_columns) {
                    for row in own_rows.clone() {
                        let mut tile = spare.pop().unwrap_or_else(Tile::zero);
                        fill(&mut tile, &mut words);
                        by_rows[(row - own_rows.start) * across + column] = tile;
                    }
                }
            }
        }
    }
}

/// Takes a tile from the words received; it stays as it is where none came, from a rank that is lost.
fn fill(tile: &mut Tile, words: &mut &[u64]) {
    if let Some((own, rest)) = words.split_at_checked(TILE_WORDS) {
        tile.words_mut().copy_from_slice(own);
        *words = rest;
    }
}

/// A bit for each band.
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
