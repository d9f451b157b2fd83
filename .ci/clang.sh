#!/usr/bin/env bash
# Everything that a student's machine compiles, through clang: a syntax pass with the project's warnings.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
command -v clang++ >/dev/null || { echo "clang.sh: clang++ is missing: apt-get install clang" >&2; exit 2; }
[[ -f build/generated/base/build_paths.h ]] || { echo "clang.sh: no build folder; run ./muelle list first" >&2; exit 2; }

# Our own flags, and Eigen where CMake found it.
eigen="$(sed -n 's/^Eigen3_DIR:PATH=//p' build/CMakeCache.txt)"
include="$(cd "$eigen/../../../include/eigen3" 2>/dev/null && pwd || echo /usr/include/eigen3)"
flags=(-std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
       -Iframework -Ibuild/generated -isystem "$include" -DGTEST_HAS_PTHREAD=1)

# One source with what it is compiled with besides; blanks part the words of a line.
jobs_of() {
  find framework/base framework/harness framework/figures framework/course framework/app \
    -path framework/app/instructor -prune -o -name '*.cpp' -print
  local folder topic
  for folder in exercises/*/; do
    topic="$(basename "$folder")"
    echo "$folder$topic.cpp -I$folder"
    if [[ -f "solutions/$topic/$topic.cpp" ]]; then echo "solutions/$topic/$topic.cpp -I$folder"; fi
    echo "${folder}public_test.cpp -I$folder -DMUELLE_FUNCTIONS_HEADER=\"course/testing/direct_functions.h\""
    echo "${folder}demo.cpp -I$folder -DMUELLE_FUNCTIONS_HEADER=\"course/testing/direct_functions.h\""
  done
}

jobs_of | tr '"' '\001' | xargs -P 2 -I '{}' bash -c '
  line="$(tr "\001" "\"" <<<"$1")"; shift
  read -ra words <<<"$line"
  clang++ "$@" "${words[@]}" || { echo "clang.sh: ${words[0]} does not compile with clang" >&2; exit 255; }
' _ '{}' "${flags[@]}"
