#pragma once
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace muelle {

/// What a function of a test throws that was asked what it cannot answer, a vector of the wrong length: whoever asked
/// is told so. \param what goes on after "springForce ": "asks for the force at 2 positions, where there are 3"
class BadQuestion : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// What a function of a test throws that is to reach whoever asked it: in the student's function it is a
/// std::runtime_error with these words, to be caught or not. Any other exception of a test's function is the test's
/// fault.
class ThrownToAsker : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A function that a test passes to the student's. Reports show its source; it counts how often it was asked.
///
///     const TestFunction<double(double)> square("[](double x) { return x * x; }", [](double x) { return x * x; });
///     submission::derivative(square, 0.3);
///     EXPECT_EQ(square.calls(), 2);
///
/// Its copies count together. It is kept beyond the test, for the oracle and the mistakes are asked the same calls
/// later: what it computes with is captured by value.
template <class Signature>
class TestFunction;

template <class Result, class... Args>
class TestFunction<Result(Args...)> {
 public:
  /// \param source as a student may type it; it must be what `function` does
  TestFunction(std::string source, std::function<Result(Args...)> function)
      : source_(std::move(source)), function_(std::move(function)) {}

  Result operator()(Args... args) const {
    ++*calls_;
    return function_(std::forward<Args>(args)...);
  }

  const std::string& source() const { return source_; }
  long calls() const { return *calls_; }
  void forgetCalls() const { *calls_ = 0; }

 private:
  std::string source_;
  std::function<Result(Args...)> function_;
  std::shared_ptr<long> calls_ = std::make_shared<long>(0);
};

}  // namespace muelle
