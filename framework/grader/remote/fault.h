#pragma once
#include <stdexcept>
#include <string>

namespace muelle::grader {

/// The student's code did something else than return a value: crash, hang, forbidden call, malformed answer.
class SubmissionFault : public std::runtime_error {
 public:
  SubmissionFault(const std::string& what, bool timedOut = false) : std::runtime_error(what), timedOut_(timedOut) {}
  bool timedOut() const { return timedOut_; }

 private:
  bool timedOut_;
};

/// Something on our side is broken: the sandbox, the worker's files, the contract. Never costs a student points.
class GraderFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace muelle::grader
