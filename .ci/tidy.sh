#!/usr/bin/env bash
# clang-tidy with the checks of .clang-tidy: of the recent sources (see common.sh), without the static analyser,
# which takes as long as all the rest; with --all of every source, analyser included.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
begin "clang-tidy"
plain_tree
options=(--quiet -p build-plain --extra-arg=-Wno-unknown-warning-option)
if [[ $share != all ]]; then options+=("--checks=-clang-analyzer-*"); fi

# Its count of the warnings that it keeps to itself (those of system headers) is no news.
tidy_sources | tr '\n' '\0' | xargs -0 -r -P "$jobs" -n 1 bash -c '
  said="$(clang-tidy "$@" 2>&1)" || { echo "$said"; echo "tidy.sh: see above: ${!#}" >&2; exit 1; }
' _ "${options[@]}"
