#!/usr/bin/env bash
# Kills the grading of a class at random moments and starts it again: in the end grades.csv has the bytes of a grading
# that nobody disturbed.
# Usage: killed_class.sh MUELLE SOURCE [KILLS [STUDENTS [EXERCISES]]]     usually 10 kills, 6 students, one exercise
set -uo pipefail
muelle="$(realpath "$1")" source="$(realpath "$2")" kills="${3:-10}" students="${4:-6}" exercises="${5:-1}"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

# The first exercises of the course that have submissions; each student takes one of these, right or wrong.
topics="$("$muelle" list | awk '{ print $2 }' | while read -r topic; do
  if [ -d "$source/tests/submissions/$topic" ]; then echo "$topic"; fi
done | head -n "$exercises")"
for ((i = 1; i <= students; ++i)); do
  for topic in $topics; do
    folders=("$source/tests/submissions/$topic"/*/*/)
    mkdir -p "$work/class/student_$i/$topic"
    cp "${folders[$((i % ${#folders[@]}))]}"*.cpp "$work/class/student_$i/$topic/"
    printf '// student %s\n' "$i" >>"$work/class/student_$i/$topic/$topic.cpp"  # no two are the same
  done
done

grade() { MUELLE_KEPT="$1" "$muelle" grade --class "$work/class" --only "${topics//$'\n'/,}" --seed killed --out "$2" >"$work/said" 2>&1; }

grade "$work/calm-store" "$work/calm" || { cat "$work/said"; exit 1; }
started=$(date +%s%N)
grade "$work/measure-store" "$work/measure"  # the tools' own files are read by now
milliseconds=$((($(date +%s%N) - started) / 1000000))

# Until it has been killed so often; whenever it has come to an end instead, from nothing again.
killed=0 ended=0
while ((killed < kills)); do
  MUELLE_KEPT="$work/store" setsid "$muelle" grade --class "$work/class" --only "${topics//$'\n'/,}" --seed killed \
    --out "$work/out" >"$work/said" 2>&1 &
  pid=$!
  delay=$((RANDOM % (milliseconds / 3 + 1)))
  sleep "$(printf '%d.%03d' $((delay / 1000)) $((delay % 1000)))"  # the moment is what is drawn at random
  kill -9 "$pid" 2>/dev/null
  wait "$pid" 2>/dev/null
  status=$?
  if ((status == 128 + 9)); then
    killed=$((killed + 1))
    continue
  fi
  ((status == 0)) || { cat "$work/said"; exit 1; }
  cmp "$work/calm/grades.csv" "$work/out/grades.csv" || exit 1
  ended=$((ended + 1))
  rm -rf "$work/store" "$work/out"
done
grade "$work/store" "$work/out" || { cat "$work/said"; exit 1; }
cmp "$work/calm/grades.csv" "$work/out/grades.csv" || exit 1
printf '%s students, killed %s times, %s gradings ended: grades.csv is the same\n' "$students" "$killed" $((ended + 1))
