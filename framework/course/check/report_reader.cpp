#include "course/check/report_reader.h"

#include "course/check/fault_sentences.h"
#include "course/check/heap_damage.h"
#include "course/check/test_processes.h"
#include "course/testing/mismatch_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <csignal>
#include <cstring>

namespace muelle {

namespace {

/// Beyond the end when it is not among them.
std::size_t placeOf(const FailedTest& test, const std::vector<FailedTest>& among) {
  const auto isIt = [&test](const FailedTest& t) { return t.suite == test.suite && t.name == test.name; };
  return static_cast<std::size_t>(std::ranges::find_if(among, isIt) - among.begin());
}

Outcome outcomeOf(const CommandResult& result) {
  if (!result.status.signalled) return Outcome::Crash;
  if (result.status.code == SIGXCPU) return Outcome::Cpu;
  return isOwnSignal(result.status.code) ? Outcome::Crash : Outcome::Killed;
}

}  // namespace

FailedTest testNamed(const std::string& fullName) {
  const std::size_t dot = fullName.find('.');
  FailedTest test;
  test.suite = fullName.substr(0, dot);
  test.name = fullName.substr(dot + 1);
  return test;
}

void ReportReader::take(const std::string& kind, const std::string& text) {
  if (kind == "planned" && !isLater_) planned_.push_back(text);  // the first process knows all
  if (kind == "test") begin(text);
  if (kind == "call" && current_.call.empty()) current_.call = text;
  if (kind == "mismatch") takeMismatch(text);
  if (kind == "failure") current_.messages.push_back(text);
  if (kind == "property") current_.property = text;
  if (kind == "outcome" && !hasOutcome_) {
    current_.outcome = outcomeNamed(text);
    hasOutcome_ = true;
  }
  if (kind == "factor") takeFinding(&CommonFinding::factor, text);
  if (kind == "difference") takeFinding(&CommonFinding::difference, text);
  if (kind == "crash") crash_ = text;
  if (kind == "end") end(text == "passed");
  if (kind == "done") done_ = true;
}

void ReportReader::close(const CommandResult& result) {
  if (!done_ && crash_.empty()) {
    crash_ = describe(result);
    current_.outcome = outcomeOf(result);
  }
  explainAbort(result.out);
  if (running_) {
    current_.messages.push_back(crash_);
    report_.failures.push_back(current_);
  } else if (!done_) {
    lastOutcome_ = current_.outcome;
  }
  if (report_.crash.empty()) report_.crash = crash_;
  report_.total = static_cast<int>(planned_.size());
  report_.notRun.clear();
  std::ranges::copy_if(planned_, std::back_inserter(report_.notRun),
                       [this](const std::string& name) { return placeOf(testNamed(name), begun_) == begun_.size(); });
  crash_.clear();
  running_ = done_ = false;
  isLater_ = true;
}

void ReportReader::confirm(const FailedTest& found) {
  if (found.name.empty()) {
    report_.passed = 0;
    report_.failures.insert(report_.failures.begin(), found);
    return;
  }
  const std::size_t place = placeOf(found, begun_);
  if (place == begun_.size()) return;  // it had no time to run; another has failed
  const std::size_t failure = placeOf(found, report_.failures);
  FailedTest& test = failure == report_.failures.size() ? fail(place) : report_.failures[failure];
  if (test.call.empty()) test.call = found.call;
  test.messages.insert(test.messages.begin(), found.messages.begin(), found.messages.end());
  test.outcome = found.outcome;
}

Outcome ReportReader::outcome() const {
  if (report_.allPassed()) return Outcome::Passed;
  if (report_.failures.empty()) return lastOutcome_;
  const auto of = [](const FailedTest& failure) { return failure.outcome; };
  const auto ended = std::ranges::find_if(
      report_.failures, [](Outcome o) { return o != Outcome::Wrong && o != Outcome::NeverWritten; }, of);
  if (ended != report_.failures.end()) return ended->outcome;
  const bool isUnwritten = std::ranges::find(report_.failures, Outcome::NeverWritten, of) != report_.failures.end();
  return isUnwritten ? Outcome::NeverWritten : Outcome::Wrong;
}

/// "twice called abort()": the C library may have said why.
void ReportReader::explainAbort(const std::string& output) {
  constexpr std::string_view plain = abortSentence;
  const std::string damage = crash_.ends_with(plain) ? heapDamage(output) : "";
  if (!damage.empty()) crash_.replace(crash_.size() - plain.size(), plain.size(), damage);
}

/// A test that had passed, now among the failures in the order of the tests. \param place where it began
FailedTest& ReportReader::fail(std::size_t place) {
  const auto isLater = [&](const FailedTest& test) { return placeOf(test, begun_) > place; };
  --report_.passed;
  return *report_.failures.insert(std::ranges::find_if(report_.failures, isLater), begun_[place]);
}

void ReportReader::takeMismatch(const std::string& text) {
  if (const std::optional<Mismatch> mismatch = readMismatch(text)) current_.mismatches.push_back(*mismatch);
}

/// "-1 springForce": a factor or a difference
void ReportReader::takeFinding(double CommonFinding::*kind, const std::string& text) {
  const std::size_t blank = std::min(text.find(' '), text.size());
  const std::optional<double> number = exactNumber(text.substr(0, blank));
  if (!number || blank >= text.size()) return;
  CommonFinding finding{text.substr(blank + 1)};
  finding.*kind = *number;
  report_.findings.push_back(std::move(finding));
}

void ReportReader::begin(const std::string& fullName) {
  current_ = testNamed(fullName);
  hasOutcome_ = false;
  running_ = true;
  begun_.push_back(current_);
}

void ReportReader::end(bool passed) {
  running_ = false;
  hasOutcome_ = false;
  begun_.back().property = current_.property;
  if (passed) {
    ++report_.passed;
  } else {
    report_.failures.push_back(current_);
  }
}

std::string ReportReader::describe(const CommandResult& result) const {
  const std::string who = begun_.empty() ? loadingCode : "your code";
  const char* sentence = result.status.signalled ? signalSentence(result.status.code) : nullptr;
  if (sentence != nullptr) return fmt::format("{} {}", who, sentence);
  if (result.status.signalled && result.status.code == SIGXCPU)
    return fmt::format("the tests took more than {} s of processor time", testsProcessorSeconds(callSeconds_));
  if (result.status.signalled) return fmt::format("{} was ended by a signal: {}", who, strsignal(result.status.code));
  return fmt::format("{} {}", who, exitSentence(result.status.code));
}

}  // namespace muelle
