#!/usr/bin/env bash
# Usage: launcher_test.sh MUELLE_LAUNCHER. The launcher in a checkout of its own whose tools are stand-ins: one builds at
# a time, even when some are killed; waiting is said; a folder that cannot be written is named. Blanks, quotes and
# accents stand in the path throughout.
set -uo pipefail
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
folder="$scratch/a b'c\"d é"
mkdir -p "$folder/build/bin" "$scratch/tools"
cp "$1" "$folder/muelle"
failures=0
complain() {
  printf '%s\n' "$@" >&2
  failures=$((failures + 1))
}

# Stand-ins. The builder finds out whether another one is at work in the same folder, and how long it shall work.
cat >"$scratch/tools/ninja" <<'END'
#!/usr/bin/env bash
if ! mkdir "$2/busy" 2>/dev/null; then echo "overlap" >>"$2/overlaps"; fi
echo "$@" >>"$2/built"
sleep "$(cat "$2/work")"
rmdir "$2/busy"
END
cat >"$scratch/tools/cmake" <<'END'
#!/usr/bin/env bash
touch "$2/build/build.ninja"
END
printf '#!/bin/sh\nwhile [ $# -gt 3 ]; do printf "ii  %%s\\n" "$4"; shift; done\n' >"$scratch/tools/dpkg-query"
printf '#!/bin/sh\necho "ran $*"\n' >"$folder/build/bin/muelle"
chmod +x "$scratch/tools/"* "$folder/build/bin/muelle"
export PATH="$scratch/tools:$PATH"
export XDG_CACHE_HOME="$scratch/cache"

# expect CODE TEXT ARGUMENTS...: what the launcher ends with, and a text that must stand in what is printed.
expect() {
  local code="$1" text="$2" printed status
  shift 2
  printed="$("$folder/muelle" "$@" 2>&1 </dev/null)"
  status=$?
  if [[ $status -ne $code || $printed != *"$text"* ]]; then
    complain "./muelle $*: exit code $status (expected $code), printed: $printed" "(expected in it: $text)"
  fi
  if [[ $code -eq 2 && ($printed != muelle:* || $printed == *$'\n'*) ]]; then complain "not one line: $printed"; fi
}

echo 0 >"$folder/build/work"
expect 0 "ran"
# CMake cannot have a double quote in a path: it is given the folder under another name.
names=("$scratch/cache/muelle/"*)
if [[ ! ${names[0]} -ef $folder ]]; then
  complain "no second name for $folder: $(ls "$scratch/cache/muelle" 2>&1)"
fi
expect 0 "ran check it's --all" check "it's" --all

# Whoever waits says so once, without a terminal.
echo 4 >"$folder/build/work" # on a busy machine the second one takes seconds to come so far
"$folder/muelle" list >/dev/null 2>&1 &
until [[ -d "$folder/build/busy" ]]; do :; done
expect 0 "waiting for another ./muelle in this folder" list
wait

# The launcher is killed; what it has started works on, and is waited for.
"$folder/muelle" list >/dev/null 2>&1 &
launcher=$!
until [[ -d "$folder/build/busy" ]]; do :; done
kill -9 "$launcher"
wait 2>/dev/null
expect 0 "waiting for another" list

# Launcher and tool are killed together: the next one does not wait.
echo 100 >"$folder/build/work"
set -m
"$folder/muelle" list >/dev/null 2>&1 &
set +m
until [[ -d "$folder/build/busy" ]]; do :; done
kill -9 -- "-$!"
wait 2>/dev/null
rmdir "$folder/build/busy"
echo 0 >"$folder/build/work"
printed="$("$folder/muelle" list 2>&1)"
[[ $printed == "ran list" ]] || complain "after all have been killed: $printed"

# Many at once, every third of them killed soon: none builds beside another, and none is left waiting.
echo 0.02 >"$folder/build/work"
for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21; do
  "$folder/muelle" "number $i" >>"$scratch/said" 2>&1 &
  if [[ $((i % 3)) -eq 0 ]]; then kill -9 $! 2>/dev/null; fi
done
wait 2>/dev/null
[[ $(grep -c '^ran number' "$scratch/said") -ge 14 ]] || complain "some have not run: $(cat "$scratch/said")"
[[ ! -e "$folder/build/overlaps" ]] || complain "two have built at the same time"

# A build that fails: first what was handed out and is no longer as it was, then the first error, not all of the log.
mkdir -p "$folder/framework/course"
printf 'double f();\r\n' >"$folder/kept.h"
printf 'double g()\n' >"$folder/changed.h"
printf '%s\n' "30abe756add38d78 kept.h" "0123456789abcdef changed.h" "0123456789abcdef gone file.h" \
  >"$folder/framework/course/handed_out.txt"
cp "$scratch/tools/ninja" "$scratch/ninja"
cat >"$scratch/tools/ninja" <<'END'
#!/usr/bin/env bash
for ((i = 0; i < 500; ++i)); do echo "[$i/500] Building"; done
echo "changed.h:1:10: error: expected ';'"
for ((i = 0; i < 5000; ++i)); do echo "note: in expansion of macro"; done
exit 1
END
printed="$("$folder/muelle" list 2>&1 </dev/null)"
status=$?
cp "$scratch/ninja" "$scratch/tools/ninja"
[[ $status -eq 2 ]] || complain "a build that fails ends with $status"
[[ $printed == "muelle: changed.h is not as it was handed out"*"muelle: gone file.h is not as"*"error: expected ';'"* ]] ||
  complain "a build that fails names what has changed first: ${printed:0:2000}"
[[ $printed != *kept.h* ]] || complain "a file as it was handed out, but for carriage returns, is named"
[[ $(wc -l <<<"$printed") -le 30 && $printed == *muelle.log ]] ||
  complain "the words of a build that fails are cut: ${printed:0:2000}"
rm -r "$folder/framework"

# An author's `lint` reads the manifests before it builds what one of them would stop.
mkdir -p "$folder/framework/grader"
touch "$folder/framework/grader/CMakeLists.txt"
cp "$folder/build/bin/muelle" "$scratch/muelle"
printf '#!/bin/sh\n[ "$2" != --manifests ] || { echo "wheel: no manifest"; exit 1; }\n' >"$folder/build/bin/muelle"
rm "$folder/build/built"
printed="$("$folder/muelle" lint wheel 2>&1 </dev/null)"
status=$?
[[ $status -eq 1 && $printed == "wheel: no manifest" && $(cat "$folder/build/built") == *" muelle_app" ]] ||
  complain "a broken manifest: exit code $status, printed: $printed, built: $(cat "$folder/build/built")"
cp "$scratch/muelle" "$folder/build/bin/muelle"
expect 0 "ran lint wheel" lint wheel
grep -q muelle_grading "$folder/build/built" || complain "with good manifests lint builds nothing to grade with"
rm "$folder/build/built"
expect 0 "ran lint --files" lint --files
grep -q muelle_grading "$folder/build/built" && complain "lint --files builds what it does not run"
rm -r "$folder/framework"

# A folder that cannot be written. Root can write everywhere, so this takes another user.
refused() {
  local text="$1" printed
  printed="$(setpriv --reuid=65534 --clear-groups "$folder/muelle" list 2>&1)"
  if [[ $? -ne 2 || $printed != muelle:*"$text"*"cp -R"* || $printed == *$'\n'* ]]; then
    complain "expected one line with '$text', got: $printed"
  fi
}
if [[ $(id -u) -eq 0 ]] && command -v setpriv >/dev/null; then
  chmod 755 "$scratch"
  refused "build belongs to root and you cannot write there"
  rm -r "$folder/build"
  refused "belongs to root and you cannot write there"
  chown 65534 "$folder"
  chmod 555 "$folder"
  refused "is read-only, and the build goes there"
else
  echo "not root: a checkout of another user is not tried"
fi
exit $((failures > 0))
