#!/usr/bin/env bash
# Usage: bare_root_test.sh SOURCE BUILD. In a root where bubblewrap can make no namespaces, as a chroot of a bare Debian
# and most containers are, the README's first command grades with Landlock and says so. The root is this machine's under
# another name, without /proc. 77: not tried, with the reason.
set -uo pipefail

if [[ ${1:-} == inside ]]; then
  # In a mount namespace of its own, which ends with this process.
  source="$2" build="$3" scratch="$4"
  source "$source/tests/support/first_exercise.sh"
  topic="$(first_exercise "$source")"
  root="$scratch/root"
  mkdir "$root"
  mount --bind / "$root" || exit 77
  for folder in /dev "$source" "$build" "$scratch"; do
    folder="$(cd "$folder" && pwd -P)"  # a link would lead out of the root
    mount --rbind "$folder" "$root$folder" || exit 77
  done
  command=("$build/bin/muelle")
  # The launcher builds in build/ alone.
  if [[ $build == "$source/build" ]]; then command=("$source/muelle" --no-install); fi
  MUELLE_KEPT="$scratch/kept" exec chroot "$root" /usr/bin/env -C "$source" "${command[@]}" \
    grade solutions --only "$topic" --out "$scratch/out"
fi

skip() {
  echo "not tried: $1"
  exit 77
}
[[ $(id -u) -eq 0 ]] || skip "only root can change the root"
unshare --mount true 2>/dev/null || skip "no mount namespace can be made here"
scratch="$(mktemp -d)"
trap 'rm -rf --one-file-system "$scratch"' EXIT
# 126: it is built, and this kernel has no Landlock.
"$2/bin/muelle-confine" --read / -- /usr/bin/true 2>"$scratch/why"
[[ $? -eq 126 ]] && skip "$(cat "$scratch/why")"

printed="$(unshare --mount bash "$0" inside "$1" "$2" "$scratch" 2>&1 </dev/null)"
status=$?
[[ $status -eq 77 ]] && skip "$printed"
said="$(tr '\n' ' ' <<<"$printed")"
if [[ $status -ne 0 || $said != *"sandbox: landlock (weaker than bubblewrap"*"bubblewrap cannot"*"make its namespaces"* ||
  $said == *"no score"* || $said == *"✗"* || $said != *"✓"* ]]; then
  printf 'exit code %s, printed:\n%s\n' "$status" "$printed" >&2
  exit 1
fi
