#include "grader/testing/asked_afresh.h"

#include "fixture.h"
#include "fixture_session.h"
#include "grader/testing/gather_evidence.h"
#include "misbehaviour.h"

namespace {

using misbehaviour::KeepsTheFirst;
using muelle::grader::answersOtherwiseAfresh;
using muelle::grader::CallHistory;
using muelle::grader::FunctionEvidence;
using muelle::grader::gatherEvidence;

/// misbehave(), with an oracle that gives its argument, and no calls yet.
class AskedAfresh : public muelle::grader::FixtureSession {
 protected:
  using History = CallHistory<double(int)>;

  AskedAfresh() : history_(History::of("misbehave")) {
    history_.keepOnly(0);
    history_.setOracle([](int how) { return how; });
  }
  ~AskedAfresh() override { history_.setOracle(nullptr); }

  void ask(std::initializer_list<int> more) {
    for (const int each : more) submission::misbehave(KeepsTheFirst + each);
  }
  History& history() { return history_; }

 private:
  History& history_;
};

TEST_F(AskedAfresh, FindsWhatTheFirstCallHasLeft) {
  ask({3, 1, 2});
  const FunctionEvidence found = gatherEvidence(history());
  EXPECT_EQ(found.wrong, 2);
  EXPECT_TRUE(answersOtherwiseAfresh("misbehave", history(), found));
  EXPECT_EQ(history().calls(), 3U) << "the calls are as they were";
}

TEST_F(AskedAfresh, BelievesAFunctionThatIsWrongEveryTime) {
  history().setOracle([](int how) { return how + 1; });
  for (int i = 0; i < 5; ++i) submission::misbehave(900 + i);  // 0
  const FunctionEvidence found = gatherEvidence(history());
  EXPECT_EQ(found.wrong, 5);
  EXPECT_FALSE(answersOtherwiseAfresh("misbehave", history(), found));
}

TEST_F(AskedAfresh, AsksNothingWhereAMistakeExplainsTheAnswers) {
  ask({3, 1, 2});
  FunctionEvidence found = gatherEvidence(history());
  found.agreeing.push_back({});
  const long before = session().calls();
  EXPECT_FALSE(answersOtherwiseAfresh("misbehave", history(), found));
  EXPECT_EQ(session().calls(), before);
}

}  // namespace
