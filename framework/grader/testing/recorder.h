#pragma once
#include "grader/remote/session.h"
#include "grader/verdict.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace muelle::grader {

/// Listens to GoogleTest and fills a verdict.
class Recorder : public ::testing::EmptyTestEventListener {
 public:
  Recorder(Session& session, Verdict& verdict) : session_(session), verdict_(verdict) {}

  void OnTestStart(const ::testing::TestInfo& info) override;
  void OnTestPartResult(const ::testing::TestPartResult& part) override;
  void OnTestEnd(const ::testing::TestInfo& info) override;
  void OnTestProgramEnd(const ::testing::UnitTest& program) override;

 private:
  void withdraw();

  Session& session_;
  Verdict& verdict_;
  TestOutcome current_;
  std::vector<std::set<std::string>> called_;  ///< the functions that each test of the record has called
};

}  // namespace muelle::grader
