//! The names of a share group's display lists, as ranges: glGenLists may ask for any number of names at once.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::sync::Arc;

use super::list::List;

/// Display lists by name.
#[derive(Default)]
pub struct Lists {
    /// Lists that were defined.
    defined: BTreeMap<u32, Arc<List>>,
    /// Names in use, generated or defined: first to last of ranges that do not touch.
    names: BTreeMap<u32, u32>,
}

impl Lists {
    /// The list of a name, if it was defined.
    pub fn get(&self, name: u32) -> Option<Arc<List>> {
        self.defined.get(&name).cloned()
    }

    /// Defines a list; returns the old one.
    pub fn define(&mut self, name: u32, list: Arc<List>) -> Option<Arc<List>> {
        self.reserve(name..=name);
        self.defined.insert(name, list)
    }

    /// The name is in use.
    pub fn contains(&self, name: u32) -> bool {
        self.names.range(..=name).next_back().is_some_and(|(_, &last)| name <= last)
    }

    /// Reserves `count` unused names in a row and returns the first; 0 if there are none.
    pub fn generate(&mut self, count: u32) -> u32 {
        let free = |before: u32, after: u32| after - before > count;
        let mut before = self.names.last_key_value().map_or(0, |(_, &last)| last);
        if u32::MAX - before < count {
            // Only after names near the end were used: the first gap that is wide enough.
            let mut last_used = 0;
            let gap = self.names.iter().find_map(|(&first, &last)| {
                let found = free(last_used, first).then_some(last_used);
                last_used = last;
                found
            });
            match gap {
                Some(gap) => before = gap,
                None => return 0,
            }
        }
        self.reserve(before + 1..=before + count);
        before + 1
    }

    fn reserve(&mut self, names: RangeInclusive<u32>) {
        let (mut first, mut last) = names.into_inner();
        // Ranges that it overlaps or touches become one with it.
        while let Some((&f, &l)) = self.names.range(..=last.saturating_add(1)).next_back()
            && l >= first.saturating_sub(1)
        {
            self.names.remove(&f);
            (first, last) = (first.min(f), last.max(l));
        }
        self.names.insert(first, last);
    }

    /// Frees names; returns the lists, for the caller to drop where it holds no lock.
    pub fn remove(&mut self, names: RangeInclusive<u32>) -> BTreeMap<u32, Arc<List>> {
        let (first, last) = names.into_inner();
        while let Some((&f, &l)) = self.names.range(..=last).next_back()
            && l >= first
        {
            self.names.remove(&f);
            if f < first {
                self.names.insert(f, first - 1);
            }
            if l > last {
                self.names.insert(last + 1, l);
            }
        }
        let mut removed = self.defined.split_off(&first);
        if let Some(after) = last.checked_add(1) {
            self.defined.append(&mut removed.split_off(&after));
        }
        removed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn generated_names_are_new_and_stay_used() {
        let mut lists = Lists::default();
        assert_eq!(lists.generate(3), 1);
        assert_eq!(lists.generate(1), 4);
        lists.define(9, Default::default());
        assert_eq!(lists.generate(2), 10);
        assert!(lists.contains(4) && lists.contains(11) && !lists.contains(5) && !lists.contains(12));
    }

    #[test]
    fn freed_names_are_cut_out() {
        let mut lists = Lists::default();
        lists.generate(10);
        lists.define(5, Default::default());
        assert_eq!(lists.remove(4..=6).len(), 1);
        let used: Vec<u32> = (0..12).filter(|&n| lists.contains(n)).collect();
        assert_eq!(used, [1, 2, 3, 7, 8, 9, 10]);
        assert!(lists.get(5).is_none());
    }

    #[test]
    fn names_at_the_end_leave_gaps_to_be_found() {
        let mut lists = Lists::default();
        lists.define(u32::MAX, Default::default());
        lists.define(3, Default::default());
        assert_eq!(lists.generate(2), 1);
        assert_eq!(lists.generate(5), 4);
        assert_eq!(lists.generate(u32::MAX), 0);
    }
}
