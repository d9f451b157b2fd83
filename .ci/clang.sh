#!/usr/bin/env bash
# Everything that a student's machine compiles, through clang: a syntax pass with the project's warnings.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
begin "what a student's machine compiles, through clang, syntax only"
plain_tree
flags=(-std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
       -Iframework -Ibuild-plain/generated -isystem "$(eigen_folder)" -DGTEST_HAS_PTHREAD=1)

# One source a line, with what it is compiled with besides; blanks part the words.
jobs_of() {
  handed_out_rooms
  local folder topic role='-DMUELLE_FUNCTIONS_HEADER="course/testing/'
  for folder in exercises/*/; do
    topic="$(basename "$folder")"
    echo "$folder$topic.cpp -I$folder"
    if [[ -f "solutions/$topic/$topic.cpp" ]]; then echo "solutions/$topic/$topic.cpp -I$folder"; fi
    echo "${folder}public_test.cpp -I$folder ${role}direct_functions.h\" -DMUELLE_EXERCISE_FOLDER=\"$folder\""
    echo "${folder}demo.cpp -I$folder ${role}demo_functions.h\" -DMUELLE_EXERCISE_FOLDER=\"$folder\""
  done
}

jobs_of | tr '\n' '\0' | xargs -0 -r -P "$jobs" -n 1 bash -c '
  read -ra words <<<"${!#}"
  clang++ "${@:1:$#-1}" "${words[@]}" || { echo "clang.sh: ${words[0]} does not compile with clang" >&2; exit 1; }
' _ "${flags[@]}"
