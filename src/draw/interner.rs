//! Interning by content: equal records get one index.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use bytemuck::Pod;

/// Keys are hashes already.
#[derive(Default)]
pub struct Identity(u64);

impl Hasher for Identity {
    fn finish(&self) -> u64 {
        self.0
    }
    fn write(&mut self, _: &[u8]) {
        unreachable!("only u64 keys are hashed")
    }
    fn write_u64(&mut self, hash: u64) {
        self.0 = hash;
    }
}

/// For maps whose keys are hashes.
pub type WordHasher = BuildHasherDefault<Identity>;

/// A 64-bit hash of words: multiply and rotate, mixed at the end. Four lanes take turns, because each product waits for the one
/// before it in its lane.
pub fn hash_words(words: &[u32]) -> u64 {
    const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;
    let step = |hash: u64, word: u64| (hash.rotate_left(23) ^ word).wrapping_mul(FACTOR);
    let mut lanes = [words.len() as u64, 1, 2, 3];
    let (blocks, rest) = words.as_chunks::<8>();
    for block in blocks {
        for (k, lane) in lanes.iter_mut().enumerate() {
            *lane = step(*lane, u64::from(block[2 * k]) | u64::from(block[2 * k + 1]) << 32);
        }
    }
    for &word in rest {
        lanes[0] = step(lanes[0], u64::from(word));
    }
    let hash = lanes.into_iter().fold(0, step);
    hash ^ hash >> 32
}

/// Index of each block of records by its hash. Two blocks of one hash are told apart by comparison; the later one takes the entry.
#[derive(Default)]
pub struct Interner {
    map: HashMap<u64, u32, WordHasher>,
    /// Index and length of the last two that were asked for, the later one first: state that is switched to and fro is found without
    /// hashing.
    recent: [(u32, usize); 2],
}

impl Interner {
    /// Forgets all.
    pub fn clear(&mut self) {
        self.map.clear();
        self.recent = Default::default();
    }

    /// Index in `all` of the first record of `block`, which is added if it is not there; 0 if it is empty.
    pub fn intern<T: Pod>(&mut self, all: &mut Vec<T>, block: &[T]) -> u32 {
        if block.is_empty() {
            return 0;
        }
        let [last, before] = self.recent;
        let is = |(index, length): (u32, usize)| length == block.len() && is_at(all, index, block);
        if is(last) {
            return last.0;
        }
        let index = if is(before) { before.0 } else { self.find_or_add(all, block) };
        self.recent = [(index, block.len()), last];
        index
    }

    fn find_or_add<T: Pod>(&mut self, all: &mut Vec<T>, block: &[T]) -> u32 {
        let key = hash_words(bytemuck::cast_slice(block));
        if let Some(&index) = self.map.get(&key)
            && is_at(all, index, block)
        {
            return index;
        }
        let index = all.len() as u32;
        all.extend_from_slice(block);
        self.map.insert(key, index);
        index
    }
}

/// `block` is at `index` of `all`, to the bit.
fn is_at<T: Pod>(all: &[T], index: u32, block: &[T]) -> bool {
    let there = all.get(index as usize..index as usize + block.len());
    there.is_some_and(|there| bytemuck::cast_slice::<_, u8>(there) == bytemuck::cast_slice::<_, u8>(block))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_blocks_have_one_index_however_they_come() {
        let (mut interner, mut all) = (Interner::default(), Vec::new());
        let blocks: Vec<[[f32; 4]; 2]> = (0..5).map(|k| [[k as f32; 4], [0.5; 4]]).collect();
        let mut index = |k: usize| interner.intern(&mut all, &blocks[k]);
        for k in [0, 1, 0, 1, 2, 0, 3, 3, 4, 1, 0, 2] {
            assert_eq!(index(k), 2 * k as u32);
        }
        assert_eq!(all, blocks.as_flattened());
    }

    #[test]
    fn the_beginning_of_a_block_is_another_block() {
        let (mut interner, mut all) = (Interner::default(), Vec::new());
        assert_eq!(interner.intern(&mut all, &[[1.0f32; 4], [2.0; 4]]), 0);
        assert_eq!(interner.intern(&mut all, &[[1.0; 4]]), 2);
        assert_eq!(interner.intern(&mut all, &[[1.0; 4], [2.0; 4]]), 0);
    }

    #[test]
    fn blocks_are_compared_to_the_bit() {
        let (mut interner, mut all) = (Interner::default(), Vec::new());
        let [zero, minus, nan] = [0.0, -0.0, f32::NAN].map(|x| [[x; 4]]);
        assert_ne!(interner.intern(&mut all, &zero), interner.intern(&mut all, &minus));
        assert_eq!(interner.intern(&mut all, &nan), interner.intern(&mut all, &nan));
    }

    #[test]
    fn every_word_counts_in_a_hash() {
        for length in [1, 7, 8, 9, 33] {
            let words = vec![0; length];
            let mut hashes = vec![hash_words(&words)];
            for k in 0..length {
                let mut other = words.clone();
                other[k] = 1;
                hashes.push(hash_words(&other));
            }
            let count = hashes.len();
            hashes.sort_unstable();
            hashes.dedup();
            assert_eq!(hashes.len(), count, "{length} words");
        }
    }
}
