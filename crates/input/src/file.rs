//! Reading files that someone else has written.

use std::fs::{File, metadata};
use std::io::{Error, ErrorKind, Read, Result};
use std::path::Path;

/// All of a regular file of up to `largest` bytes. Pipes and devices are not opened: they may block, or never end.
///
/// # Errors
/// When it cannot be read, is another kind of file, or is larger.
pub fn read(path: &Path, largest: u64) -> Result<Vec<u8>> {
    require_regular(path)?;
    let mut bytes = Vec::new();
    File::open(path)?.take(largest.saturating_add(1)).read_to_end(&mut bytes)?;
    match bytes.len() as u64 > largest {
        true => Err(Error::new(ErrorKind::FileTooLarge, format!("it is larger than {} MiB", largest >> 20))),
        false => Ok(bytes),
    }
}

/// Opens a file to add to it, which is made if need be.
///
/// # Errors
/// When it cannot be opened, or another kind of file stands there.
pub fn append(path: &Path) -> Result<File> {
    if path.symlink_metadata().is_ok() {
        require_regular(path)?;
    }
    File::options().append(true).create(true).open(path)
}

/// Refuses folders, pipes and devices.
///
/// # Errors
/// Also when nothing exists at the path.
pub fn require_regular(path: &Path) -> Result<()> {
    let kind = metadata(path)?.file_type();
    if kind.is_dir() {
        return Err(Error::new(ErrorKind::IsADirectory, "it is a folder"));
    }
    match kind.is_file() {
        true => Ok(()),
        false => Err(Error::new(ErrorKind::InvalidInput, "it is a pipe, a device or a socket; name a file on a disk")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_read_up_to_its_largest_size() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        std::fs::write(&file, vec![7; 1 << 20]).unwrap();
        assert_eq!(read(&file, 1 << 20).unwrap().len(), 1 << 20);
        std::fs::write(&file, vec![7; (1 << 20) + 1]).unwrap();
        assert_eq!(read(&file, 1 << 20).unwrap_err().to_string(), "it is larger than 1 MiB");
        assert_eq!(read(folder.path(), 1).unwrap_err().kind(), ErrorKind::IsADirectory);
        assert_eq!(read(&folder.path().join("missing"), 1).unwrap_err().kind(), ErrorKind::NotFound);
    }

    #[cfg(unix)]
    #[test]
    fn devices_and_sockets_are_not_opened() {
        let folder = tempfile::tempdir().unwrap();
        let socket = folder.path().join("socket");
        let _listener = std::os::unix::net::UnixListener::bind(&socket).unwrap();
        for path in [Path::new("/dev/zero"), &socket] {
            assert_eq!(read(path, 1).unwrap_err().kind(), ErrorKind::InvalidInput);
            assert_eq!(append(path).unwrap_err().kind(), ErrorKind::InvalidInput);
        }
    }
}
