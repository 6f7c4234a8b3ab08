//! Hand-made ZIP archives.

use miniz_oxide::deflate::compress_to_vec;

fn crc(bytes: &[u8]) -> u32 {
    // A table of all bytes is used because some contents are several megabytes long.
    let shifted = |byte: u8| {
        (0..8).fold(u32::from(byte), |sum, _| {
            sum >> 1 ^ if sum & 1 == 1 { 0xedb8_8320 } else { 0 }
        })
    };
    let table: Vec<u32> = (0..=u8::MAX).map(shifted).collect();
    !bytes.iter().fold(!0_u32, |sum, &byte| {
        sum >> 8 ^ table[usize::from(sum.to_le_bytes()[0] ^ byte)]
    })
}

/// A file within an archive: its name, its content, and whether it is deflated.
pub(crate) type Entry<'a> = (&'a str, &'a [u8], bool);

/// Returns an archive of the entries.
pub(crate) fn zip(entries: &[Entry<'_>]) -> Vec<u8> {
    let half = |number: usize| u16::try_from(number).unwrap().to_le_bytes();
    let word = |number: usize| u32::try_from(number).unwrap().to_le_bytes();
    let (mut bytes, mut directory) = (Vec::new(), Vec::new());
    for (name, content, is_deflated) in entries {
        let packed = if *is_deflated {
            compress_to_vec(content, 9)
        } else {
            content.to_vec()
        };
        let start = bytes.len();
        let mut common = [0; 26];
        common[0] = 20;
        common[4] = if *is_deflated { 8 } else { 0 };
        common[10..14].copy_from_slice(&crc(content).to_le_bytes());
        common[14..18].copy_from_slice(&word(packed.len()));
        common[18..22].copy_from_slice(&word(content.len()));
        common[22..24].copy_from_slice(&half(name.len()));
        bytes.extend_from_slice(b"PK\x03\x04");
        bytes.extend_from_slice(&common);
        bytes.extend_from_slice(name.as_bytes());
        bytes.extend_from_slice(&packed);
        directory.extend_from_slice(b"PK\x01\x02\x14\x00");
        directory.extend_from_slice(&common);
        directory.extend_from_slice(&[0; 10]);
        directory.extend_from_slice(&word(start));
        directory.extend_from_slice(name.as_bytes());
    }
    let start = bytes.len();
    bytes.extend_from_slice(&directory);
    bytes.extend_from_slice(b"PK\x05\x06\0\0\0\0");
    bytes.extend_from_slice(&half(entries.len()));
    bytes.extend_from_slice(&half(entries.len()));
    bytes.extend_from_slice(&word(directory.len()));
    bytes.extend_from_slice(&word(start));
    bytes.extend_from_slice(&[0, 0]);
    bytes
}
