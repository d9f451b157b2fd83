#!/usr/bin/env bash
# Every test but the long studies of numbers, the matrix of submissions and the corpora with AddressSanitizer and
# UndefinedBehaviorSanitizer. Those three are no news here: they run the programs that the rest tests, and workers that have
# no sanitizers. The studies (convergence, peers, benchmarks) are not built, see MUELLE_ASAN in the CMake files; of the hard
# cases every method takes its first steps on every variant, and every figure is computed.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
begin "tests with sanitizers"
cmake --preset asan >/dev/null
ninja -C build-asan --quiet
# A sanitised program takes up to twenty times as long as one at -O2, on a busy machine longer.
ctest --preset asan --timeout 1500
