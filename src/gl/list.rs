//! Display lists (5.4).

use super::Context;

/// A recorded command.
type Command = Box<dyn Fn(&mut Context) + Send + Sync>;

/// A finished display list: its commands, in order.
#[derive(Default)]
pub struct List {
    pub(crate) commands: Vec<Command>,
}

/// The list under construction.
pub(crate) struct Builder {
    pub name: u32,
    /// GL_COMPILE_AND_EXECUTE
    pub execute: bool,
    pub list: List,
}

/// What a context knows about lists.
#[derive(Default)]
pub(crate) struct ListState {
    pub builder: Option<Builder>,
}

impl Context {
    /// Records a command into the display list under construction, if there is one. True: the command is dealt with (compiled,
    /// and executed too in GL_COMPILE_AND_EXECUTE mode), the caller returns.
    #[inline]
    pub(crate) fn compile(&mut self, command: impl Fn(&mut Context) + Send + Sync + 'static) -> bool {
        if self.lists.builder.is_none() {
            return false;
        }
        self.compile_boxed(Box::new(command));
        true
    }

    #[cold]
    fn compile_boxed(&mut self, command: Command) {
        // While the command runs there is no builder, so that what it calls is not compiled a second time.
        let Some(mut builder) = self.lists.builder.take() else { return };
        if builder.execute {
            command(self);
        }
        builder.list.commands.push(command);
        self.lists.builder = Some(builder);
    }
}
