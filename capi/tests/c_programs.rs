//! C programs against the library: each checks its own statements and names those that do not hold.

mod support;

use support::run;

#[test]
fn every_format_and_type_lies_in_memory_as_osmesa_says() {
    run("formats", &[]);
}

#[test]
fn the_programs_memory_is_written_when_mesa_writes_it() {
    run("binding", &[]);
}

#[test]
fn contexts_have_the_bits_they_were_asked_for_and_answer_queries() {
    run("contexts", &[]);
}

#[test]
fn each_thread_has_its_own_current_context() {
    run("threads", &["-pthread"]);
}

#[test]
fn contexts_share_lists_and_textures_with_their_group_only() {
    run("sharing", &[]);
}

#[test]
fn arguments_are_converted_and_checked() {
    run("arguments", &[]);
}

#[test]
fn another_gl_in_the_process_is_never_called() {
    run("interposed", &["-rdynamic"]);
}

#[test]
fn a_program_may_load_and_unload_the_library() {
    run("unload", &["-Wl,--as-needed", "-ldl"]);
}

#[test]
fn floating_point_depths_come_back_as_they_are() {
    run("float_depth", &["-lm"]);
}

#[test]
fn a_window_with_samples_is_resolved_for_its_program() {
    run("multisample", &[]);
}
