#pragma once
#include "course/check/outcome.h"

#include <stdexcept>
#include <string>

namespace muelle::grader {

/// The student's code did something else than return a value: crash, hang, forbidden call, malformed answer. The class
/// says what; Outcome::Killed, Wall and Struck may be the machine's doing, and whoever judges tries them once more.
class SubmissionFault : public std::runtime_error {
 public:
  explicit SubmissionFault(const std::string& what, Outcome outcome = Outcome::Wrong, bool isConfirmed = false)
      : std::runtime_error(what), outcome_(outcome), isConfirmed_(isConfirmed) {}
  Outcome outcome() const { return outcome_; }
  /// A sanitizer has found it, and it is what the second look is made for.
  bool isConfirmed() const { return isConfirmed_; }

 private:
  Outcome outcome_;
  bool isConfirmed_;
};

/// Something on our side is broken: the sandbox, the worker's files, the contract. Never costs a student points.
class GraderFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace muelle::grader
