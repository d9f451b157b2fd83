#!/usr/bin/env bash
# Usage: advise_command_test.sh MUELLE_ADVISE MUELLE_RUN. The command line of `muelle advise`: exit codes, one-line
# errors, what it writes, and that what it has written runs.
set -uo pipefail
program="$1" runner="$2" word=advise
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
. "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

complain() {
  echo "$1" >&2
  failures=$((failures + 1))
}

expect 0 "Examples:" --help
expect 0 "advice      " oscillator --tolerance 1e-3 --budget 5
expect 0 "cost        " elastic_pendulum --tolerance 1e-4 --budget 5
expect 0 "needs a force that does not depend on the velocity" hanging_chain --tolerance 1e-2 --budget 5
expect 1 "muelle: jelly_box: no statement at 0.01: friction sticks and slips between steps" jelly_box --tolerance 1e-2
expect 1 "give a larger --budget than 0.01 s" damping_dominated_cloth --tolerance 1e-4 --budget 0.01
[[ ! -e out ]] || complain "muelle advise wrote without --plot or --out"

expect 0 "applied     $folder/a.toml" dumbbell --tolerance 1e-3 --budget 5 --apply "$folder/a.toml" --out "$folder/out"
expect 0 "in place of what was there" dumbbell --tolerance 1e-3 --budget 5 --apply "$folder/a.toml"
[[ -s "$folder/out/advice.svg" ]] || complain "muelle advise did not draw"
"$runner" "$folder/a.toml" >"$folder/ran" || complain "what muelle advise wrote does not run"
grep -q "of the motion: positions" "$folder/ran" || complain "no error of what muelle advise wrote: $(cat "$folder/ran")"

expect 2 "SCENE is missing" --tolerance 1e-3
expect 2 "--tolerance is missing" oscillator
for tolerance in 0 -1 2 nan; do expect 2 "--tolerance is" oscillator --tolerance "$tolerance"; done
expect 2 "--tolerance" oscillator --tolerance small
for budget in 0 -1 nan inf; do expect 2 "--budget is" oscillator --tolerance 1e-3 --budget "$budget"; done
expect 2 "no scene file" "$folder/none.toml" --tolerance 1e-3
expect 2 "did you mean 'oscillator'?" oscilator --tolerance 1e-3
expect 2 "--tolerence" oscillator --tolerence 1e-3
expect 2 "ends in .toml" oscillator --tolerance 1e-3 --apply "$folder/a.txt"
expect 2 "no such folder" oscillator --tolerance 1e-3 --apply "$folder/none/a.toml"
cp "$folder/a.toml" "$folder/b.toml"
expect 2 "is the scene itself" "$folder/b.toml" --tolerance 1e-2 --apply "$folder/b.toml"
cmp -s "$folder/a.toml" "$folder/b.toml" || complain "the scene was written over"
exit $((failures > 0))
