//! Reader of the ZIP archives of X3P: stored or deflated files without encryption.

use miniz_oxide::inflate::decompress_to_vec_with_limit;
use rawzip::{
    CompressionMethod, ErrorKind, ZipArchive, ZipFileHeaderRecord, ZipSliceArchive, ZipVerification,
};

use super::FORMAT;
use crate::error::Result;
use crate::io::Place;

/// Number of bytes to which any entry may expand, regardless of its packed size.
const SMALL: usize = 4 << 20;
/// Largest permitted ratio of the expanded size to the packed size, for larger entries.
const LARGEST_RATIO: usize = 100;

/// Archive in memory.
#[derive(Debug)]
pub(super) struct Archive<'a>(ZipSliceArchive<&'a [u8]>);

impl<'a> Archive<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Result<Self> {
        let archive = ZipArchive::from_slice(bytes);
        archive.map(Self).map_err(|error| match error.kind() {
            ErrorKind::MissingEndOfCentralDirectory | ErrorKind::Eof => FORMAT.at_byte(
                bytes.len(),
                "the archive is truncated: its end record is missing",
            ),
            _ => {
                let end = Place::Byte(error.eocd_offset().unwrap_or_default());
                FORMAT.at(end, format!("the end of the archive is damaged: {error}"))
            }
        })
    }

    /// Returns the content of the named entry. Returns an error if the size of the entry differs from `expected`.
    pub(super) fn read(&self, name: &str, expected: Option<usize>) -> Result<Vec<u8>> {
        let refused = |problem: String| FORMAT.in_entry(name, problem);
        let missing = || refused("the archive has no such file".into());
        let header = self.find(name)?.ok_or_else(missing)?;
        if header.flags().is_encrypted() {
            return Err(refused("encryption is not supported".into()));
        }
        let size = header.uncompressed_size_hint();
        if let Some(expected) = expected.filter(|&expected| expected as u64 != size) {
            return Err(refused(format!(
                "the file has {size} bytes, expected {expected}"
            )));
        }
        let entry = self.0.get_entry(header.wayfinder()).map_err(|error| {
            let start = header.local_header_offset();
            refused(format!("the file was not found at byte {start}: {error}"))
        })?;
        let packed = entry.data();
        let limit = SMALL.max(packed.len().saturating_mul(LARGEST_RATIO));
        let allowed = usize::try_from(size).ok().filter(|&size| size <= limit);
        let too_large = || {
            let packed = packed.len();
            refused(format!(
                "{packed} compressed bytes would expand to {size} bytes, but at most {limit} bytes are permitted"
            ))
        };
        let allowed = allowed.ok_or_else(too_large)?;
        let content = match header.compression_method() {
            CompressionMethod::STORE => packed.to_vec(),
            CompressionMethod::DEFLATE => decompress_to_vec_with_limit(packed, allowed)
                .map_err(|error| refused(format!("the file cannot be decompressed: {error}")))?,
            method => {
                let method = method.as_u16();
                return Err(refused(format!("compression {method} is not supported")));
            }
        };
        let found = ZipVerification {
            crc: rawzip::crc32(&content),
            uncompressed_size: content.len() as u64,
        };
        let verified = entry.claim_verifier().valid(found);
        verified.map_err(|error| refused(format!("the file is damaged: {error}")))?;
        Ok(content)
    }

    /// Returns the folder of the named entry, with a slash at its end. The folder is the root if the entry is in the
    /// root or missing. Otherwise it is the first folder with such an entry.
    pub(super) fn folder_of(&self, name: &str) -> Result<String> {
        if self.has(name)? {
            return Ok(String::new());
        }
        let is_named = |path: &[u8]| is_in_folder(path, name);
        let entry = self.find_path(is_named)?;
        let path = entry.map(|entry| entry.file_path().as_bytes().to_vec());
        let folder = path.map(|path| path[..path.len() - name.len()].to_vec());
        // A name that is not UTF-8 differs from its lossy conversion, so a later search reports the file as missing.
        Ok(String::from_utf8_lossy(&folder.unwrap_or_default()).into_owned())
    }

    /// Returns whether the archive contains the named entry.
    pub(super) fn has(&self, name: &str) -> Result<bool> {
        Ok(self.find(name)?.is_some())
    }

    fn find(&self, name: &str) -> Result<Option<ZipFileHeaderRecord<'_>>> {
        self.find_path(|path| is_same_path(path, name.as_bytes()))
    }

    fn find_path(
        &self,
        is_searched: impl Fn(&[u8]) -> bool,
    ) -> Result<Option<ZipFileHeaderRecord<'_>>> {
        // The iterator would continue to the end of the directory. Only the declared number of entries is used.
        let declared = usize::try_from(self.0.entries_hint()).unwrap_or(usize::MAX);
        for entry in self.0.entries().take(declared) {
            let entry = entry.map_err(|error| {
                let problem = format!("the directory of the archive is damaged: {error}");
                FORMAT.at(Place::Byte(self.0.directory_offset()), problem)
            })?;
            if is_searched(entry.file_path().as_bytes()) {
                return Ok(Some(entry));
            }
        }
        Ok(None)
    }
}

/// Returns whether two paths are the same. Some Windows programs separate folders by backslashes.
fn is_same_path(a: &[u8], b: &[u8]) -> bool {
    let slash = |&byte: &u8| if byte == b'\\' { b'/' } else { byte };
    a.iter().map(slash).eq(b.iter().map(slash))
}

/// Returns whether a path ends with the name and has at least one folder.
fn is_in_folder(path: &[u8], name: &str) -> bool {
    let folder = path.strip_suffix(name.as_bytes());
    folder.is_some_and(|folder| folder.ends_with(b"/") || folder.ends_with(b"\\"))
}
