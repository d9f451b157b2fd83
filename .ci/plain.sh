#!/usr/bin/env bash
# Every source compiles without the precompiled header: g++'s syntax pass over the compile database.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
begin "every source through g++ without precompiled header, syntax only"
plain_tree

# Commands of the database as shell lines, one for each source: a second one differs in definitions alone.
commands() {
  sed -n 's/^  "command": "\(.*\)",$/\1/p' build-plain/compile_commands.json | sed 's/\\\(["\\]\)/\1/g' |
    awk '!seen[$NF]++'
}

commands | tr '\n' '\0' | xargs -0 -P "$jobs" -n 1 bash -c '
  cd build-plain
  line="${1/ -o * -c / -fsyntax-only -O0 }"
  eval "$line" || { echo "plain.sh: ${1##* } does not compile without precompiled header" >&2; exit 1; }
' _
