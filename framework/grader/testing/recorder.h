#pragma once
#include "grader/remote/session.h"
#include "grader/verdict.h"

#include <gtest/gtest.h>

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
  Session& session_;
  Verdict& verdict_;
  TestOutcome current_;
};

}  // namespace muelle::grader
