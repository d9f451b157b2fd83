#!/usr/bin/env bash
# Usage: rest_command_test.sh MUELLE_REST. The command line of `muelle rest`: verdicts, exit codes, one-line errors, what
# it writes.
set -uo pipefail
program="$1" word=rest
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
. "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

# scene NAME GRAVITY X_OF_THE_BOB PINNED: a pendulum of length 1 m and 1 kg, its bob at (0, X).
scene() {
  printf 'title = "t"\nshows = "t"\nslide = "t"\ndimension = 2\ngravity = %s\n%s\n' "$2" \
    "[[node]]
x = [0.0, 0.0]
m = 1.0
pinned = $4
[[node]]
x = [0.0, $3]
m = 1.0
[[spring]]
nodes = [0, 1]
k = 100.0
L0 = 1.0
[run]
method = \"velocity_verlet\"
step = 0.01
duration = 1.0" >"$folder/$1.toml"
}

scene up 9.81 1.0 true
scene down 9.81 -1.0 true
scene cusp 9.81 0.0 true
scene falling 9.81 -1.0 false
scene floating 0.0 -1.2 false

expect 0 "Examples:" --help
expect 0 "verdict     stable: every small displacement costs energy; no spring pushes" hanging_chain
expect 0 "tensions    10.7362 N, the largest: spring " hanging_chain
expect 0 "verdict     saddle" "$folder/up.toml"
expect 0 "--leave-saddles goes on downhill" "$folder/up.toml"
expect 0 "a saddle was left on the way" "$folder/up.toml" --leave-saddles
expect 0 "tensions    9.81 N, spring 0, between nodes 0 and 1" "$folder/down.toml"
expect 0 "verdict     neutral" "$folder/floating.toml"
expect 1 "nodes 0 and 1 lie in one place, and spring 0 between them is 1 m long" "$folder/cusp.toml"
expect 1 "muelle: cusp: no equilibrium: cusp" "$folder/cusp.toml"
expect 1 "nodes 0, 1 are tied to nothing that holds, and carry loads of 19.62 N in all" "$folder/falling.toml"
expect 0 "what changes with time is taken as it is at 0.25 s" whip --at 0.25
expect 0 "stable" column_at_rest --out "$folder/none"
[[ ! -e "$folder/none" ]] || { echo "muelle rest wrote without --plot or --csv" >&2; failures=$((failures + 1)); }
expect 0 "rest.svg" hanging_chain --plot --csv --out "$folder/out"
for file in rest.svg hanging_chain_nodes.csv hanging_chain_springs.csv; do
  [[ -s "$folder/out/$file" ]] || { echo "muelle rest did not write $file" >&2; failures=$((failures + 1)); }
done
[[ $(wc -l <"$folder/out/hanging_chain_springs.csv") -eq 21 ]] || { echo "a line for each spring and a head" >&2; failures=$((failures + 1)); }
expect 2 "SCENE is missing"
expect 2 "did you mean 'hanging_chain'?" hanging_chian
expect 2 "--at is -1 s" whip --at -1
expect 2 "--plott" whip --plott
exit $((failures > 0))
