#!/usr/bin/env bash
# Usage: run_command_test.sh MUELLE_RUN. The command line of `muelle run`: exit codes, one-line errors, what it writes.
set -uo pipefail
program="$1" word=run
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
. "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

expect 0 "Examples:" --help
expect 0 "rabbit_squeezed" --list
expect 0 "velocity_verlet" --methods
expect 0 "step halved, order 2" oscillator --out "$folder/summary"
[[ ! -e "$folder/summary" ]] || { echo "muelle run wrote without --plot or --csv" >&2; failures=$((failures + 1)); }
expect 0 "symplectic Euler" oscillator --method symplectic-euler --step 0.001 --duration 1
expect 0 "not estimated" oscillator --no-error-estimate
expect 0 "oscillator_energy.svg" oscillator --plot --csv --out "$folder/figures"
for file in oscillator_energy.svg oscillator_outputs.svg oscillator_shape.svg oscillator.csv; do
  [[ -s "$folder/figures/$file" ]] || { echo "muelle run did not write $file" >&2; failures=$((failures + 1)); }
done
heads="$(head -n 1 "$folder/figures/oscillator.csv")"
[[ $heads == "t [s],node 0 x [m],node 1 x [m],node 0 vx [m/s],node 1 vx [m/s],"* ]] \
  || { echo "oscillator.csv has the heads $heads" >&2; failures=$((failures + 1)); }
expect 1 "muelle: oscillator:" oscillator --method explicit_euler --step 0.5 --duration 100
expect 2 "SCENE is missing"
expect 2 "did you mean 'oscillator'?" oscilator
expect 2 "no scene file" missing/scene.toml
expect 2 "did you mean 'dop853'?" oscillator --method dop85
expect 2 "no method 'rk4'; here it is 'runge_kutta_4'" oscillator --method rk4
expect 0 "2 nodes, 1 spring, 1 unknown" oscillator --no-error-estimate
expect 0 "parts       spring: 1 element, " oscillator --no-error-estimate --parts
expect 2 "there is no part 'sprng'; did you mean 'spring'?" oscillator --without sprng
expect 0 "100 nodes, 180 springs" corner_hung_cloth --duration 0.001 --no-error-estimate --without cloth.shear gravity
expect 2 "--step is 0 s" oscillator --step 0
expect 2 "--step is nan s" oscillator --step nan
expect 2 "has no error estimate" oscillator --tolerance 1e-6
expect 2 "--duraton" oscillator --duraton 3
expect 2 "--integrator is now --method ID" oscillator --integrator dop853
expect 2 "--dt is now --step SECONDS" oscillator --dt=0.1
expect 2 "--no-events is now --events off" oscillator --no-events
expect 0 "bouncing_ball" bouncing_ball --events off --duration 0.1
expect 2 "--events" bouncing_ball --events maybe
expect 2 "velocity" dumbbell --method nystrom8
printf 'title = "x"\nshows = "y"\nslide = "z"\n[[object]]\nkind = "grid"\nnodes = [300, 300]\nspacing = 1\nk = 1\nmass = 1\n[run]\nmethod = "velocity_verlet"\nstep = 1e-3\nduration = 1\n' >"$folder/large.toml"
# 1000 outputs of 90,000 nodes are 5 GiB, and the process may have 1.
(ulimit -v 1048576; expect 2 "5.36 GiB for 1,000 outputs" "$folder/large.toml"; exit "$failures") || failures=$((failures + 1))
printf 'title = "x"\ngravty = 3\n' >"$folder/bad.toml"
expect 2 "$folder/bad.toml:2: key 'gravty': unknown; did you mean 'gravity'?" "$folder/bad.toml"
exit $((failures > 0))
