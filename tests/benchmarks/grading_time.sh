#!/usr/bin/env bash
# How long grading one full submission takes, against compiling the same six files: the bars are
#   grade, from nothing built of it, curves included   <= 1.5 x the bare compile (no precompiled header, two jobs)
#   grade again, unchanged                             <  1 s
#   check of one exercise, from save to verdict        <= 1.5 x the bare compile of that file
# Each pair is timed in turn, so that a change of the machine's speed meets both; the medians are printed.
#
# Usage: tests/benchmarks/grading_time.sh [ROUNDS]     after a build (./muelle grade solutions)
set -euo pipefail

root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$root"
rounds=${1:-5}
muelle=build/bin/muelle
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

flags=$(sed -n 's/.*studentFlags = "\(.*\)";.*/\1/p' build/generated/harness/build_paths.h)
compiler=$(sed -n 's/.*compiler = "\(.*\)";.*/\1/p' build/generated/harness/build_paths.h)
eigen=$(sed -n 's/.*eigen = "\(.*\)";.*/\1/p' build/generated/harness/build_paths.h)

compile() { # TOPIC: as anyone would, with the whole of Eigen/Core read again
  # shellcheck disable=SC2086
  "$compiler" $flags -Iframework -isystem "$eigen" "-Iexercises/$1" -c "solutions/$1/$1.cpp" -o "$work/$1.o"
}
compile_all() {
  export -f compile
  export compiler flags eigen work
  ls solutions | xargs -P 2 -I{} bash -c 'compile {}'
}
grade_fresh() { "$muelle" grade solutions --fresh --jobs 2 --out "$work/report" >"$work/graded"; }
grade_again() { "$muelle" grade solutions --jobs 2 --out "$work/report" >"$work/graded"; }
check_one() { # touches the file's content, so that nothing kept applies
  cp solutions/spring_3d/spring_3d.cpp "$work/spring_3d.cpp"
  echo "// $RANDOM$RANDOM" >>"$work/spring_3d.cpp"
  "$muelle" check --file "$work/spring_3d.cpp" --no-plot >"$work/checked"
}
compile_one() { compile spring_3d; }

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

compile_all # the files are read once before anything is timed
pair "grade six exercises / compile them bare" grade_fresh compile_all 1.5
pair "check one exercise / compile it bare" check_one compile_one 1.5
grade_again
for ((i = 0; i < rounds; ++i)); do seconds grade_again; done | median |
  awk '{printf "%-44s %7.2f s   (bar 1 s)\n", "grade again, unchanged", $1}'
