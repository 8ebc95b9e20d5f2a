//! Files that appear whole or not at all: written beside, then renamed.

use crate::failure::{Failure, reason};
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

/// A file that is being written beside the one it will replace.
pub struct Output {
    place: PathBuf,
    /// `None` for a device, which is written in place.
    beside: Option<PathBuf>,
    file: Option<File>,
}

impl Output {
    /// Opens a file beside `place`, before the work begins: an unwritable place is found out at once.
    pub fn create(place: &Path) -> Result<Self, Failure> {
        let wrong = |why: &str| Failure::Wrong(format!("cannot write '{}': {why}", place.display()));
        let Some(name) = place.file_name() else { return Err(wrong("that is no file name")) };
        let failed = |e: std::io::Error| wrong(&reason(&e));
        let old = fs::metadata(place).ok();
        match &old {
            Some(old) if old.is_dir() => return Err(wrong("that is a directory")),
            Some(old) if old.permissions().readonly() => return Err(wrong("it is write-protected")),
            Some(old) if !old.is_file() => {
                // A device has nothing beside it, and no old content to lose.
                let file = File::options().write(true).open(place).map_err(failed)?;
                return Ok(Self { place: place.into(), beside: None, file: Some(file) });
            }
            _ => {}
        }
        // A link is followed: the file that it names is the one that is replaced.
        let place = if old.is_some() { fs::canonicalize(place).map_err(failed)? } else { place.into() };
        let mut beside = place.file_name().unwrap_or(name).to_os_string();
        beside.push(format!(".{}.part", std::process::id()));
        let beside = place.with_file_name(beside);
        let file = File::create(&beside).map_err(failed)?;
        if let Some(old) = old {
            file.set_permissions(old.permissions()).map_err(failed)?;
        }
        Ok(Self { place, beside: Some(beside), file: Some(file) })
    }

    /// Writes the file and puts it in its place.
    pub fn finish(
        mut self,
        write: impl FnOnce(&mut BufWriter<&File>) -> std::io::Result<()>,
    ) -> Result<(), Failure> {
        let Some(file) = self.file.take() else { return Ok(()) };
        let mut buffer = BufWriter::new(&file);
        let written = write(&mut buffer).and_then(|()| buffer.flush());
        drop(buffer);
        let place = format!("'{}'", self.place.display());
        written
            .and_then(|()| match &self.beside {
                Some(beside) => file.sync_all().and_then(|()| fs::rename(beside, &self.place)),
                None => Ok(()),
            })
            .map_err(|e| Failure::of_writing(&place, &e))
    }
}

impl Drop for Output {
    fn drop(&mut self) {
        // After a rename there is nothing beside any more; otherwise nothing half-written stays.
        if let Some(beside) = &self.beside {
            let _ = fs::remove_file(beside);
        }
    }
}

/// The suffix of a file name, in lower case.
pub fn suffix(path: &Path) -> String {
    path.extension().map(|s| s.to_string_lossy().to_lowercase()).unwrap_or_default()
}
