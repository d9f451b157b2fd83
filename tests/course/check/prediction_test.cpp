/// \file
/// A prediction is chosen by number or words, kept, and asked for anew when the answers have changed.

#include "course/check/prediction.h"

#include "base/build_paths.h"
#include "base/file.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

const Prediction predict{"Does the swing keep its height?", {"it grows", "it stays", "it shrinks"}};

TEST(Prediction, IsChosenByNumberOrWords) {
  EXPECT_EQ(chosenAnswer(predict, " 2\n"), "it stays");
  EXPECT_EQ(chosenAnswer(predict, "it shrinks"), "it shrinks");
  for (const char* other : {"", "0", "4", "it", "2 3"}) EXPECT_EQ(chosenAnswer(predict, other), std::nullopt) << other;
}

TEST(Prediction, IsKept) {
  const TemporaryFolder folder(std::filesystem::path(build_paths::binary) / "test");
  EXPECT_EQ(keptPrediction(predict, folder.path()), std::nullopt);
  keepPrediction("it grows", folder.path() / "new");
  EXPECT_EQ(keptPrediction(predict, folder.path() / "new"), "it grows");
  const Prediction changed{predict.question, {"it rises", "it falls"}};
  EXPECT_EQ(keptPrediction(changed, folder.path() / "new"), std::nullopt);
}

TEST(Prediction, ShowsItsAnswersWithNumbers) {
  EXPECT_EQ(numberedAnswers(predict, ", "), "1: it grows, 2: it stays, 3: it shrinks");
}

}  // namespace
}  // namespace muelle
