#pragma once
#include "course/testing/print_value.h"
#include "course/testing/test_function.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace muelle {

/// What was asked of functions that a test passes to the student's, and what they answered: a test that shows it lets a
/// student see what was looked at.
///
///     const QuestionLog log;
///     submission::isRoot(log.kept("f", "[](double x) { return x * x; }", square), 0.0);
///     log.count();  // 2, say
///     log.text();   // "f(0) is 0, f(1) is 1"
///
/// Functions of one log share it, and keep it beyond the test.
class QuestionLog {
 public:
  static constexpr std::size_t mostKept = 6;  ///< of the questions as text: enough to see what is asked

  /// A function whose questions are counted here. \param name as the log's text has it \param source as in TestFunction
  template <class Result, class... Args>
  TestFunction<Result(Args...)> kept(std::string name, std::string source,
                                     std::function<Result(Args...)> function) const {
    return {std::move(source), [pages = pages_, name = std::move(name), function = std::move(function)](Args... args) {
              ++pages->count;
              const bool isKept = pages->questions.size() < mostKept;
              if (isKept) pages->questions.push_back(printCall(name.c_str(), args...) + " throws");
              const Result answer = function(args...);
              if (isKept) pages->questions.back() = printCall(name.c_str(), args...) + " is " + printValue(answer);
              return answer;
            }};
  }

  long count() const { return pages_->count; }

  /// The first questions with their answers, in one line.
  std::string text() const {
    std::string line;
    for (const std::string& question : pages_->questions) line += (line.empty() ? "" : ", ") + question;
    const long more = count() - static_cast<long>(pages_->questions.size());
    return more > 0 ? line + " and " + std::to_string(more) + " more" : line;
  }

 private:
  struct Pages {
    long count = 0;
    std::vector<std::string> questions;
  };
  std::shared_ptr<Pages> pages_ = std::make_shared<Pages>();
};

}  // namespace muelle
