//! Files that a command writes where its user says: never over another one unasked, never half.

use anyhow::{Context, Result, bail};
use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// A file to be written.
#[derive(Clone, Debug)]
pub struct Output {
    path: PathBuf,
    /// A file that is already there is meant to be replaced.
    overwrite: bool,
}

impl Output {
    /// Checks a file that is to be written, before anything is.
    ///
    /// # Errors
    /// If it is one of `inputs`, by whatever name; if it is there and `overwrite` does not allow that; if its folder is
    /// missing.
    pub fn checked(path: &Path, overwrite: bool, inputs: &[&Path]) -> Result<Self> {
        let name = path.display();
        if let Some(input) = inputs.iter().find(|input| is_same_file(path, input)) {
            bail!("{name} is the same file as {}, which is read; choose another name", input.display());
        }
        if !overwrite && path.symlink_metadata().is_ok() {
            bail!(there(path));
        }
        let folder = folder(path);
        if !folder.is_dir() {
            bail!("cannot write {name}: there is no folder {}", folder.display());
        }
        Ok(Self { path: path.to_owned(), overwrite })
    }

    /// Name of the file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Creates the file, to be written bit by bit.
    ///
    /// # Errors
    /// If that fails, or the file is there by now and must not be overwritten.
    pub fn create(&self) -> Result<File> {
        let mut options = OpenOptions::new();
        options.write(true);
        if self.overwrite {
            options.create(true).truncate(true)
        } else {
            options.create_new(true)
        };
        options.open(&self.path).map_err(|error| self.explained(error))
    }

    /// Tries whether [`Output::write_whole`] could create a file in this folder, and leaves none.
    ///
    /// # Errors
    /// If not.
    pub fn try_whole(&self) -> Result<()> {
        if self.path.metadata().is_ok_and(|found| !found.is_file()) {
            bail!("cannot write {}: it is there and is no file", self.path.display());
        }
        let part = self.part();
        let tried = File::create_new(&part).and_then(|_| fs::remove_file(&part));
        tried.map_err(|error| self.explained(error))
    }

    /// Writes the whole file or nothing: under another name first, which is then changed.
    ///
    /// # Errors
    /// If that fails, or the file is there by now and must not be overwritten.
    pub fn write_whole(&self, bytes: &[u8]) -> Result<()> {
        self.write_by(|file| Ok(file.write_all(bytes)?))
    }

    /// Like [`Output::write_whole`], of bytes that `write` makes one after another.
    ///
    /// # Errors
    /// Like [`Output::write_whole`], and what `write` returns.
    pub fn write_by(&self, write: impl FnOnce(&mut File) -> Result<()>) -> Result<()> {
        let part = self.part();
        let written = File::create_new(&part).map_err(anyhow::Error::new).and_then(|mut file| {
            write(&mut file)?;
            file.sync_all()?;
            if !self.overwrite && self.path.symlink_metadata().is_ok() {
                return Err(io::Error::from(ErrorKind::AlreadyExists).into());
            }
            // A link is followed: what it leads to is replaced, the link stays.
            Ok(fs::rename(&part, fs::canonicalize(&self.path).as_ref().unwrap_or(&self.path))?)
        });
        if written.is_err() {
            // Nothing more can be done about what is left of it.
            let _ = fs::remove_file(&part);
        }
        written.map_err(|error| match error.downcast::<io::Error>() {
            Ok(error) => self.explained(error),
            Err(other) => other,
        })
    }

    /// Another name in the same folder, this process's own.
    fn part(&self) -> PathBuf {
        let target = fs::canonicalize(&self.path).unwrap_or_else(|_| self.path.clone());
        let mut name = OsString::from(".");
        name.push(target.file_name().unwrap_or_default());
        name.push(format!(".{}.part", std::process::id()));
        target.with_file_name(name)
    }

    fn explained(&self, error: io::Error) -> anyhow::Error {
        if error.kind() == ErrorKind::AlreadyExists && self.path.symlink_metadata().is_ok() {
            return anyhow::anyhow!(there(&self.path));
        }
        anyhow::Error::new(error).context(format!("cannot write {}", self.path.display()))
    }
}

/// Cuts a file down to so many bytes, as far as its kind allows.
///
/// # Errors
/// If the file cannot be cut.
pub fn cut(file: &File, bytes: u64) -> Result<()> {
    file.set_len(bytes).context("what was written of the last line stays in it")
}

fn there(path: &Path) -> String {
    format!("{} is already there; choose another name, or say --overwrite", path.display())
}

/// The folder in which a file stands.
fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

/// Returns whether two names lead to one file: links of both kinds are followed.
#[cfg(unix)]
fn is_same_file(one: &Path, other: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let identity = |path: &Path| path.metadata().ok().map(|found| (found.dev(), found.ino()));
    identity(one).is_some_and(|one| Some(one) == identity(other)) || is_same_name(one, other)
}

/// Returns whether two names lead to one file: symbolic links are followed.
#[cfg(not(unix))]
fn is_same_file(one: &Path, other: &Path) -> bool {
    is_same_name(one, other)
}

/// Returns whether two names are the same, be the file there or not.
fn is_same_name(one: &Path, other: &Path) -> bool {
    let whole = |path: &Path| Some(fs::canonicalize(folder(path)).ok()?.join(path.file_name()?));
    let real = |path: &Path| fs::canonicalize(path).ok().or_else(|| whole(path));
    real(one).is_some_and(|one| Some(one) == real(other))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(folder: &Path, name: &str) -> PathBuf {
        let path = folder.join(name);
        fs::write(&path, name).unwrap();
        path
    }

    fn refused(path: &Path, overwrite: bool, inputs: &[&Path]) -> String {
        Output::checked(path, overwrite, inputs).unwrap_err().to_string()
    }

    #[test]
    fn a_file_that_is_read_is_never_written_whatever_it_is_called() {
        let folder = tempfile::tempdir().unwrap();
        let log = written(folder.path(), "a.log");
        fs::create_dir(folder.path().join("b")).unwrap();
        let round_about = folder.path().join("b/../a.log");
        let hard = folder.path().join("hard.log");
        fs::hard_link(&log, &hard).unwrap();
        let mut names = vec![log.clone(), round_about, hard];
        #[cfg(unix)]
        {
            let soft = folder.path().join("soft.log");
            std::os::unix::fs::symlink("a.log", &soft).unwrap();
            names.push(soft);
        }
        for name in &names {
            for overwrite in [false, true] {
                let said = refused(name, overwrite, &[&log]);
                assert!(said.contains("is the same file as"), "{said}");
            }
        }
        // Two files that are not there yet.
        let said = refused(&folder.path().join("b/../new"), false, &[&folder.path().join("new")]);
        assert!(said.contains("is the same file as"), "{said}");
    }

    #[test]
    fn a_file_that_is_there_is_overwritten_only_if_asked() {
        let folder = tempfile::tempdir().unwrap();
        let old = written(folder.path(), "old");
        let said = refused(&old, false, &[]);
        assert!(said.ends_with("old is already there; choose another name, or say --overwrite"), "{said}");
        Output::checked(&old, true, &[]).unwrap().write_whole(b"new").unwrap();
        assert_eq!(fs::read(&old).unwrap(), b"new");
        // One that comes between check and writing is kept too.
        let late = Output::checked(&folder.path().join("late"), false, &[]).unwrap();
        written(folder.path(), "late");
        assert!(late.create().unwrap_err().to_string().contains("already there"));
        assert!(late.write_whole(b"new").unwrap_err().to_string().contains("already there"));
        assert_eq!(fs::read(folder.path().join("late")).unwrap(), b"late");
        let left: Vec<_> =
            fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        assert_eq!(left.len(), 2, "no part is left: {left:?}");
    }

    #[test]
    fn a_folder_that_is_missing_or_no_file_is_found_before_the_run() {
        let folder = tempfile::tempdir().unwrap();
        let said = refused(&folder.path().join("no/such.png"), true, &[]);
        assert!(said.contains("there is no folder"), "{said}");
        let said = Output::checked(folder.path(), true, &[]).unwrap().try_whole().unwrap_err().to_string();
        assert!(said.contains("is no file"), "{said}");
    }
}
