#!/usr/bin/env bash
# Tests with AddressSanitizer and UndefinedBehaviorSanitizer: of an eleventh of the house, the other parts with the
# next ten commits; of the studies of numbers those that end soon. All of it with --all. Of the exercises two are built, the
# first and one that changes: the programs of each take a minute and a half of processor time to compile. The matrix is
# no news here: it runs the programs that the rest tests, and workers that have no sanitizers. Long studies (convergence,
# peers, whole hard cases) are not built, see MUELLE_ASAN in the CMake files: of the hard cases the first steps of every
# method run, of the figures the numbers; the sweeps over tolerances, a quarter of an hour, with --all alone. A bare root
# has no sanitizer's library, and its shadow memory does not fit below a limit of memory (app.run_command).
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# Rooms, what their tests start besides, and which tests, by the number of the commit.
number=$(git rev-list --count HEAD)
parts="" which=()
grading="framework/app/all muelle_grading muelle_checking"
case $((number % 11)) in
  0) rooms="engine" ;;
  1) rooms="grader" parts="$grading" which=(--label-exclude '^grade$|faults|hostile|parity') ;;
  2) rooms="repository base course" parts="$grading" ;;
  3) rooms="grader" parts="$grading" which=(--label-regex 'faults') ;;
  4) rooms="hard_cases app" parts="$grading" ;;
  5) rooms="grader" parts="$grading" which=(--label-regex 'parity') ;;
  6) rooms="harness figures" ;;
  7) rooms="grader" parts="$grading" which=(--label-regex 'hostile') ;;
  8) rooms="lab" which=(--tests-regex '^lab[.]run[.]ErrorStudy') ;;
  9) rooms="lab" which=(--exclude-regex '^lab[.]run[.](ErrorStudy|Adaptive/Sweep)') ;;
  10) rooms="plots" parts="muelle-figures" ;;
esac
topics=(exercises/*/)
turn=$((number / 11 % ${#topics[@]}))
source tests/support/first_exercise.sh
built="$(first_exercise .);$(basename "${topics[turn]}")"

# A sanitised program takes up to twenty times as long as one at -O2, on a busy machine longer.
if [[ $share == all ]]; then
  begin "tests with sanitizers"
  cmake --preset asan -U MUELLE_TEST_ROOMS -U MUELLE_TOPICS >/dev/null
  ninja -C build-asan --quiet
  never='^(matrix[.]|TwoAtOnce|style[.]|Portable|app[.](output|run_command)|sandbox[.]bare_root)'
  ctest --test-dir build-asan --output-on-failure --no-tests=error --parallel $jobs --timeout 3000 \
    --label-exclude '^grade$' --exclude-regex "$never"
else
  begin "tests with sanitizers: $rooms ${which[*]:-}, exercises $built"
  cmake --preset asan -DMUELLE_TEST_ROOMS="${rooms// /;}" -DMUELLE_TOPICS="$built" >/dev/null
  # shellcheck disable=SC2086
  ninja -C build-asan --quiet tests/all $parts
  ctest --preset asan --timeout 1500 --parallel $((jobs + 1)) ${which[@]+"${which[@]}"}
fi
