#!/usr/bin/env bash
# ./muelle test; with --all the whole corpora of the graders' tests, too.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
begin "./muelle test"
./muelle test
if [[ $share == all ]]; then ./muelle test-the-tests; fi
