//! Files within a ZIP archive, as far as X3P needs them: stored or deflated, without encryption.
//!
//! Layout: APPNOTE.TXT of PKWARE, sections 4.3 and 4.4.

use miniz_oxide::inflate::decompress_to_vec_with_limit;

use super::FORMAT;
use crate::error::Result;
use crate::io::bytes::Cursor;

/// An entry may expand to this many bytes whatever its packed size,
const SMALL: usize = 4 << 20;
/// and to this many times its packed size.
const LARGEST_RATIO: usize = 100;
/// The record at the end of an archive, without its comment of at most 65535 bytes.
const END_SIZE: usize = 22;

/// An archive in memory.
#[derive(Debug)]
pub(super) struct Archive<'a> {
    bytes: &'a [u8],
    /// Where the directory begins, and its number of entries.
    directory: usize,
    entries: u16,
}

/// What the directory says of an entry.
#[derive(Debug)]
struct Entry {
    is_encrypted: bool,
    method: u16,
    checksum: u32,
    packed: usize,
    size: usize,
    start: usize,
}

impl<'a> Archive<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Result<Self> {
        let first = bytes.len().saturating_sub(END_SIZE + usize::from(u16::MAX));
        let windows = bytes[first..].windows(END_SIZE);
        let Some(end) = windows.rev().position(|w| w.starts_with(b"PK\x05\x06")) else {
            return Err(FORMAT.at_byte(bytes.len(), "the archive has no end: it is truncated"));
        };
        let start = bytes.len() - END_SIZE - end;
        let mut record = Cursor::new(FORMAT, bytes).seek(start)?;
        record.take("the disks of the archive", 10)?;
        let entries = record.u16("the number of entries")?;
        record.take("the size of the directory", 4)?;
        let directory = record.u32("the place of the directory")? as usize;
        Ok(Self {
            bytes,
            directory,
            entries,
        })
    }

    /// The content of the entry of a name, if it has the size expected.
    pub(super) fn read(&self, name: &str, expected: Option<usize>) -> Result<Vec<u8>> {
        let refused = |problem: String| FORMAT.in_entry(name, problem);
        let missing = || refused("the archive has no such file".into());
        let entry = self.find(name)?.ok_or_else(missing)?;
        if entry.is_encrypted {
            return Err(refused("encryption is not supported".into()));
        }
        let size = entry.size;
        if let Some(expected) = expected.filter(|&expected| expected != size) {
            return Err(refused(format!("{size} bytes, expected {expected}")));
        }
        let packed = self.packed(&entry)?;
        let limit = SMALL.max(packed.len().saturating_mul(LARGEST_RATIO));
        if size > limit {
            return Err(refused(format!(
                "{} bytes would expand to {size}, beyond the limit of {limit}",
                packed.len()
            )));
        }
        let content = match entry.method {
            0 => packed.to_vec(),
            8 => decompress_to_vec_with_limit(packed, size)
                .map_err(|error| refused(format!("cannot be expanded: {error}")))?,
            method => return Err(refused(format!("compression {method} is not supported"))),
        };
        if content.len() != size {
            let found = content.len();
            return Err(refused(format!("{found} bytes, the directory says {size}")));
        }
        if checksum(&content) != entry.checksum {
            return Err(refused("the checksum is wrong: the file is damaged".into()));
        }
        Ok(content)
    }

    fn find(&self, wanted: &str) -> Result<Option<Entry>> {
        let mut directory = Cursor::new(FORMAT, self.bytes).seek(self.directory)?;
        for _ in 0..self.entries {
            let start = directory.position();
            if directory.take("an entry of the directory", 4)? != b"PK\x01\x02" {
                return Err(FORMAT.at_byte(start, "no entry of the directory of the archive"));
            }
            directory.take("versions", 4)?;
            let flags = directory.u16("flags")?;
            let method = directory.u16("the method of compression")?;
            directory.take("date and time", 4)?;
            let checksum = directory.u32("the checksum")?;
            let packed = directory.u32("the packed size")? as usize;
            let size = directory.u32("the size")? as usize;
            let lengths = [
                directory.u16("the length of the name")?,
                directory.u16("the length of the extra field")?,
                directory.u16("the length of the comment")?,
            ];
            directory.take("attributes", 8)?;
            let entry_start = directory.u32("the place of the entry")? as usize;
            let name = directory.take("the name", lengths[0].into())?;
            let tail = usize::from(lengths[1]) + usize::from(lengths[2]);
            directory.take("extra field and comment", tail)?;
            if name == wanted.as_bytes() {
                return Ok(Some(Entry {
                    is_encrypted: flags & 1 != 0,
                    method,
                    checksum,
                    packed,
                    size,
                    start: entry_start,
                }));
            }
        }
        Ok(None)
    }

    /// The packed bytes of an entry.
    fn packed(&self, entry: &Entry) -> Result<&'a [u8]> {
        let mut bytes = Cursor::new(FORMAT, self.bytes).seek(entry.start)?;
        if bytes.take("an entry of the archive", 4)? != b"PK\x03\x04" {
            return Err(FORMAT.at_byte(entry.start, "no entry of the archive"));
        }
        bytes.take("what the directory repeats", 22)?;
        let lengths = [bytes.u16("a length")?, bytes.u16("a length")?];
        let head = usize::from(lengths[0]) + usize::from(lengths[1]);
        bytes.take("name and extra field", head)?;
        bytes.take("the packed bytes", entry.packed)
    }
}

/// The cyclic redundancy check of the archive (CRC-32, reflected polynomial 0xedb88320).
fn checksum(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |sum, &byte| {
        TABLE[(sum.to_le_bytes()[0] ^ byte) as usize] ^ (sum >> 8)
    })
}

const TABLE: [u32; 256] = {
    let mut table = [0; 256];
    let mut byte = 0_u32;
    while byte < 256 {
        let (mut sum, mut bit) = (byte, 0);
        while bit < 8 {
            sum = if sum & 1 == 1 {
                sum >> 1 ^ 0xedb8_8320
            } else {
                sum >> 1
            };
            bit += 1;
        }
        table[byte as usize] = sum;
        byte += 1;
    }
    table
};
