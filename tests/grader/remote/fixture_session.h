#pragma once
#include "grader/remote/session.h"
#include "grader/sandbox/sandbox.h"

#include <gtest/gtest.h>

namespace muelle::grader {

/// A session with the fixture's worker, started at the first call, in the strongest sandbox or that of MUELLE_SANDBOX.
class FixtureSession : public ::testing::Test {
 protected:
  FixtureSession() {
    const char* name = std::getenv("MUELLE_SANDBOX");
    sandbox_ = makeSandbox(parseSandboxChoice(name != nullptr ? name : ""));
    start({});
  }
  ~FixtureSession() override { Session::setCurrent(nullptr); }

  void start(SessionLimits limits) {
    session_ = std::make_unique<Session>(Session::Setup{sandbox_.get(), MUELLE_HOST, MUELLE_FIXTURE, 7, limits});
    Session::setCurrent(session_.get());
  }
  Session& session() { return *session_; }
  const Sandbox& sandbox() const { return *sandbox_; }

 private:
  std::unique_ptr<Sandbox> sandbox_;
  std::unique_ptr<Session> session_;
};

}  // namespace muelle::grader
