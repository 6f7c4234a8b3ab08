//! Files within a ZIP archive, as far as X3P needs them: stored or deflated, without encryption.

use miniz_oxide::inflate::decompress_to_vec_with_limit;
use rawzip::{
    CompressionMethod, ErrorKind, ZipArchive, ZipFileHeaderRecord, ZipSliceArchive, ZipVerification,
};

use super::FORMAT;
use crate::error::Result;
use crate::io::Place;

/// An entry may expand to this many bytes whatever its packed size,
const SMALL: usize = 4 << 20;
/// and to this many times its packed size.
const LARGEST_RATIO: usize = 100;

/// An archive in memory.
#[derive(Debug)]
pub(super) struct Archive<'a>(ZipSliceArchive<&'a [u8]>);

impl<'a> Archive<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Result<Self> {
        let archive = ZipArchive::from_slice(bytes);
        archive.map(Self).map_err(|error| match error.kind() {
            ErrorKind::MissingEndOfCentralDirectory | ErrorKind::Eof => {
                FORMAT.at_byte(bytes.len(), "the archive has no end: it is truncated")
            }
            _ => {
                let end = Place::Byte(error.eocd_offset().unwrap_or_default());
                FORMAT.at(end, format!("the end of the archive is damaged: {error}"))
            }
        })
    }

    /// The content of the entry of a name, if it has the size expected.
    pub(super) fn read(&self, name: &str, expected: Option<usize>) -> Result<Vec<u8>> {
        let refused = |problem: String| FORMAT.in_entry(name, problem);
        let missing = || refused("the archive has no such file".into());
        let header = self.find(name)?.ok_or_else(missing)?;
        if header.flags().is_encrypted() {
            return Err(refused("encryption is not supported".into()));
        }
        let size = header.uncompressed_size_hint();
        if let Some(expected) = expected.filter(|&expected| expected as u64 != size) {
            return Err(refused(format!("{size} bytes, expected {expected}")));
        }
        let entry = self.0.get_entry(header.wayfinder()).map_err(|error| {
            let start = header.local_header_offset();
            refused(format!("not found at byte {start}: {error}"))
        })?;
        let packed = entry.data();
        let limit = SMALL.max(packed.len().saturating_mul(LARGEST_RATIO));
        let allowed = usize::try_from(size).ok().filter(|&size| size <= limit);
        let too_large = || {
            let packed = packed.len();
            refused(format!(
                "{packed} bytes would expand to {size}, beyond the limit of {limit}"
            ))
        };
        let allowed = allowed.ok_or_else(too_large)?;
        let content = match header.compression_method() {
            CompressionMethod::STORE => packed.to_vec(),
            CompressionMethod::DEFLATE => decompress_to_vec_with_limit(packed, allowed)
                .map_err(|error| refused(format!("cannot be expanded: {error}")))?,
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

    /// The folder of the entry of a name, with a slash at its end: the root if the entry is there or missing, otherwise
    /// the first folder that has such an entry.
    pub(super) fn folder_of(&self, name: &str) -> Result<String> {
        if self.has(name)? {
            return Ok(String::new());
        }
        let is_named = |path: &[u8]| is_in_folder(path, name);
        let entry = self.find_path(is_named)?;
        let path = entry.map(|entry| entry.file_path().as_bytes().to_vec());
        let folder = path.map(|path| path[..path.len() - name.len()].to_vec());
        // A name that is not UTF-8 does not equal its replacement: the error then says that the file is missing.
        Ok(String::from_utf8_lossy(&folder.unwrap_or_default()).into_owned())
    }

    /// Whether there is an entry of a name.
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
        // The iterator reads on to the end of the directory; only those declared count.
        let declared = usize::try_from(self.0.entries_hint()).unwrap_or(usize::MAX);
        for entry in self.0.entries().take(declared) {
            let entry = entry.map_err(|error| {
                let problem = format!("the directory that begins here is damaged: {error}");
                FORMAT.at(Place::Byte(self.0.directory_offset()), problem)
            })?;
            if is_searched(entry.file_path().as_bytes()) {
                return Ok(Some(entry));
            }
        }
        Ok(None)
    }
}

/// Whether two paths are the same; some programs of Windows separate folders by backslashes.
fn is_same_path(a: &[u8], b: &[u8]) -> bool {
    let slash = |&byte: &u8| if byte == b'\\' { b'/' } else { byte };
    a.iter().map(slash).eq(b.iter().map(slash))
}

/// Whether a path ends in a folder and a name.
fn is_in_folder(path: &[u8], name: &str) -> bool {
    let folder = path.strip_suffix(name.as_bytes());
    folder.is_some_and(|folder| folder.ends_with(b"/") || folder.ends_with(b"\\"))
}
