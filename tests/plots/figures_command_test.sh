#!/usr/bin/env bash
# Usage: figures_command_test.sh MUELLE_FIGURES REPOSITORY. The command line of `muelle figures`, and that each file of
# plots/figures is a figure with a line in the documentation.
set -uo pipefail
figures="$1"
repository="$2"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
failures=0

fail() {
  printf '%s\n' "$@" >&2
  failures=$((failures + 1))
}

# expect CODE TEXT ARGUMENTS...: exit code, and a text that must stand in what is printed.
expect() {
  local code="$1" text="$2" printed status
  shift 2
  printed="$("$figures" "$@" 2>&1 </dev/null)"
  status=$?
  if [[ $status -ne $code || $printed != *"$text"* ]]; then
    fail "muelle figures $*: exit code $status (expected $code), printed:" "$printed" "(expected in it: $text)"
  fi
  if [[ $code -eq 2 && ($printed != muelle:* || $printed == *$'\n'*) ]]; then
    fail "muelle figures $*: an error is one line that begins with 'muelle: ', got:" "$printed"
  fi
}

expect 0 "Examples:" --help
expect 2 "did you mean 'stability_limit'?" stability_limits --out "$folder/none"
expect 2 "no figure '../x'" ../x --out "$folder/none"
expect 2 "--format" hookes_law_1d --format gif --out "$folder/none"
expect 2 "--nonsense" --nonsense
[[ ! -e "$folder/none" ]] || fail "muelle figures wrote in spite of an error"

expect 0 "2 figures in" hookes_law_1d oscillator_by_method --out "$folder/drawn"
for name in hookes_law_1d oscillator_by_method; do
  for ending in dat gp svg pdf png; do
    [[ -s "$folder/drawn/$name.$ending" ]] || fail "muelle figures did not write $name.$ending"
  done
done
[[ "$(find "$folder/drawn" -type f | wc -l)" -eq 10 ]] || fail "muelle figures wrote more: $(ls "$folder/drawn")"
expect 0 "1 figure in" hookes_law_1d --format png --out "$folder/png"
[[ ! -e "$folder/png/hookes_law_1d.svg" ]] || fail "muelle figures drew a format that was not asked for"

# The list, the sources and the page name the same figures.
listed="$("$figures" --list)"
sources="$(cd "$repository/plots/figures" && printf '%s\n' *.cpp | sed 's/\.cpp$//' | sort)"
documented="$(sed -n 's/^| `\([a-z0-9_]*\)` |.*/\1/p' "$repository/docs/figures.md" | sort)"
[[ "$(sort <<<"$listed")" == "$sources" ]] ||
  fail "muelle figures --list and plots/figures differ:" "$(diff <(sort <<<"$listed") <(echo "$sources"))"
[[ "$documented" == "$sources" ]] ||
  fail "docs/figures.md and plots/figures differ:" "$(diff <(echo "$documented") <(echo "$sources"))"
exit $((failures > 0))
