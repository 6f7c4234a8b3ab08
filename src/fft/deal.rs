//! The tiles on their way between ranks: from who has the rows to who has the columns, and back.

use std::ops::Range;

use crate::buffer::or_abort;
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
        let (from, to) = (self.in_rows(by_rows), self.in_columns(by_columns));
        let sent = |rank| [self.tile_columns_of(rank), self.own_tile_rows()];
        let received = |rank| [self.own_tile_columns(), self.tile_rows_of(share, rank)];
        self.deal(share, [from, to], sent, received, Some(occupied), spare);
    }

    /// Hands the tiles back to who has their rows, and takes those of the rows here.
    pub(super) fn deal_rows(
        &self,
        share: &Share,
        by_columns: &mut [Tile],
        by_rows: &mut [Tile],
        spare: &mut Vec<Tile>,
    ) {
        let (from, to) = (self.in_columns(by_columns), self.in_rows(by_rows));
        let sent = |rank| [self.own_tile_columns(), self.tile_rows_of(share, rank)];
        let received = |rank| [self.tile_columns_of(rank), self.own_tile_rows()];
        self.deal(share, [from, to], sent, received, None, spare);
    }

    /// Hands tiles from one order to the other: which columns and rows of them go to a rank, and which come from it. Of
    /// bands some of which hold nothing, only those that hold something travel, after a bit for each.
    fn deal(
        &self,
        share: &Share,
        [mut from, mut to]: [Order<'_>; 2],
        sent: impl Fn(usize) -> [Range<usize>; 2],
        received: impl Fn(usize) -> [Range<usize>; 2],
        mut occupied: Option<&mut [bool]>,
        spare: &mut Vec<Tile>,
    ) {
        let team = share.team();
        let (me, ranks) = (team.rank(), team.size());
        let [own_columns, own_rows] = sent(me);
        for column in own_columns {
            for row in own_rows.clone() {
                std::mem::swap(from.at(column, row), to.at(column, row));
            }
        }
        let pieces = self.pieces(share);
        // The memory of a block that has come is that of the next to go.
        let mut block = Vec::new();
        for step in 1..ranks {
            let (to_rank, from_rank) = ((me + step) % ranks, (me + ranks - step) % ranks);
            let ([sent_columns, sent_rows], [new_columns, new_rows]) =
                (sent(to_rank), received(from_rank));
            for piece in 0..pieces.count {
                let tiles_down = sent_rows
                    .clone()
                    .filter(|&row| holds(occupied.as_deref(), row));
                let tiles = tiles_down.count() * pieces.of(piece, &sent_columns).len();
                block.clear();
                block.reserve_exact(tiles * TILE_WORDS + sent_rows.len().div_ceil(64));
                if let Some(occupied) = &occupied {
                    if piece == 0 && !sent_columns.is_empty() {
                        block.extend(packed(&occupied[sent_rows.clone()]));
                    }
                }
                for column in pieces.of(piece, &sent_columns) {
                    for row in sent_rows.clone() {
                        let tile = std::mem::take(from.at(column, row));
                        if holds(occupied.as_deref(), row) {
                            block.extend_from_slice(tile.words());
                        }
                        spare.push(tile);
                    }
                }
                block = team.swap(block, to_rank, from_rank);
                let mut words = &block[..];
                if let Some(occupied) = &mut occupied {
                    if piece == 0 && !new_columns.is_empty() {
                        unpack(&mut words, &mut occupied[new_rows.clone()]);
                    }
                }
                for column in pieces.of(piece, &new_columns) {
                    for row in new_rows.clone() {
                        let mut tile = spare.pop().unwrap_or_else(|| or_abort(Tile::zero()));
                        if holds(occupied.as_deref(), row) {
                            fill(&mut tile, &mut words);
                        }
                        *to.at(column, row) = tile;
                    }
                }
            }
        }
    }

    /// Tiles of the rows held here, row after row.
    fn in_rows<'a>(&self, tiles: &'a mut [Tile]) -> Order<'a> {
        Order {
            tiles,
            first: [0, self.own_tile_rows().start],
            strides: [1, self.tiles_across()],
        }
    }

    /// Tiles of the columns multiplied here, column after column.
    fn in_columns<'a>(&self, tiles: &'a mut [Tile]) -> Order<'a> {
        Order {
            tiles,
            first: [self.own_tile_columns().start, 0],
            strides: [self.tiles_along(), 1],
        }
    }
}

/// Tiles, and where those of a column and a row lie.
struct Order<'a> {
    tiles: &'a mut [Tile],
    first: [usize; 2],
    strides: [usize; 2],
}

impl Order<'_> {
    fn at(&mut self, column: usize, row: usize) -> &mut Tile {
        let across = (column - self.first[0]) * self.strides[0];
        &mut self.tiles[across + (row - self.first[1]) * self.strides[1]]
    }
}

/// Whether a band is known to hold something, or nothing is known of any.
fn holds(occupied: Option<&[bool]>, band: usize) -> bool {
    occupied.is_none_or(|occupied| occupied[band])
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
