//! Names of objects: given out first, objects once they are bound.

use std::collections::HashMap;

/// Objects by name.
pub(crate) struct ObjectNames<T> {
    /// `None` for names that were given out and nothing bound yet.
    objects: HashMap<u32, Option<T>>,
    last: u32,
}

impl<T> Default for ObjectNames<T> {
    fn default() -> ObjectNames<T> {
        ObjectNames { objects: HashMap::new(), last: 0 }
    }
}

impl<T: Default> ObjectNames<T> {
    /// A name that nothing has.
    pub fn generate(&mut self) -> u32 {
        loop {
            self.last = self.last.wrapping_add(1);
            if self.last != 0 && !self.objects.contains_key(&self.last) {
                self.objects.insert(self.last, None);
                return self.last;
            }
        }
    }

    /// The name was given out, or bound, and not deleted since.
    pub fn is_name(&self, name: u32) -> bool {
        self.objects.contains_key(&name)
    }

    /// The object of a name that was bound before.
    pub fn get(&self, name: u32) -> Option<&T> {
        self.objects.get(&name)?.as_ref()
    }

    /// The same, to change.
    pub fn get_mut(&mut self, name: u32) -> Option<&mut T> {
        self.objects.get_mut(&name)?.as_mut()
    }

    /// The object of a name, a new one where it has none yet.
    pub fn bind(&mut self, name: u32) -> &mut T {
        self.objects.entry(name).or_default().get_or_insert_default()
    }

    /// Takes a name away; its object, if it had one.
    pub fn remove(&mut self, name: u32) -> Option<T> {
        self.objects.remove(&name).flatten()
    }
}
