//! Fixed function as a generator of programs.
