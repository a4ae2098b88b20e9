//! Where arguments come from: a seeded stream of numbers, pools of values that matter, and memory to point to.

use std::ffi::{c_char, c_void};
use std::fmt::Debug;

use crate::calls::EVERY;

/// Bytes of the large areas: more than any pixel rectangle of [`SIZE`] under any pixel store of [`SIZE`] takes.
const AREA: usize = 40 << 20;
/// Largest size, stride, count, skip.
const SIZE: i32 = 64;

/// Draws arguments.
pub struct Draw {
    state: u64,
    /// Says each call before it is made.
    pub trace: bool,
    line: String,
    data: Vec<u8>,
    room: Vec<u64>,
    small: Vec<u32>,
    floats: Vec<f32>,
    doubles: Vec<f64>,
    pointers: Vec<*const c_void>,
    /// The list under construction.
    pub compiling: Option<u32>,
    /// The name last drawn for a list.
    pub last_list: u32,
}

impl Draw {
    /// The same seed draws the same arguments.
    pub fn new(seed: u64) -> Draw {
        let mut draw = Draw {
            state: seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x1234_5678_9abc_def1,
            trace: false,
            line: String::new(),
            data: Vec::new(),
            room: vec![0; AREA / 8],
            small: Vec::new(),
            floats: Vec::new(),
            doubles: Vec::new(),
            pointers: Vec::new(),
            compiling: None,
            last_list: 0,
        };
        draw.data = (0..AREA / 8).flat_map(|_| draw.next().to_ne_bytes()).collect();
        // Little-endian, so that a byte, a short and a word read from an aligned address are all small.
        draw.small = (0..1 << 16).map(|_| draw.next() as u32 % SIZE as u32).collect();
        draw.floats = (0..1 << 16).map(|_| draw.number() as f32).collect();
        draw.doubles = (0..1 << 16).map(|_| draw.number()).collect();
        draw.pointers = (0..256).map(|i| draw.small[i * 16..].as_ptr().cast()).collect();
        draw
    }

    /// The next number (xorshift64*).
    pub fn next(&mut self) -> u64 {
        self.state ^= self.state >> 12;
        self.state ^= self.state << 25;
        self.state ^= self.state >> 27;
        self.state.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 8
    }

    /// A number below `n`.
    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    /// True once in `n` times.
    pub fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    fn say<T: Debug>(&mut self, value: T) -> T {
        if self.trace {
            self.line += &format!(" {value:?}");
        }
        value
    }

    /// Starts a call.
    pub fn start(&mut self, name: &str) {
        if self.trace {
            self.line = name.to_string();
        }
    }

    /// All arguments of the call are drawn.
    pub fn ready(&mut self) {
        if self.trace {
            println!("{}", self.line);
        }
    }

    /// An enum: usually one of the group, if there is a group.
    pub fn choice(&mut self, group: &[u32]) -> u32 {
        let value = match self.below(12) {
            0 => self.next() as u32,
            1 => EVERY[self.below(EVERY.len())],
            2 => self.below(16) as u32,
            _ if group.is_empty() => EVERY[self.below(EVERY.len())],
            _ => group[self.below(group.len())],
        };
        self.say(value)
    }

    /// A boolean, now and then neither 0 nor 1.
    pub fn boolean(&mut self) -> u8 {
        let value = if self.one_in(16) { self.next() as u8 } else { self.below(2) as u8 };
        self.say(value)
    }

    /// A mask: usually of bits of the group.
    pub fn bits(&mut self, group: &[u32]) -> u32 {
        let value = match self.below(16) {
            0 => self.next() as u32,
            1 => u32::MAX,
            _ if group.is_empty() => 1 << self.below(20) | 1 << self.below(20),
            _ => group[self.below(group.len())] | group[self.below(group.len())],
        };
        self.say(value)
    }

    /// A size or count that memory is there for.
    pub fn size(&mut self) -> i32 {
        let value = match self.below(10) {
            0 => -1,
            1 => 0,
            2 => 1,
            3 => 1 << self.below(7),
            4 => i32::MIN,
            _ => self.below(SIZE as usize + 1) as i32,
        };
        self.say(value)
    }

    /// A size of what may be refused for its size.
    pub fn any_size(&mut self) -> i32 {
        if self.one_in(12) {
            let value = [i32::MAX, 16384 * 2, 1 << 30, 65536][self.below(4)];
            return self.say(value);
        }
        self.size()
    }

    /// An integer that something is read or done by.
    pub fn int(&mut self) -> i32 {
        let value = match self.below(8) {
            0 => -(self.below(4) as i32),
            _ => self.below(if self.state & 64 == 0 { 5 } else { SIZE as usize }) as i32,
        };
        self.say(value)
    }

    /// Any integer.
    pub fn wild(&mut self) -> i32 {
        let value = match self.below(8) {
            0 => [i32::MIN, i32::MAX, i32::MIN + 1, 0x7fff, -0x8000, 0xffff][self.below(6)],
            1 => self.next() as i32,
            2 => EVERY[self.below(EVERY.len())] as i32,
            _ => self.below(80) as i32 - 8,
        };
        self.say(value)
    }

    /// A name, index or mask.
    pub fn uint(&mut self) -> u32 {
        let value = match self.below(10) {
            0 => self.next() as u32,
            1 => u32::MAX,
            _ => self.below(10) as u32,
        };
        self.say(value)
    }

    /// The name of a list. Only list 1 is called from lists, and it calls none: what a program of a few calls can make execute stays bounded.
    pub fn list(&mut self, command: &str) -> u32 {
        let value = match self.compiling {
            Some(1) if command == "glCallList" => 999,
            Some(_) if command == "glCallList" => 1,
            _ => 1 + self.below(8) as u32,
        };
        self.last_list = value;
        self.say(value)
    }

    fn number(&mut self) -> f64 {
        if !self.one_in(6) {
            return (self.next() % 20_001) as f64 / 10_000.0 - 1.0;
        }
        match self.below(13) {
            0 => f64::NAN,
            1 => f64::INFINITY,
            2 => f64::NEG_INFINITY,
            3 => 0.0,
            4 => -0.0,
            5 => 1e30,
            6 => -1e38,
            7 => 1e-40,
            8 => f64::from(self.next() as u32),
            9 => 1e300,
            _ => self.below(100) as f64 - 20.0,
        }
    }

    /// A float.
    pub fn float(&mut self) -> f32 {
        let value = self.number() as f32;
        self.say(value)
    }

    /// A double.
    pub fn double(&mut self) -> f64 {
        let value = self.number();
        self.say(value)
    }

    fn null(&mut self) -> bool {
        let null = self.one_in(20);
        if self.trace {
            self.line += if null { " NULL" } else { " POINTER" };
        }
        null
    }

    /// Random bytes to read, at any alignment.
    pub fn data(&mut self) -> *const u8 {
        let at = self.below(4096);
        if self.null() { std::ptr::null() } else { self.data[at..].as_ptr() }
    }

    /// Room to write.
    pub fn room(&mut self) -> *mut u64 {
        let at = self.below(512);
        if self.null() { std::ptr::null_mut() } else { self.room[at..].as_mut_ptr() }
    }

    /// Small numbers to read: indices, names, counts.
    pub fn small(&mut self) -> *const u32 {
        let at = self.below(4096);
        if self.null() { std::ptr::null() } else { self.small[at..].as_ptr() }
    }

    /// Floats to read.
    pub fn floats(&mut self) -> *const f32 {
        let at = self.below(4096);
        if self.null() { std::ptr::null() } else { self.floats[at..].as_ptr() }
    }

    /// Doubles to read.
    pub fn doubles(&mut self) -> *const f64 {
        let at = self.below(4096);
        if self.null() { std::ptr::null() } else { self.doubles[at..].as_ptr() }
    }

    /// Pointers to small numbers.
    pub fn pointers(&mut self) -> *const *const c_void {
        let at = self.below(64);
        if self.null() { std::ptr::null() } else { self.pointers[at..].as_ptr() }
    }

    /// A string.
    pub fn text(&mut self) -> *const c_char {
        if self.null() { std::ptr::null() } else { c"void main() { gl_Position = vec4(0); }".as_ptr() }
    }
}
