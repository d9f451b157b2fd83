#pragma once
/// \file
/// The last call of a student's function, as text that can be pasted into a program.

#include "course/testing/print_value.h"

#include <string>

namespace muelle {

/// Notes that a student's function is being called, from construction to destruction.
/// In a test the arguments are printed at once (a failure shows them); in a demo, which makes thousands of calls,
/// only when a crash asks.
class CallRecord {
 public:
  template <class... Args>
  CallRecord(const char* function, const Args&... args) : function_(function), outer_(current()) {
    current() = this;
    ++count();
    if (printsArguments()) setLastCall(printCall(function, args...));
  }
  CallRecord(const CallRecord&) = delete;
  CallRecord& operator=(const CallRecord&) = delete;
  ~CallRecord() { current() = outer_; }

  const char* function() const { return function_; }

  /// The innermost call in progress, or null.
  static CallRecord*& current();
  /// Number of calls begun so far: tells a call that lasts from many short ones.
  static long& count();
  /// The text of the latest call made while arguments were printed, or "".
  static const std::string& lastCall();
  static void setLastCall(std::string call);
  /// Name of the first function that returned memory to which nothing was written, since this was last cleared, or "".
  static std::string& neverWritten();
  /// What the latest question of a student's function was that had no answer (BadQuestion), or "".
  static std::string& badQuestion();
  /// Whether calls print their arguments; true unless a demo runs.
  static bool& printsArguments();

 private:
  const char* function_;
  CallRecord* outer_;
};

}  // namespace muelle
