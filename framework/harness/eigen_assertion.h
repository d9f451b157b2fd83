#pragma once
/// \file
/// Turns Eigen's assertions into a report that a student can read.
///
/// Must come before any header of Eigen. Eigen's range checks have the offending index in a local variable called
/// `index`; where an assertion has no such variable, the name finds Eigen::index below, which says "unknown". Where it
/// finds something that is no number (Diagonal and the sparse iterators have a member function index()), neither is
/// used.

#include <cstring>
#include <exception>

namespace muelle {

/// What an assertion knows about the index that it refused.
struct AssertedIndex {
  long value = -1;
  bool known = false;
  constexpr AssertedIndex() = default;
  constexpr AssertedIndex(long i) : value(i), known(true) {}  // NOLINT(google-explicit-constructor): a bare `index`
};

/// Called when Eigen refuses an operation: out-of-range index, sizes that do not fit. Never returns.
/// Whoever runs student code defines it (the public test program, the worker); the harness library has a default
/// that prints and aborts.
/// \param condition the assertion's text   \param function the Eigen function, with its template arguments
[[noreturn]] void eigenAssertionFailed(const char* condition, const char* function, AssertedIndex index);

/// True of `v << a, f(b)` when f throws: the numbers that are still missing are counted in a destructor, where the
/// exception is on its way already and says what happened.
/// \param condition the assertion's text
inline bool isLeftUnfinished(const char* condition) {
  return std::uncaught_exceptions() > 0 && std::strstr(condition, "Too few coefficients") != nullptr;
}

}  // namespace muelle

namespace Eigen {
/// Found by the assertion macro where no local variable `index` is in scope.
inline constexpr ::muelle::AssertedIndex index{};
}  // namespace Eigen

#ifdef eigen_assert
#error "harness/eigen_assertion.h must be included before Eigen"
#endif
#ifdef EIGEN_NO_DEBUG  // the engine, whose indices its tests have seen
#define eigen_assert(condition) static_cast<void>(0)
#else
#define eigen_assert(condition)                                                                          \
  do {                                                                                                   \
    if (!(condition) && !::muelle::isLeftUnfinished(#condition)) {                                       \
      if constexpr (requires { ::muelle::AssertedIndex(index); }) {                                      \
        ::muelle::eigenAssertionFailed(#condition, __PRETTY_FUNCTION__, ::muelle::AssertedIndex(index)); \
      } else {                                                                                           \
        ::muelle::eigenAssertionFailed(#condition, __PRETTY_FUNCTION__, ::muelle::AssertedIndex{});      \
      }                                                                                                  \
    }                                                                                                    \
  } while (false)
#endif
