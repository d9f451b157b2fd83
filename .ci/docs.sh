#!/usr/bin/env bash
# The documentation; doxygen's warnings are errors.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
begin "documentation"
./muelle docs
