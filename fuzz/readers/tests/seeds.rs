//! Every reader on its seeds, and on copies of them in which a few bytes are changed, left out or
//! repeated.

use eigenshade_fuzz_readers::READERS;
use std::fs;
use std::path::Path;

const COPIES: usize = 25;

/// Arbitrary numbers: those of xorshift64*.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let high = self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 33;
        high as usize % bound.max(1)
    }
}

/// Changes one to four places.
fn change(bytes: &mut Vec<u8>, numbers: &mut Numbers) {
    for _ in 0..=numbers.below(4) {
        let place = numbers.below(bytes.len());
        let end = (place + 1 + numbers.below(8)).min(bytes.len());
        match numbers.below(4) {
            0 => bytes.get_mut(place).into_iter().for_each(|byte| *byte ^= 1 << numbers.below(8)),
            1 => bytes.get_mut(place).into_iter().for_each(|byte| *byte = numbers.below(256) as u8),
            2 => _ = bytes.drain(place..end),
            _ => {
                let repeated = bytes[place..end].to_vec();
                bytes.splice(place..place, repeated);
            }
        }
    }
}

#[test]
fn readers_keep_their_invariants() {
    let mut numbers = Numbers(1);
    for (name, reader) in READERS {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("seeds/read_{name}"));
        let mut paths: Vec<_> = fs::read_dir(folder)
            .expect("seeds")
            .map(|entry| entry.expect("a seed").path())
            .collect();
        paths.sort();
        assert!(!paths.is_empty(), "{name} has no seed");
        for path in paths {
            let seed = fs::read(&path).expect("a seed");
            reader(&seed);
            for _ in 0..COPIES {
                let mut copy = seed.clone();
                change(&mut copy, &mut numbers);
                reader(&copy);
            }
        }
    }
}
