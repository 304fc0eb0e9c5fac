//! UF2 files for the RP2040's BOOTSEL drive.
//!
//! Source: the UF2 specification (512-byte blocks with 256 bytes of payload) and the RP2040's family id.

const MAGIC_START: [u32; 2] = [0x0A32_4655, 0x9E5D_5157];
const MAGIC_END: u32 = 0x0AB1_6F30;
const FLAG_FAMILY_ID: u32 = 0x2000;
const FAMILY_RP2040: u32 = 0xE48B_FF56;
const PAYLOAD: usize = 256;
const BLOCK: usize = 512;

/// Returns the UF2 file that writes `image` to flash from `address` on.
pub fn encode(image: &[u8], address: u32) -> Vec<u8> {
    let blocks = image.len().div_ceil(PAYLOAD);
    let mut file = Vec::with_capacity(blocks * BLOCK);
    for (number, payload) in image.chunks(PAYLOAD).enumerate() {
        let target = address + (number * PAYLOAD) as u32;
        let header = [
            MAGIC_START[0],
            MAGIC_START[1],
            FLAG_FAMILY_ID,
            target,
            PAYLOAD as u32,
            number as u32,
            blocks as u32,
            FAMILY_RP2040,
        ];
        for word in header {
            file.extend_from_slice(&word.to_le_bytes());
        }
        file.extend_from_slice(payload);
        file.resize((number + 1) * BLOCK - 4, 0);
        file.extend_from_slice(&MAGIC_END.to_le_bytes());
    }
    file
}

#[cfg(test)]
mod tests {
    use super::*;

    fn word(file: &[u8], at: usize) -> u32 {
        u32::from_le_bytes(file[at..at + 4].try_into().unwrap())
    }

    #[test]
    fn every_block_says_where_it_goes_and_how_many_there_are() {
        let image: Vec<u8> = (0..700).map(|n| n as u8).collect();
        let file = encode(&image, 0x1000_0000);
        assert_eq!(file.len(), 3 * 512);
        for block in 0..3 {
            let at = block * 512;
            assert_eq!(&file[at..at + 4], b"UF2\n");
            assert_eq!(word(&file, at + 12), 0x1000_0000 + block as u32 * 256);
            assert_eq!(word(&file, at + 20), block as u32);
            assert_eq!(word(&file, at + 24), 3);
            assert_eq!(word(&file, at + 28), 0xE48B_FF56);
            assert_eq!(word(&file, at + 508), 0x0AB1_6F30);
        }
    }

    #[test]
    fn payloads_put_together_are_the_image() {
        let image: Vec<u8> = (0..1000u32).map(|n| (n * 7) as u8).collect();
        let file = encode(&image, 0x1000_0000);
        let payloads: Vec<u8> = file.chunks(512).flat_map(|block| block[32..288].to_vec()).collect();
        assert_eq!(&payloads[..1000], &image[..]);
        assert!(payloads[1000..].iter().all(|&byte| byte == 0));
    }
}
