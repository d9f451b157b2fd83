#!/usr/bin/env bash
# Tests with AddressSanitizer and UndefinedBehaviorSanitizer: of a quarter of the house, the other rooms with the next
# three commits; of the studies of numbers those that end soon. All of it with --all. The matrix is no news here: it runs
# the programs that the rest tests, and workers that have no sanitizers. Long studies (convergence, peers, whole hard
# cases) are not built, see MUELLE_ASAN in the CMake files: of the hard cases the first steps of every method run, of the
# figures the numbers. A bare root has no sanitizer's library, and its shadow memory does not fit below a limit of memory
# (app.run_command).
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# Rooms, and what their tests start besides, by the number of the commit.
quarter=$(($(git rev-list --count HEAD) % 4))
case $quarter in
  0) rooms="engine" parts="" ;;
  1) rooms="harness figures lab plots hard_cases" parts="muelle-figures" ;;
  2) rooms="grader" parts="framework/app/all muelle_grading muelle_checking" ;;
  3) rooms="repository base course app" parts="framework/app/all muelle_grading muelle_checking" ;;
esac

# A sanitised program takes up to twenty times as long as one at -O2, on a busy machine longer.
if [[ $share == all ]]; then
  begin "tests with sanitizers"
  cmake --preset asan -U MUELLE_TEST_ROOMS >/dev/null
  ninja -C build-asan --quiet
  never='^(matrix[.]|TwoAtOnce|style[.]|Portable|app[.](output|run_command)|sandbox[.]bare_root)'
  ctest --test-dir build-asan --output-on-failure --no-tests=error --parallel $jobs --timeout 3000 \
    --label-exclude '^grade$' --exclude-regex "$never"
else
  begin "tests with sanitizers of $rooms"
  cmake --preset asan -DMUELLE_TEST_ROOMS="${rooms// /;}" >/dev/null
  # shellcheck disable=SC2086
  ninja -C build-asan --quiet tests/all $parts
  ctest --preset asan --timeout 1500 --parallel $((jobs + 1))
fi
