//! Files that are renamed to their target when they are complete. They are written by one process or by several ranks together.

use std::fs::{File, OpenOptions, canonicalize, metadata, read_link, set_permissions};
use std::io::{Error as IoError, ErrorKind, Result as IoResult, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

use crate::error::Result;
use crate::files::refused;
use crate::parallel::ranks::RankGroup;

/// Temporary file next to the target file, `NAME.PID.NUMBER.part`. It is removed unless it replaces the target.
#[derive(Debug)]
pub(crate) struct PartialFile<'a> {
    /// Path of the target in messages.
    named: &'a Path,
    /// Target, to which a symbolic link is followed.
    target: PathBuf,
    path: PathBuf,
    /// Identifier composed of the process and a number.
    id: u64,
}

impl<'a> PartialFile<'a> {
    /// Creates a temporary file with a name that no other thread or process uses. A device or a pipe is rejected, because the
    /// renaming would replace it. The renaming itself rejects a folder.
    pub(crate) fn beside(named: &'a Path) -> Result<Self> {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        if metadata(named).is_ok_and(|target| !target.is_file() && !target.is_dir()) {
            let problem = IoError::new(ErrorKind::InvalidInput, "the path is not a regular file");
            return Err(refused(named, problem));
        }
        let target = followed(named);
        loop {
            let number = NUMBER.fetch_add(1, Ordering::Relaxed);
            let id = u64::from(std::process::id()) << 32 | u64::from(number);
            let path = Self::path(&target, id);
            match File::create_new(&path) {
                Ok(_) => {
                    return Ok(Self {
                        named,
                        target,
                        path,
                        id,
                    });
                }
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                Err(error) => return Err(refused(named, error)),
            }
        }
    }

    /// Returns the temporary file that a different rank has created.
    fn of_another(named: &'a Path, id: u64) -> Self {
        let target = followed(named);
        let path = Self::path(&target, id);
        Self {
            named,
            target,
            path,
            id,
        }
    }

    fn path(target: &Path, id: u64) -> PathBuf {
        let mut name = target.file_name().unwrap_or_default().to_owned();
        let (process, number) = (id >> 32, id & u64::from(u32::MAX));
        name.push(format!(".{process}.{number}.part"));
        target.with_file_name(name)
    }

    /// Opens the file for writing.
    pub(crate) fn open(&self) -> Result<File> {
        let file = OpenOptions::new().write(true).open(&self.path);
        file.map_err(|error| refused(self.named, error))
    }

    /// Writes to the file and flushes it to the disk.
    pub(crate) fn write(&self, write: impl FnOnce(&mut File) -> IoResult<()>) -> Result<()> {
        let mut file = self.open()?;
        let written = write(&mut file).and_then(|()| file.sync_all());
        written.map_err(|error| refused(self.named, error))
    }

    /// Renames the file to the target, whose permissions it keeps, and flushes the renaming to the disk.
    pub(crate) fn take_name(&self) -> Result<()> {
        if let Ok(target) = metadata(&self.target) {
            // Some file systems have no permissions.
            drop(set_permissions(&self.path, target.permissions()));
        }
        std::fs::rename(&self.path, &self.target).map_err(|error| refused(self.named, error))?;
        // Some systems cannot open a folder.
        let folder = self.target.parent();
        let folder = folder.filter(|folder| !folder.as_os_str().is_empty());
        if let Ok(folder) = File::open(folder.unwrap_or(Path::new("."))) {
            drop(folder.sync_all());
        }
        Ok(())
    }
}

/// Returns the path of an existing file without symbolic links, the file that a link to an absent file names, or the path itself.
fn followed(path: &Path) -> PathBuf {
    canonicalize(path).unwrap_or_else(|_| {
        let named = read_link(path).map(|named| path.with_file_name(named));
        named.unwrap_or_else(|_| path.to_owned())
    })
}

impl Drop for PartialFile<'_> {
    fn drop(&mut self) {
        // After the renaming there is no file to remove. After a failed write the file is useless, so an error of the
        // removal is ignored.
        drop(std::fs::remove_file(&self.path));
    }
}

/// Replaces a file completely or not at all. The content is written to a temporary file next to the target. This file is renamed
/// to the target once its content is on the disk. A process that is killed in the meantime leaves the temporary file
/// `NAME.PID.NUMBER.part`.
pub(crate) fn replace_bytes(path: &Path, bytes: &[u8]) -> Result<()> {
    replace(path, None, |file| file.write_all(bytes))
}

/// Replaces a file like [`replace_bytes`]. Every rank writes its part of the file.
pub(crate) fn replace(
    path: &Path,
    team: Option<&RankGroup>,
    write: impl FnOnce(&mut File) -> IoResult<()>,
) -> Result<()> {
    let is_first = team.is_none_or(|team| team.rank() == 0);
    let part = shared_part(path, team)?;
    RankGroup::agreed_of(team, part.write(write))?;
    let named = if is_first { part.take_name() } else { Ok(()) };
    RankGroup::agreed_of(team, named)
}

/// Returns the temporary file next to a target, which the first rank creates for all ranks.
fn shared_part<'a>(path: &'a Path, team: Option<&RankGroup>) -> Result<PartialFile<'a>> {
    let Some(team) = team else {
        return PartialFile::beside(path);
    };
    let made = (team.rank() == 0)
        .then(|| PartialFile::beside(path))
        .transpose();
    let made = team.collective_result(made)?;
    let id = team.decided(made.as_ref().map_or(0, |part| part.id));
    team.check()?;
    // If the number was not received, the default number is used, which belongs to no existing file.
    Ok(made.unwrap_or_else(|| PartialFile::of_another(path, id.unwrap_or_default())))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;
    use std::time::Duration;

    use super::*;
    use crate::error::{Error, RankFailure};
    use crate::parallel::ranks::{Ranks, Threads};

    /// A file that a link names is replaced, with its permissions. A path that is not a file is rejected.
    #[cfg(unix)]
    #[test]
    fn links_and_permissions_are_kept() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = format!("stickslip_links_{}", std::process::id());
        let folder = std::env::temp_dir().join(folder);
        std::fs::create_dir_all(&folder).unwrap();
        let (file, link) = (folder.join("file"), folder.join("link"));
        std::fs::write(&file, b"old").unwrap();
        set_permissions(&file, std::fs::Permissions::from_mode(0o600)).unwrap();
        symlink(&file, &link).unwrap();
        replace_bytes(&link, b"new").unwrap();
        assert_eq!(std::fs::read(&file).unwrap(), b"new");
        assert!(link.is_symlink());
        assert_eq!(metadata(&file).unwrap().permissions().mode() & 0o777, 0o600);
        // The link is kept if its file is absent.
        for named in [file.as_path(), Path::new("file")] {
            std::fs::remove_file(&link).unwrap();
            std::fs::remove_file(&file).unwrap();
            symlink(named, &link).unwrap();
            replace_bytes(&link, b"first").unwrap();
            assert!(link.is_symlink() && std::fs::read(&file).unwrap() == b"first");
        }
        for other in [&folder, Path::new("/dev/null")] {
            let error = replace_bytes(other, b"new").unwrap_err();
            assert!(matches!(error, Error::File { .. }), "{error}");
        }
        std::fs::remove_dir_all(folder).unwrap();
    }

    /// The disk is full for one rank after the other ranks have written all of their bytes.
    #[test]
    fn a_full_disk_leaves_the_old_file() {
        let folder = format!("stickslip_full_disk_{}", std::process::id());
        let folder = std::env::temp_dir().join(folder);
        std::fs::create_dir_all(&folder).unwrap();
        let path = folder.join("file");
        std::fs::write(&path, "old").unwrap();
        let outcomes = Threads::run(3, Duration::from_secs(60), |rank| {
            let is_full = rank.rank() == 1;
            let team = RankGroup::new(Arc::new(rank));
            replace(&path, Some(&team), |file| {
                file.write_all(b"new")?;
                if is_full {
                    return Err(ErrorKind::StorageFull.into());
                }
                Ok(())
            })
        });
        for (rank, outcome) in outcomes.iter().enumerate() {
            let refused = Err(Error::Ranks(RankFailure::RejectedByRank { rank: 1 }));
            let is_own = matches!(outcome, Err(Error::File { .. }));
            assert!(if rank == 1 {
                is_own
            } else {
                *outcome == refused
            });
        }
        assert_eq!(std::fs::read(&path).unwrap(), b"old");
        assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 1);
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
