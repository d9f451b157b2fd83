#!/usr/bin/env bash
# Usage: command_line_test.sh MUELLE EXERCISES. Every wrong command line ends with 2 and one line that starts with
# "muelle: ". EXERCISES is the course's folder; any of its exercises would do.
set -uo pipefail
muelle="$1"
manifests=("$2"/*/exercise.toml)
topic="$(basename "$(dirname "${manifests[0]}")")"
failures=0

# expect CODE TEXT ARGUMENTS...: exit code, and a text that must stand in what is printed.
expect() {
  local code="$1" text="$2" printed status
  shift 2
  printed="$("$muelle" "$@" 2>&1 </dev/null)"
  status=$?
  if [[ $status -ne $code || $printed != *"$text"* ]]; then
    printf 'muelle %s: exit code %s (expected %s), printed:\n%s\n(expected in it: %s)\n' "$*" "$status" "$code" \
      "$printed" "$text" >&2
    failures=$((failures + 1))
  fi
  if [[ $code -eq 2 && ($printed != muelle:* || $printed == *$'\n'*) ]]; then
    printf 'muelle %s: an error is one line that begins with "muelle: ", got:\n%s\n' "$*" "$printed" >&2
    failures=$((failures + 1))
  fi
  if [[ $printed == *$'\e'* ]]; then
    printf 'muelle %s: escape sequences without a terminal\n' "$*" >&2
    failures=$((failures + 1))
  fi
}

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
