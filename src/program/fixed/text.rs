//! Builds the text of a program: statements of the body and the slots of the uniform block.

use std::fmt::Write;

use super::slots::Slot;

#[derive(Default)]
pub(super) struct Text {
    pub body: String,
    pub slots: Vec<Slot>,
}

impl Text {
    /// Adds a statement.
    pub fn line(&mut self, statement: impl AsRef<str>) {
        self.body.push_str("    ");
        self.body.push_str(statement.as_ref());
        self.body.push('\n');
    }

    /// The expression that reads a slot.
    pub fn slot(&mut self, slot: Slot) -> String {
        let index = self.slots.iter().position(|s| *s == slot).unwrap_or_else(|| {
            self.slots.push(slot);
            self.slots.len() - 1
        });
        format!("uniforms[base + {index}u]")
    }

    /// `matrix * v` as columns times components, added from the first to the last and never fused: Mesa's order.
    pub fn transform(&mut self, column: impl Fn(u8) -> Slot, v: &str) -> String {
        let [x, y, z, w] = [0, 1, 2, 3].map(|c| self.slot(column(c)));
        format!("((product({x}, {v}.x) + product({y}, {v}.y)) + product({z}, {v}.z)) + product({w}, {v}.w)")
    }

    /// A struct of vec4 members.
    pub fn structure(name: &str, members: impl IntoIterator<Item = String>) -> String {
        let mut s = format!("struct {name} {{\n");
        for m in members {
            let _ = writeln!(s, "    {m},");
        }
        s.push_str("}\n");
        s
    }
}
