#!/usr/bin/env bash
# The code compiles without precompiled header: g++'s syntax pass. Unless --all, over the recent sources that neither
# clang.sh nor tidy.sh reads, which do without the header, too.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
begin "the code through g++ without precompiled header, syntax only"
plain_tree

sources() {
  if [[ $share == all ]]; then
    database_sources
  else
    comm -23 <(database_sources) <({ handed_out_rooms; tidy_sources; } | sort -u) | recent
  fi
}

# Commands of the database as shell lines, one a source: a second one differs in definitions alone.
commands() {
  sed -n 's/^  "command": "\(.*\)",\{0,1\}$/\1/p' build-plain/compile_commands.json | sed 's/\\\(["\\]\)/\1/g' |
    awk -v root="$PWD/" 'NR == FNR { wanted[root $0]; next } ($NF in wanted) && !seen[$NF]++' <(sources) -
}

commands | tr '\n' '\0' | xargs -0 -r -P "$jobs" -n 1 bash -c '
  cd build-plain
  eval "${1/ -o * -c / -fsyntax-only -O0 }" ||
    { echo "plain.sh: ${1##* } does not compile without precompiled header" >&2; exit 1; }
' _
