/// \file
/// A manifest is read whole or refused with file, line and key.

#include "course/manifest.h"

#include "base/build_paths.h"
#include "base/file.h"

#include <gtest/gtest.h>
#include <stdexcept>
#include <string>

namespace muelle {
namespace {

const std::string good = R"(order = 10
title = "A spring"
points = 3.5
files = ["spring_1d.cpp"]
feedback = "property"
slides = ["Ley de Hooke"]

[[criterion]]
name = "Hooke's force"
suite = "HookeForce"
points = 2
functions = ["springForce"]
hint = "Look at the sign."

[[criterion]]
name = "Third law"
suite = "ThirdLaw"
points = 1.5
partial = true
functions = ["springForce", "otherForce"]
hint = "Equal and opposite."

[[misconception]]
id = "wrong_sign"
function = "springForce"
says = "your force has the wrong sign"
hint = "swap it"
)";

class ManifestFile : public testing::Test {
 protected:
  Manifest read(const std::string& text, const std::string& topic = "spring_1d") {
    std::filesystem::create_directories(folder_.path() / topic);
    writeFile(folder_.path() / topic / "exercise.toml", text);
    return readManifest(folder_.path() / topic / "exercise.toml");
  }
  /// The good manifest with one part replaced.
  static std::string with(const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("no '" + from + "' in the manifest");
    return text.replace(at, from.size(), to);
  }
  std::string complaint(const std::string& text, const std::string& topic = "spring_1d") {
    try {
      read(text, topic);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  }
  TemporaryFolder folder_{std::filesystem::path(build_paths::binary) / "test"};
};

TEST_F(ManifestFile, MayAskForAPrediction) {
  EXPECT_EQ(read(good).predict.question, "");
  const std::string asks =
      "slides = [\"Ley de Hooke\"]\n\n[predict]\nquestion = \"Does it stop?\"\nanswers = [\"yes\", \"no\"]";
  const Manifest manifest = read(with("slides = [\"Ley de Hooke\"]", asks));
  EXPECT_EQ(manifest.predict.question, "Does it stop?");
  EXPECT_EQ(manifest.predict.answers, (std::vector<std::string>{"yes", "no"}));
  EXPECT_NE(complaint(with("slides = [\"Ley de Hooke\"]", "[predict]\nquestion = \"Why?\"\nanswers = [\"so\"]"))
                .find("from two to 9 answers"),
            std::string::npos);
}

TEST_F(ManifestFile, HasEveryField) {
  const Manifest manifest = read(good);
  EXPECT_EQ(manifest.topic, "spring_1d");
  EXPECT_EQ(manifest.order, 10);
  EXPECT_EQ(manifest.title, "A spring");
  EXPECT_EQ(manifest.points, 3.5);
  EXPECT_EQ(manifest.files, std::vector<std::string>{"spring_1d.cpp"});
  EXPECT_EQ(manifest.feedback, FeedbackLevel::Property);
  EXPECT_EQ(manifest.slides, std::vector<std::string>{"Ley de Hooke"});
  ASSERT_EQ(manifest.criteria.size(), 2U);
  EXPECT_EQ(manifest.criteria[0].suite, "HookeForce");
  EXPECT_FALSE(manifest.criteria[0].partial);
  EXPECT_EQ(manifest.criteria[1].points, 1.5);
  EXPECT_TRUE(manifest.criteria[1].partial);
  EXPECT_EQ(manifest.criteria[1].functions, (std::vector<std::string>{"springForce", "otherForce"}));
  ASSERT_EQ(manifest.misconceptions.size(), 1U);
  EXPECT_EQ(manifest.misconceptions[0].id, "wrong_sign");
  EXPECT_EQ(manifest.misconceptions[0].function, "springForce");
}

TEST_F(ManifestFile, ACriterionFollowsFunctionsThatItDoesNotJudge) {
  EXPECT_TRUE(read(good).criteria[0].follows.empty());
  const std::string follows = with("partial = true", "partial = true\nfollows = [\"lowerForce\"]");
  EXPECT_EQ(read(follows).criteria[1].follows, std::vector<std::string>{"lowerForce"});
  EXPECT_EQ(complaint(with("partial = true", "partial = true\nfollows = [\"otherForce\"]")),
            "spring_1d/exercise.toml:20: key 'follows': 'otherForce' stands in functions: this criterion judges it");
  EXPECT_EQ(complaint(with("partial = true", "partial = true\nfollows = [\"3\"]")),
            "spring_1d/exercise.toml:20: key 'follows': '3' is not the name of a function");
}

TEST_F(ManifestFile, FeedbackIsOfTheFullestKindUnlessStated) {
  EXPECT_EQ(read(with("feedback = \"property\"\n", "")).feedback, FeedbackLevel::Values);
}

TEST_F(ManifestFile, SaysHowLongACallMayTake) {
  const auto seconds = [](const std::string& value) {
    return with("order = 10", "order = 10\ncall_seconds = " + value);
  };
  EXPECT_EQ(read(good).callSeconds, 2);
  EXPECT_EQ(read(seconds("15")).callSeconds, 15);
  const std::string key = "spring_1d/exercise.toml:2: key 'call_seconds': ";
  EXPECT_EQ(complaint(seconds("1")), key + "1 does not lie between 2 and 20");
  EXPECT_EQ(complaint(seconds("600")), key + "600 does not lie between 2 and 20");
  EXPECT_EQ(complaint(seconds("2.5")), key + "expected an integer, found a number");
}

TEST_F(ManifestFile, AMisspeltKeyGetsItsLineAndTheNearestName) {
  EXPECT_EQ(complaint(with("points = 2", "pionts = 2")),
            "spring_1d/exercise.toml:11: key 'pionts': unknown; did you mean 'points'?");
}

TEST_F(ManifestFile, AKeyLikeNoOtherGetsTheListOfKeys) {
  const std::string said = complaint(with("id = \"wrong_sign\"", "colour = \"red\"\nid = \"wrong_sign\""));
  EXPECT_EQ(said, "spring_1d/exercise.toml:24: key 'colour': unknown; there are id, function, says, hint");
}

TEST_F(ManifestFile, AWrongTypeSaysWhatWasExpectedAndFound) {
  EXPECT_EQ(complaint(with("points = 2", "points = \"2\"")),
            "spring_1d/exercise.toml:11: key 'points': expected a number, found a text");
  EXPECT_EQ(complaint(with("order = 10", "order = 1.5")),
            "spring_1d/exercise.toml:1: key 'order': expected an integer, found a number");
  EXPECT_EQ(complaint(with("partial = true", "partial = 1")),
            "spring_1d/exercise.toml:19: key 'partial': expected true or false, found an integer");
}

TEST_F(ManifestFile, AMissingKeyIsNamed) {
  EXPECT_EQ(complaint(with("title = \"A spring\"\n", "")),
            "spring_1d/exercise.toml:1: key 'title': missing in the manifest");
  EXPECT_EQ(complaint(with("hint = \"Look at the sign.\"\n", "")),
            "spring_1d/exercise.toml:8: key 'hint': missing in [[criterion]]");
}

TEST_F(ManifestFile, PointsMustAddUp) {
  EXPECT_EQ(complaint(with("points = 3.5", "points = 4")),
            "spring_1d/exercise.toml:3: key 'points': 4 is not the sum of the criteria's points, 3.5");
}

TEST_F(ManifestFile, SuitesAndIdsAreUnique) {
  EXPECT_EQ(complaint(with("ThirdLaw", "HookeForce")),
            "spring_1d/exercise.toml:17: key 'suite': 'HookeForce' is already that of another criterion");
  const std::string twice =
      good + "[[misconception]]\nid = \"wrong_sign\"\nfunction = \"springForce\"\nsays = \"s\"\nhint = \"h\"\n";
  EXPECT_EQ(
      complaint(twice),
      "spring_1d/exercise.toml:29: key 'id': 'wrong_sign' is already that of another misconception of that function");
}

TEST_F(ManifestFile, FilesArePlainSourceNames) {
  for (const std::string name : {"../x.cpp", "/x.cpp", "a/b.cpp", "x.h", ".cpp", "x .cpp", "-x.cpp"}) {
    EXPECT_NE(complaint(with("\"spring_1d.cpp\"", "\"" + name + "\"")).find("is not a plain file name"),
              std::string::npos)
        << name;
  }
}

TEST_F(ManifestFile, TopicsAreSafeNames) {
  EXPECT_NE(complaint(good, "Spring-1D").find("a-z, 0-9 and _ only"), std::string::npos);
}

TEST_F(ManifestFile, BrokenTomlGetsItsLine) {
  EXPECT_EQ(complaint(with("order = 10", "order = = 10")).substr(0, 26), "spring_1d/exercise.toml:1:");
}

TEST_F(ManifestFile, ControlCharactersAreRefused) {
  EXPECT_NE(complaint(with("A spring", "A\\u001b[31m spring")).find("control characters"), std::string::npos);
}

using Course = ManifestFile;

TEST_F(Course, IsInOrderAndSkipsOtherFolders) {
  read(with("order = 10", "order = 20"), "aa");
  read(good, "bb");
  std::filesystem::create_directories(folder_.path() / "no_exercise");
  const std::vector<Manifest> course = readCourse(folder_.path());
  ASSERT_EQ(course.size(), 2U);
  EXPECT_EQ(course[0].topic, "bb");
  EXPECT_EQ(course[1].topic, "aa");
}

TEST_F(Course, TwoExercisesOfOneOrderAreRefused) {
  read(good, "aa");
  read(good, "bb");
  EXPECT_THROW(readCourse(folder_.path()), std::runtime_error);
}

TEST_F(Course, AnUnknownTopicGetsTheNearest) {
  read(good, "spring_1d");
  const std::vector<Manifest> course = readCourse(folder_.path());
  EXPECT_EQ(findExercise(course, "spring_1d").topic, "spring_1d");
  try {
    findExercise(course, "sprnig_1d");
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "no exercise 'sprnig_1d'; did you mean 'spring_1d'?");
  }
}

}  // namespace
}  // namespace muelle
