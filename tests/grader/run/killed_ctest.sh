#!/usr/bin/env bash
# Kills `ctest` on a submission, or the step that grades, at random moments: nothing is held against the submission in
# the run that was killed, and the next run says what an undisturbed one says.
# Usage: killed_ctest.sh STEP SOURCE [KILLS]     STEP: the program muelle-grade-step
set -uo pipefail
step="$1" source="$2" kills="${3:-2}"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

"$step" ctest-file "$work/CTestTestfile.cmake"
topic="$(sed -n 's/.*grade[.]\([a-z0-9_]*\)[.].*/\1/p' "$work/CTestTestfile.cmake" | head -n 1)"  # any would do
wrong=("$source/tests/submissions/$topic/wrong"/*/)

# What CTest says of each test: "grade.TOPIC.SUITE Passed".
run() {  # submission, store
  MUELLE_SUBMISSION="$1" MUELLE_KEPT="$2" MUELLE_SEED=killed exec ctest --test-dir "$work" --parallel 2 \
    --tests-regex "^grade[.]$topic[.]" --output-on-failure
}
outcomes() { sed -nE 's/.*Test +#[0-9]+: (grade[.][^ ]+) [. ]*(\**)(Passed|Failed|Not Run).*/\1 \3/p' "$1" | sort; }

fail() {
  printf '%s\n' "$1"
  cat "$work/said"
  exit 1
}

for submission in "$source/solutions/$topic" "${wrong[0]}"; do
  started=$(date +%s%N)
  (run "$submission" "$work/calm-store") >"$work/calm"
  milliseconds=$((($(date +%s%N) - started) / 1000000))
  [ -n "$(outcomes "$work/calm")" ] || fail "CTest ran nothing"
  for victim in ctest muelle-grade-step; do
    for ((i = 1; i <= kills; ++i)); do
      rm -rf "$work/store"
      set -m
      (run "$submission" "$work/store") >"$work/said" 2>&1 &
      group=$!
      set +m
      delay=$((RANDOM % milliseconds))
      sleep "$(printf '%d.%03d' $((delay / 1000)) $((delay % 1000)))"  # the moment is what is drawn at random
      pkill -9 -g "$group" -x "${victim:0:15}"
      wait "$group" 2>/dev/null
      # A test that failed has the calm run's reason, or says that the grader did not end.
      outcomes "$work/said" | grep ' Failed' | comm -23 - <(outcomes "$work/calm") >"$work/others"
      while read -r name _; do
        [ "$name" = "grade.$topic.build" ] && continue  # the fixture itself: CTest reports how it ended
        grep -qE "nothing has been said of $topic|no record of" "$work/said" || fail "$name failed for another reason"
      done <"$work/others"
      (run "$submission" "$work/store") >"$work/said" 2>&1
      cmp -s <(outcomes "$work/calm") <(outcomes "$work/said") || fail "the run after the kill says something else"
    done
  done
done
printf 'ctest and its step, killed %s times each: the next run says what an undisturbed one says\n' "$((2 * kills))"
