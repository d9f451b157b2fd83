#!/usr/bin/env bash
# What grading costs against what the compiler alone takes for the same files:
#   grade six exercises, nothing kept, curves included   wall <= 0.8 x compiling them bare (no precompiled header)
#   check of one exercise, from save to verdict          wall <= 1.5 x the bare compile of that file
#   grade again, unchanged                               wall <  1 s
#   a class of 60 different hand-ins, curves included    CPU  <= 1.3 x compiling and linking them with precompiled header
# Each pair is timed in turn with the same number of jobs, so that a change of the machine's speed meets both.
#
# Usage: tests/benchmarks/grading_time.sh [ROUNDS [STUDENTS]]     5 rounds, 60 students; after ./muelle grade solutions
set -euo pipefail

root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$root"
rounds=${1:-5}
students=${2:-60}
muelle=build/bin/muelle
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

flags=$(sed -n 's/.*studentFlags = "\(.*\)";.*/\1/p' build/generated/base/build_paths.h)
compiler=$(sed -n 's/.*compiler = "\(.*\)";.*/\1/p' build/generated/base/build_paths.h)
linker=$(sed -n 's/.*linkerFlag = "\(.*\)";.*/\1/p' build/generated/base/build_paths.h)
eigen=$(sed -n 's/.*eigen = "\(.*\)";.*/\1/p' build/generated/base/build_paths.h)

compile() { # TOPIC: as anyone would, with the whole of Eigen/Core read again
  # shellcheck disable=SC2086
  "$compiler" $flags -Iframework -isystem "$eigen" "-Iexercises/$1" -c "solutions/$1/$1.cpp" -o "$work/$1.o"
}
compile_all() {
  export -f compile
  export compiler flags eigen work
  ls solutions | xargs -P 2 -I{} bash -c 'compile {}'
}
grade_fresh() {
  rm -rf "$work/kept"
  grade_again
}
grade_again() { MUELLE_KEPT="$work/kept" "$muelle" grade solutions --jobs 2 --out "$work/report" >"$work/graded"; }
source tests/support/first_exercise.sh
one="$(first_exercise .)"
check_one() { # touches the file's content, so that nothing kept applies
  cp "solutions/$one/$one.cpp" "$work/$one.cpp"
  echo "// $RANDOM$RANDOM" >>"$work/$one.cpp"
  "$muelle" check --file "$work/$one.cpp" --no-plot >"$work/checked"
}
compile_one() { compile "$one"; }

seconds() { # COMMAND: wall time
  local start=$EPOCHREALTIME
  "$@"
  local end=$EPOCHREALTIME
  echo "$start $end" | awk '{printf "%.3f\n", $2 - $1}'
}
median() { sort -n | awk '{a[NR] = $1} END {print (NR % 2) ? a[(NR + 1) / 2] : (a[NR / 2] + a[NR / 2 + 1]) / 2}'; }

pair() { # NAME A B: A against B, in turn
  : >"$work/a"; : >"$work/b"; : >"$work/ratio"
  for ((i = 0; i < rounds; ++i)); do
    local a b
    a=$(seconds "$2"); b=$(seconds "$3")
    echo "$a" >>"$work/a"; echo "$b" >>"$work/b"
    echo "$a $b" | awk '{printf "%.3f\n", $1 / $2}' >>"$work/ratio"
  done
  printf '%-44s %7.2f s   against %7.2f s   ratio %5.2f (bar %s)\n' "$1" "$(median <"$work/a")" "$(median <"$work/b")" \
    "$(median <"$work/ratio")" "$4"
}

# A class: the solutions and the submissions of the corpus, each with a line of its own.
make_class() {
  local i topic folders
  for ((i = 1; i <= students; ++i)); do
    for topic in $(ls solutions); do
      folders=("solutions/$topic/" "tests/submissions/$topic"/*/*/)
      mkdir -p "$work/class/student_$i/$topic"
      cp "${folders[i % ${#folders[@]}]}$topic.cpp" "$work/class/student_$i/$topic/"
      echo "// student $i" >>"$work/class/student_$i/$topic/$topic.cpp"
    done
  done
}
compile_and_link() { # FILE: with the precompiled header, as the grader's own command
  local topic object
  topic=$(basename "$1" .cpp)
  object="$work/object_$$_$RANDOM"
  # shellcheck disable=SC2086
  "$compiler" $flags -Ibuild/prelude -include prelude.h -Iframework -isystem "$eigen" "-Iexercises/$topic" -c "$1" \
    -o "$object.o" 2>/dev/null || return 0
  # shellcheck disable=SC2086
  "$compiler" $linker -shared "$object.o" -o "$object.so"
  rm -f "$object.o" "$object.so"
}
compile_class() {
  export -f compile_and_link
  export linker
  find "$work/class" -name '*.cpp' | xargs -P 2 -I{} bash -c 'compile_and_link {}'
}
grade_class() {
  MUELLE_KEPT="$work/class_kept" "$muelle" grade --class "$work/class" --jobs 2 --out "$work/class_out" >"$work/graded" ||
    test $? -eq 1
}
cpu_seconds() { # COMMAND: user and system time of it and of all that it starts
  local TIMEFORMAT='%U %S'
  { time "$@" 2>"$work/words"; } 2>&1 | awk '{print $1 + $2}'
}

compile_all # the files are read once before anything is timed
pair "grade six exercises / compile them bare" grade_fresh compile_all 0.8
pair "check one exercise / compile it bare" check_one compile_one 1.5
grade_again
for ((i = 0; i < rounds; ++i)); do seconds grade_again; done | median |
  awk '{printf "%-44s %7.2f s   (bar 1 s)\n", "grade again, unchanged", $1}'
make_class
compiled=$(cpu_seconds compile_class)
graded=$(cpu_seconds grade_class)
echo "$graded $compiled" | awk -v n="$students" '{
  printf "%-44s %7.1f s   against %7.1f s   ratio %5.2f (bar 1.3), CPU\n", "a class of " n " / compile and link it", $1, $2, $1 / $2}'
