#!/usr/bin/env bash
# Usage: grade_command_test.sh MUELLE SOURCE. What `grade` does with its command line and with a machine that fails:
# nothing of another's is overwritten, no score of an earlier run stays, and exit code 1 tells a fault of the machine
# from bad usage (2).
set -uo pipefail
muelle="$(realpath "$1")" source="$(realpath "$2")"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
export MUELLE_KEPT="$scratch/kept"
failures=0

source "$source/tests/support/first_exercise.sh"
topic="$(first_exercise "$source")"
for student in ana ben; do
  mkdir -p "class/$student/$topic"
  cp "$source/solutions/$topic/$topic.cpp" "class/$student/$topic/"
  echo "// $student" >>"class/$student/$topic/$topic.cpp"
done

fail() {
  printf '%s\n' "$1" >&2
  failures=$((failures + 1))
}

# expect CODE TEXT ARGUMENTS...: exit code, and a text that must stand in what is printed.
expect() {
  local code="$1" text="$2" printed status
  shift 2
  printed="$("$muelle" grade "$@" 2>&1 </dev/null)"
  status=$?
  if [[ $status -ne $code || $printed != *"$text"* ]]; then
    fail "muelle grade $*: exit code $status (expected $code), printed:
$printed
(expected in it: $text)"
  fi
}

# The command line.
expect 0 "10 / 10" --only "$topic,$topic" class/ana --out twice
expect 2 "--only names no exercise" --only , class/ana --out twice
expect 2 "give one of the two" --only "$topic" class/ana --unsafe --sandbox bubblewrap
expect 2 "holds the reports of" --only "$topic" class/ben --out twice

# The class: real names, and no report among the hand-ins.
for out in class class/reports class/ana/out; do
  expect 2 "give a folder outside it" --only "$topic" --class class --out "$out"
done
expect 2 "give a folder outside it" --only "$topic" class/ana --out class/ana
expect 0 "ana" --only "$topic" --class class/ --out graded
grep -q '<h1>class</h1>' graded/class.html || fail "the page of class/ is not called by its name"

# Whoever has no score has no report that tells one.
cp "class/ana/$topic/$topic.cpp" .
mkdir class/cid && cp "class/ana/$topic/$topic.cpp" class/cid/
expect 0 "10 / 10" --only "$topic" "$topic.cpp" --out once
expect 0 "cid" --only "$topic" --class class --out graded
[[ -s once/results.json && -s graded/reports/cid/results.json ]] || fail "reports are missing"
rm -r "$topic.cpp" class/cid
printf 'PK\003\004 and nothing more' >class/cid
expect 1 "no score" --only "$topic" --class class --out graded
expect 2 "cannot read the submission" --only "$topic" "$topic.cpp" --out once
[[ ! -e once/results.json ]] || fail "a score stays of a hand-in that is gone"
[[ ! -e graded/reports/cid/results.json ]] || fail "a score stays of a row without one"
rm class/cid

# A link in the place of a report: nothing is written elsewhere, the others are graded.
mkdir elsewhere
mkdir -p linked/reports && ln -s "$scratch/elsewhere" linked/reports/ana
expect 1 "it is a link that leads out" --only "$topic" --class class --out linked
[[ -z $(ls -A elsewhere) ]] || fail "something was written through a link"
[[ -s linked/grades.csv && -s linked/reports/ben/results.json ]] || fail "one report stopped the others"

# A machine that fails: exit code 1, one line of what to do, and the table all the same.
touch file
MUELLE_KEPT="$scratch/file" expect 1 "name another with MUELLE_KEPT" --only "$topic" class/ana --out kept-in-a-file
rm -f kept/seed && ln -s /proc/self/mem kept/seed  # its reading fails
expect 1 "cannot keep the seed" --only "$topic" class/ana --out unread
rm kept/seed
if unshare -m true 2>/dev/null; then
  mkdir tiny
  in_tiny() { unshare -m bash -c 'mount -t tmpfs -o size=4k tiny tiny && head -c 4096 /dev/zero >tiny/filler; "$@"' - "$@"; }
  for arguments in "class/ana" "--class class"; do
    # shellcheck disable=SC2086 # two words
    printed="$(in_tiny "$muelle" grade --only "$topic" $arguments --out tiny 2>&1)"
    status=$?
    [[ $status -eq 1 && $printed == *" 10"* && $printed == *"No space left"* ]] || fail "full disk, $arguments: exit code $status, $printed"
  done
fi
exit $((failures > 0))
