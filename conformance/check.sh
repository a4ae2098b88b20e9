#!/usr/bin/env bash
# The whole proof: unit tests, C tests, scenes, the stiff suite and error against run time, on the CPU executor and on the
# kernels. The last line sums everything up.
set -u
cd "$(dirname "$0")/.."
export VK_DRIVER_FILES="${VK_DRIVER_FILES:-$(ls /usr/share/vulkan/icd.d/lvp_icd.*.json 2>/dev/null | head -n 1)}"
log=target/check.log
mkdir -p target
: > "$log"

cargo test --release --workspace --no-fail-fast -- --format pretty 2>&1 | tee -a "$log"
status=${PIPESTATUS[0]}
# On a software Vulkan driver the host would set triangles up; here the kernels do, from the vertices on.
TEPUI_GPU_FRONT=kernels cargo run --release --quiet -p tepui-conformance -- compare --device both --frames 1 2>&1 | tee -a "$log"
cargo run --release --quiet -p tepui-conformance -- stiff 2>&1 | tee -a "$log"
cargo run --release --quiet -p tepui-conformance -- precision 2>&1 | tee -a "$log"

# "test result: ok. 12 passed; 0 failed; ..." of every test binary, "conformance: 240 passed, 0 failed", and the same of "stiff:" and "precision:".
awk -v status="$status" '
    /^test result: / { for (i = 1; i < NF; i++) { if ($(i + 1) ~ /^passed/) passed += $i; if ($(i + 1) ~ /^failed/) failed += $i } tests = 1 }
    /^conformance: /  { passed += $2; failed += $4; compared = 1 }
    /^stiff: /        { passed += $2; failed += $4; judged = 1 }
    /^precision: /    { passed += $2; failed += $4; measured = 1 }
    END {
        # A test binary that did not build has no line of its own.
        if (!tests || !compared || !judged || !measured || (status != 0 && failed == 0)) failed += 1
        printf "%d passed, %d failed\n", passed, failed
        exit failed > 0
    }' "$log"
