#!/usr/bin/env bash
# Usage: unfinished_exercise_test.sh SOURCE MUELLE. A student's tree in which an exercise lacks a file: CMake leaves it
# out and says so in a file, `muelle` reads that, and the exercise is found as soon as it is complete.
set -uo pipefail
source="$1"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
tree="$scratch/a b'c é"
mkdir -p "$tree/framework"
cp "$source"/CMake* "$tree"
for room in app base cmake course figures harness; do cp -R "$source/framework/$room" "$tree/framework"; done
cp -R "$source/exercises" "$tree"
source "$source/tests/support/first_exercise.sh"
first="$(first_exercise "$source")"
failures=0
complain() {
  printf '%s\n' "$@" >&2
  failures=$((failures + 1))
}

# expect TEXT: what the build says is left out, after CMake has had its chance to look again.
expect() {
  local said
  ninja -C "$tree/build" build.ninja >"$scratch/log" 2>&1 || complain "ninja: $(cat "$scratch/log")"
  said="$(cat "$tree/build/unfinished_exercises.txt")"
  [[ $said == "$1" ]] || complain "left out: '$said', expected: '$1'"
}
has_target() { ninja -C "$tree/build" -t targets all | grep "CMakeFiles/$1[.]dir/.*[.]o:" >/dev/null; }

mv "$tree/exercises/$first/demo.cpp" "$scratch"
mkdir "$tree/exercises/wheel"
printf '#include "harness/exercise.h"\n' >"$tree/exercises/wheel/wheel.h"
cmake -S "$tree" --preset default >"$scratch/log" 2>&1 || complain "cmake: $(tail -5 "$scratch/log")"
lacks_all="wheel: exercises/wheel/exercise.toml, exercises/wheel/wheel.cpp, exercises/wheel/public_test.cpp"
lacks_all+=", exercises/wheel/demo.cpp"
expect "$first: exercises/$first/demo.cpp
$lacks_all"
has_target public_test_$first && complain "an exercise without demo is built"
# The launcher asks for what it has built before: nothing is to be done then, and no target is unknown.
ninja -C "$tree/build" -n public_$first >"$scratch/log" 2>&1 || complain "public_$first is unknown: $(cat "$scratch/log")"

mv "$scratch/demo.cpp" "$tree/exercises/$first"
expect "$lacks_all"
has_target public_test_$first || complain "the exercise is complete and not found"

for file in exercise.toml public_test.cpp demo.cpp; do cp "$tree/exercises/$first/$file" "$tree/exercises/wheel"; done
cp "$tree/exercises/$first/$first.cpp" "$tree/exercises/wheel/wheel.cpp"
expect ""
has_target public_test_wheel || complain "the new exercise is complete and not found"

rm "$tree/exercises/wheel/public_test.cpp"
expect "wheel: exercises/wheel/public_test.cpp"
exit $((failures > 0))
