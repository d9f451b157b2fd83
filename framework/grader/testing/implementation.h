#pragma once
/// \file
/// Submissions of earlier exercises inside a hidden test, which hands them to the student's function to be judged.
///
/// An exercise lists them in tests/hidden/TOPIC/implementations.txt, one a line:
///
///     # exercise  submission         group   what is said of it
///     spring_1d   right/by_cases     plain
///     spring_1d   wrong/wrong_sign   values  pushes where it should pull
///
/// Each is compiled from the corpus of its exercise, inside a namespace of its own
/// (framework/grader/Implementations.cmake). They run in the test's own process: what crashes, hangs, asserts or keeps
/// anything between calls cannot be listed.

#include "course/testing/test_function.h"

#include <any>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace muelle::grader {

/// A submission of an exercise's corpus, as functions to be called.
class Implementation {
 public:
  /// The functions of the contract by name, each a pointer.
  using Functions = std::map<std::string, std::any>;

  Implementation(std::string submission, std::string group, std::string says, Functions functions)
      : submission_(std::move(submission)),
        group_(std::move(group)),
        says_(std::move(says)),
        functions_(std::move(functions)) {}

  bool isRight() const { return submission_.starts_with("right/"); }
  const std::string& submission() const { return submission_; }  ///< for authors: its name is not for students
  const std::string& group() const { return group_; }
  /// "pushes where it should pull": for students, when it is taken for what it is not.
  const std::string& says() const { return says_; }

  /// One of its functions: function<double(double)>("f"). Whatever that throws is ThrownToAsker. Throws
  /// std::out_of_range for a name that the contract lacks, std::bad_any_cast for another signature.
  template <class Signature>
  std::function<Signature> function(const std::string& name) const {
    return guarded(std::any_cast<Signature*>(functions_.at(name)));
  }

 private:
  template <class Result, class... Args>
  static std::function<Result(Args...)> guarded(Result (*called)(Args...)) {
    return [called](Args... args) -> Result {
      try {
        return called(args...);
      } catch (...) {
        throw ThrownToAsker("the implementation that is judged threw an exception");
      }
    };
  }

  std::string submission_, group_, says_;
  Functions functions_;
};

/// What is listed of an exercise's corpus, in the list's order.
std::vector<Implementation>& implementationsOf(const std::string& exercise);

/// What the build makes of a line of the list.
struct ImplementationRegistration {
  ImplementationRegistration(const std::string& exercise, Implementation implementation) {
    implementationsOf(exercise).push_back(std::move(implementation));
  }
};

}  // namespace muelle::grader
