#pragma once
/// \file
/// MUELLE_FUNCTIONS for the reference run of a demo: submission::f and given::f are the oracle's f.

#include "course/testing/struct_fields.h"
#include "harness/for_each.h"

#define MUELLE_ORACLE_FUNCTION_(function)                                                  \
  namespace oracle {                                                                       \
  decltype(::function) function;                                                           \
  }                                                                                        \
  namespace submission {                                                                   \
  [[maybe_unused]] constexpr decltype(::oracle::function)* function = &::oracle::function; \
  }                                                                                        \
  namespace given {                                                                        \
  [[maybe_unused]] constexpr decltype(::oracle::function)* function = &::oracle::function; \
  }
#define MUELLE_FUNCTIONS(...) MUELLE_FOR_EACH(MUELLE_ORACLE_FUNCTION_, __VA_ARGS__)
