# Sourced by tests of a command: $program is its file, $word its name behind `muelle`. Counts in $failures.
failures=0

# expect CODE TEXT ARGUMENTS...: exit code, and a text that must stand in what is printed.
expect() {
  local code="$1" text="$2" printed status
  shift 2
  printed="$("$program" "$@" 2>&1 </dev/null)"
  status=$?
  if [[ $status -ne $code || $printed != *"$text"* ]]; then
    printf 'muelle %s %s: exit code %s (expected %s), printed:\n%s\n(expected in it: %s)\n' "$word" "$*" "$status" \
      "$code" "$printed" "$text" >&2
    failures=$((failures + 1))
  fi
  if [[ $code -eq 2 && ($printed != muelle:* || $printed == *$'\n'*) ]]; then
    printf 'muelle %s %s: an error is one line that begins with "muelle: ", got:\n%s\n' "$word" "$*" "$printed" >&2
    failures=$((failures + 1))
  fi
  if [[ $printed == *$'\e'* ]]; then
    printf 'muelle %s %s: escape sequences without a terminal\n' "$word" "$*" >&2
    failures=$((failures + 1))
  fi
}
