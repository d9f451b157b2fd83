#pragma once
/// \file
/// Conditions on an argument of a system call. libseccomp's own macros for them (SCMP_A0) are C.

#include <seccomp.h>

namespace muelle::grader::worker {

/// \param argument counted from 0
constexpr scmp_arg_cmp argumentIs(unsigned argument, scmp_datum_t value) { return {argument, SCMP_CMP_EQ, value, 0}; }

/// Of the bits in `mask` those in `value` are set, and no others.
constexpr scmp_arg_cmp argumentHas(unsigned argument, scmp_datum_t mask, scmp_datum_t value) {
  return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

}  // namespace muelle::grader::worker
