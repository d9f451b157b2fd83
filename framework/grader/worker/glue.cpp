/// \file
/// Linked with a student's object file into the shared object that the worker loads; compiled once for each exercise,
/// with MUELLE_CONTRACT naming its header.

#include MUELLE_CONTRACT
#include "course/check/thrown_sentence.h"

#include <exception>

namespace std {
// NOLINTNEXTLINE(bugprone-reserved-identifier): the standard library calls it by this name
[[noreturn]] void __glibcxx_assert_fail(const char* file, int line, const char* function,
                                        const char* condition) noexcept;
}  // namespace std

namespace {

muelle::grader::worker::HostPort* currentPort = nullptr;

}  // namespace

void muelle::eigenAssertionFailed(const char* condition, const char* function, AssertedIndex index) {
  if (currentPort != nullptr) currentPort->refuse(condition, function, index.known, index.value);
  std::abort();  // an assertion in a constructor, before the first call
}

/// The standard library's own checks of indices (_GLIBCXX_ASSERTIONS) end here, in place of the library's function.
[[noreturn]] void std::__glibcxx_assert_fail(const char* /*file*/, int /*line*/, const char* function,
                                             const char* condition) noexcept {
  const std::string where = muelle::grader::worker::standardLibrary + std::string(function != nullptr ? function : "");
  if (currentPort != nullptr) currentPort->refuse(condition != nullptr ? condition : "", where, false, 0);
  std::abort();
}

extern "C" __attribute__((visibility("default"))) muelle::grader::worker::Served muelleServe(
    std::uint32_t id, const std::vector<std::byte>& arguments, std::vector<std::byte>& result, std::string& text,
    muelle::grader::worker::HostPort& port) {
  using namespace muelle::grader;
  currentPort = &port;
  for (const auto& function : worker::servedFunctions) {
    if (function.id != id) continue;
    try {
      wire::Reader in(arguments);
      wire::Writer out;
      function.call(in, out, port);
      result = std::move(out.bytes());
      return worker::Served::Returned;
    } catch (const std::exception& error) {
      text = muelle::textOf(error);
    } catch (...) {
      text.clear();
    }
    return worker::Served::Threw;
  }
  return worker::Served::Unknown;
}
