#!/usr/bin/env bash
# Every test but the matrix with AddressSanitizer and UndefinedBehaviorSanitizer: a quarter of them, the others with the
# next three commits; of the studies of numbers those that end soon. All of it with --all. The matrix is no news here: it runs
# the programs that the rest tests, and workers that have no sanitizers. Long studies (convergence, peers, whole hard
# cases) are not built, see MUELLE_ASAN in the CMake files: of the hard cases the first steps of every method run, of the
# figures the numbers. A bare root has no sanitizer's library, and its shadow memory does not fit below a limit of memory
# (app.run_command).
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
begin "tests with sanitizers"
cmake --preset asan >/dev/null
ninja -C build-asan --quiet
# A sanitised program takes up to twenty times as long as one at -O2, on a busy machine longer.
if [[ $share == all ]]; then
  ctest --test-dir build-asan --output-on-failure --no-tests=error --parallel $jobs --timeout 3000 \
    --label-exclude '^grade$' --exclude-regex '^(matrix[.]|TwoAtOnce|style[.]|Portable|app[.](output|run_command)|sandbox[.]bare_root)'
else
  quarter=$(($(git rev-list --count HEAD) % 4 + 1))
  ctest --preset asan --timeout 1500 --parallel $((jobs + 1)) --tests-information $quarter,,4
fi
