#!/usr/bin/env bash
# Usage: output_test.sh BIN SOURCE. Output that cannot be written, for whatever reason, ends every command with one line
# and an exit code other than 0.
set -uo pipefail
bin="$1"
source="$2"
muelle="$bin/muelle"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
failures=0
export MUELLE_KEPT="$scratch/kept"  # `clean` must not forget what others have graded

source "$source/tests/support/first_exercise.sh"
topic="$(first_exercise "$source")"
answer="$source/solutions/$topic/$topic.cpp"
mkdir -p class/one/$topic
cp "$answer" class/one/$topic/

# A pipe whose reader has gone.
mkfifo pipe
exec 7<>pipe 8>pipe 7>&-

# expect_one_line STATUS WHAT WORDS...: what the command has ended with; its error stream stands in the file `err`.
expect_one_line() {
  local status="$1" what="$2"
  shift 2
  if [[ $status -ne 0 && $status -lt 126 && $(wc -l <err) -eq 1 && $(cat err) == muelle:\ * ]]; then return; fi
  printf 'muelle %s, %s: exit code %s, error stream:\n%s\n' "$*" "$what" "$status" "$(head -c 1000 err)" >&2
  failures=$((failures + 1))
}

try() {
  "$muelle" "$@" >/dev/full 2>err </dev/null
  expect_one_line $? "full disk" "$@"
  "$muelle" "$@" >&- 2>err </dev/null
  expect_one_line $? "closed stream" "$@"
  "$muelle" "$@" >&8 2>err </dev/null
  expect_one_line $? "closed pipe" "$@"
  # The error stream is no file here, or it could not be written either.
  { (ulimit -f 0 && exec "$muelle" "$@" >out) 2>&1 </dev/null; echo $? >status; } | cat >err
  expect_one_line "$(cat status)" "limit of file sizes" "$@"
}

try
try --help
try list
try list --help
try check --help
try test --list
try check "$topic" --file "$answer" --no-plot
if [[ -x "$bin/muelle-grade-step" ]]; then
  try grade "$source/solutions" --only "$topic" --sandbox unsafe
  try grade --class class --only "$topic" --sandbox unsafe
  try clean
  try test-the-tests --help
fi
if [[ -x "$bin/muelle-run" ]]; then
  try run --help
  try run --list
  try run oscillator --no-error-estimate
fi
if [[ -x "$bin/muelle-advise" ]]; then
  try advise --help
  try advise oscillator --tolerance 1e-2
fi
if [[ -x "$bin/muelle-rest" ]]; then
  try rest --help
  try rest hanging_chain
fi
if [[ -x "$bin/muelle-figures" ]]; then try figures --list; fi
if [[ -x "$bin/muelle-hard-cases" ]]; then try hard-cases --help; fi
if [[ -x "$bin/muelle-bench" ]]; then
  try bench --help
  try bench --list
fi

# Each closed stream has a stand-in: what is opened later must not get its number and be written to.
"$muelle" check "$topic" --file "$answer" --no-plot 0<&- 2>&- >out || {
  echo "check without input and error stream ends with $?" >&2
  failures=$((failures + 1))
}
exit $((failures > 0))
