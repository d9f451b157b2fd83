#!/usr/bin/env bash
# Usage: command_line_test.sh MUELLE EXERCISES. Every wrong command line ends with 2 and one line that starts with
# "muelle: ". EXERCISES is the course's folder; any of its exercises would do.
set -uo pipefail
program="$1" word=
manifests=("$2"/*/exercise.toml)
topic="$(basename "$(dirname "${manifests[0]}")")"
. "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

expect 0 "./muelle check"
expect 0 "Example:" check --help
expect 0 "Example:" list --help
expect 0 "Example:" test --help
expect 0 "Example:" docs --help
expect 0 "$topic" list
expect 2 "did you mean 'check'?" chek
expect 2 "there are check" xyzzy
expect 2 "did you mean '$topic'?" check "${topic:0:2}${topic:3}"
expect 2 "--fiel" check --fiel x
expect 2 "no file" check --file "/nonexistent/$topic.cpp"
expect 2 '\x1b[31m' $'\e[31m'
exit $((failures > 0))
