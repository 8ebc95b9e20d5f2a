//! What is done of an ensemble, in a file that only grows: a program may be killed at any moment.

use crate::error::{Error, input};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// The first line of a checkpoint.
const MAGIC: &str = "precess checkpoint 1\n";

/// The numbers of chunks, on disk or in memory.
pub struct Checkpoint {
    /// The file and its name, which is empty where it has none.
    disk: Option<(File, PathBuf)>,
    /// Where the numbers of a chunk begin, and how many there are.
    places: BTreeMap<usize, (u64, usize)>,
    memory: BTreeMap<usize, Vec<f64>>,
    end: u64,
}

/// SHA-256 of a record: a record that was cut off has none.
fn seal(head: &[u8], numbers: &[u8]) -> [u8; 32] {
    let mut sha = Sha256::new();
    sha.update(head);
    sha.update(numbers);
    sha.finalize().into()
}

impl Checkpoint {
    /// In memory: nothing is left of it.
    pub fn in_memory() -> Self {
        Self { disk: None, places: BTreeMap::new(), memory: BTreeMap::new(), end: 0 }
    }

    /// In an empty file that nobody will take up again, such as one that goes away with the program.
    pub fn scratch(file: File) -> Self {
        Self { disk: Some((file, PathBuf::new())), ..Self::in_memory() }
    }

    /// In a file, which is made where there is none, and taken up where it belongs to the same ensemble.
    ///
    /// # Errors
    /// Where it belongs to another ensemble (with the first difference), or cannot be read or written.
    pub fn open(path: &Path, text: &str) -> Result<Self, Error> {
        let failed = |e: std::io::Error| Error::File(format!("checkpoint '{}': {e}", path.display()));
        let new = !path.exists();
        let options = || File::options().read(true).write(true).create(true).truncate(false).open(path);
        let mut file = options().map_err(failed)?;
        let head = format!("{MAGIC}{}\n{text}", text.len());
        let mut own = Self { disk: None, places: BTreeMap::new(), memory: BTreeMap::new(), end: 0 };
        if new || file.metadata().map_err(failed)?.len() == 0 {
            file.write_all(head.as_bytes()).map_err(failed)?;
            own.end = head.len() as u64;
        } else {
            own.end = Self::check(&mut file, path, &head)?;
            own.scan(&mut file).map_err(failed)?;
            // What was cut off is written over.
            file.set_len(own.end).map_err(failed)?;
        }
        own.disk = Some((file, path.into()));
        Ok(own)
    }

    /// Holds the head of a file against ours; gives its length.
    fn check(file: &mut File, path: &Path, head: &str) -> Result<u64, Error> {
        let mut found = vec![0; head.len()];
        let mut length = 0;
        // A short file is another head.
        while let Ok(n @ 1..) = file.read(&mut found[length..]) {
            length += n;
        }
        if found == head.as_bytes() {
            return Ok(head.len() as u64);
        }
        let found = String::from_utf8_lossy(&found[..length]).into_owned();
        if !found.starts_with(MAGIC) {
            return input(format!("'{}' is no checkpoint of this format", path.display()));
        }
        let pair = found.lines().zip(head.lines()).skip(2).find(|(a, b)| a != b);
        let (theirs, ours) = pair.unwrap_or(("something else", "this ensemble"));
        input(format!(
            "the checkpoint '{}' belongs to another ensemble: it has \"{theirs}\" where this one has \"{ours}\" (remove it to \
             begin anew)",
            path.display()
        ))
    }

    /// Finds the records that are whole.
    fn scan(&mut self, file: &mut File) -> std::io::Result<()> {
        let length = file.metadata()?.len();
        loop {
            let mut head = [0; 16];
            file.seek(SeekFrom::Start(self.end))?;
            if length - self.end < 48 {
                return Ok(());
            }
            file.read_exact(&mut head)?;
            let (chunk, count) = head.split_at(8);
            let number = |bytes: &[u8]| bytes.iter().rev().fold(0, |n: u64, b| n << 8 | u64::from(*b));
            let (chunk, count) = (number(chunk), number(count));
            if count > (length - self.end - 48) / 8 {
                return Ok(());
            }
            let mut numbers = vec![0; 8 * count as usize];
            let mut sealed = [0; 32];
            file.read_exact(&mut numbers)?;
            file.read_exact(&mut sealed)?;
            if sealed != seal(&head, &numbers) {
                return Ok(());
            }
            self.places.insert(chunk as usize, (self.end + 16, count as usize));
            self.end += 48 + 8 * count;
        }
    }

    /// Whether a chunk is done.
    pub fn has(&self, chunk: usize) -> bool {
        self.places.contains_key(&chunk) || self.memory.contains_key(&chunk)
    }

    /// Keeps the numbers of a chunk.
    pub(super) fn keep(&mut self, chunk: usize, numbers: &[f64]) -> Result<(), Error> {
        let Some((file, path)) = &mut self.disk else {
            self.memory.insert(chunk, numbers.to_vec());
            return Ok(());
        };
        let head: Vec<u8> = [chunk, numbers.len()].iter().flat_map(|n| (*n as u64).to_le_bytes()).collect();
        let body: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
        let record = [&head[..], &body, &seal(&head, &body)].concat();
        let written = file.seek(SeekFrom::Start(self.end)).and_then(|_| file.write_all(&record));
        written.map_err(|e| Error::File(format!("checkpoint '{}': {e}", path.display())))?;
        self.places.insert(chunk, (self.end + 16, numbers.len()));
        self.end += record.len() as u64;
        Ok(())
    }

    /// The numbers of a chunk; none where it is not done.
    pub(super) fn read(&mut self, chunk: usize) -> Result<Vec<f64>, Error> {
        let Some(((file, path), (place, count))) = self.disk.as_mut().zip(self.places.get(&chunk)) else {
            return Ok(self.memory.get(&chunk).cloned().unwrap_or_default());
        };
        let mut bytes = vec![0; 8 * count];
        let read = file.seek(SeekFrom::Start(*place)).and_then(|_| file.read_exact(&mut bytes));
        read.map_err(|e| Error::File(format!("checkpoint '{}': {e}", path.display())))?;
        let (words, _) = bytes.as_chunks::<8>();
        Ok(words.iter().map(|word| f64::from_le_bytes(*word)).collect())
    }

    /// Takes the file away, once its numbers are elsewhere.
    pub fn remove(self) {
        if let Some((_, path)) = self.disk {
            // A checkpoint that stays is found again, and does no harm.
            let _ = std::fs::remove_file(path);
        }
    }
}
