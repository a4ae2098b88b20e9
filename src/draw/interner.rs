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

/// A 64-bit hash of words: multiply and rotate, mixed at the end.
pub fn hash_words(words: &[u32]) -> u64 {
    const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;
    let mut hash = words.len() as u64;
    let (pairs, rest) = words.as_chunks::<2>();
    for pair in pairs {
        let word = u64::from(pair[0]) | u64::from(pair[1]) << 32;
        hash = (hash.rotate_left(23) ^ word).wrapping_mul(FACTOR);
    }
    for &word in rest {
        hash = (hash.rotate_left(23) ^ u64::from(word)).wrapping_mul(FACTOR);
    }
    hash ^ hash >> 32
}

/// Index of each record by its hash. Two records of one hash are told apart by comparison; the later one takes the entry.
#[derive(Default)]
pub struct Interner {
    map: HashMap<u64, u32, WordHasher>,
    last: u32,
}

impl Interner {
    /// Forgets all.
    pub fn clear(&mut self) {
        self.map.clear();
        self.last = 0;
    }

    /// Index in `all` of `record` (one element, whose bytes are `bytes`).
    pub fn intern<T: Pod + PartialEq>(&mut self, bytes: &[u8], all: &mut Vec<T>, record: &[T]) -> u32 {
        let same = |index: u32| all.get(index as usize).is_some_and(|other| bytemuck::bytes_of(other) == bytes);
        if same(self.last) {
            return self.last;
        }
        let key = hash_words(bytemuck::cast_slice(bytes));
        if let Some(&index) = self.map.get(&key)
            && same(index)
        {
            self.last = index;
            return index;
        }
        self.last = all.len() as u32;
        all.extend_from_slice(record);
        self.map.insert(key, self.last);
        self.last
    }

    /// Index in `all` of the first vec4 of `block`.
    pub fn intern_block(&mut self, block: &[[f32; 4]], all: &mut Vec<[f32; 4]>) -> u32 {
        if block.is_empty() {
            return 0;
        }
        let bytes: &[u8] = bytemuck::cast_slice(block);
        let key = hash_words(bytemuck::cast_slice(block));
        if let Some(&index) = self.map.get(&key)
            && all.get(index as usize..index as usize + block.len()).is_some_and(|other| bytemuck::cast_slice::<_, u8>(other) == bytes)
        {
            return index;
        }
        let index = all.len() as u32;
        all.extend_from_slice(block);
        self.map.insert(key, index);
        index
    }
}
