# Sourced by every step: the root as working folder, two jobs, the compile database without precompiled header.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
jobs=2

# Which sources: --all, or a share that the step states.
share=recent
if [[ ${1:-} == --all ]]; then share=all; fi

# Prints a step's one line and, at its end, its time.
begin() {
  step="$(basename "$0" .sh)"
  began=$SECONDS
  printf '== %s: %s\n' "$step" "$1"
  trap 'finish $?' EXIT
}

finish() {
  local took=$((SECONDS - began)) word=passed
  if [[ $1 -ne 0 ]]; then word="FAILED (exit code $1)"; fi
  printf '== %s: %s in %d min %02d s\n' "$step" "$word" $((took / 60)) $((took % 60))
}

# Configures the tree without precompiled header (nothing is built there) and says where it is. clang and clang-tidy
# cannot read GCC's header, and neither may our code depend on what it includes.
plain_tree() {
  cmake --preset plain >build-plain.log 2>&1 || { cat build-plain.log >&2; exit 2; }
  rm -f build-plain.log
}

# Source files of the compile database, a line each, from the root.
database_sources() {
  sed -n 's/^  "file": "\(.*\)",\{0,1\}$/\1/p' build-plain/compile_commands.json | sed "s|^$PWD/||" | sort -u
}

# Sources of the rooms that everyone gets.
handed_out_rooms() {
  local rooms
  read -ra rooms <<<"$(sed -n 's/^set(MUELLE_HANDED_OUT_ROOMS \(.*\))$/\1/p' CMakeLists.txt)"
  find "${rooms[@]/#/framework/}" framework/app -path framework/app/instructor -prune -o -name '*.cpp' -print
}

# Of the sources whose names come in on stdin those that the last 30 commits touched, at most sixty, the latest first: a
# commit may touch everything, and a clone may know only one.
recent() {
  local names
  names="$(cat)"
  awk 'NR == FNR { wanted[$0]; next } ($0 in wanted) && !seen[$0]++ && count++ < 60' \
    <(printf '%s\n' "$names") <(git log -30 --format= --name-only)
}

# What clang-tidy reads: the sources of the framework, of these the recent ones unless --all. Tests are mostly
# GoogleTest's macros, which it takes for faults.
tidy_sources() {
  if [[ $share == all ]]; then
    database_sources | grep '^framework/'
  else
    database_sources | grep '^framework/' | recent
  fi
}

# The folder of Eigen that CMake found.
eigen_folder() {
  grep -o -m 1 -- '-isystem [^ ]*eigen3' build-plain/compile_commands.json | cut -d' ' -f2
}
