#include "course/check/handed_out.h"
#include "tools.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

class HandIn : public ::testing::Test {
 protected:
  Submission take(const std::vector<std::string>& only = {}) const {
    return takeSubmission(folder_.path(), smallCourse(), {}, only);
  }
  const std::string& spring(const Submission& s) const { return s.sources.at("spring_1d").at("spring_1d.cpp"); }

  TemporaryFolder folder_;
};

using HandInNames = HandIn;
using HandInText = HandIn;
using HandInTopics = HandIn;
using HandInHash = HandIn;

TEST_F(HandInNames, NearOnesAreTakenAndSaid) {
  folder_.write("spring_1d/spring_1d (1).cpp", "one");
  const Submission s = take();
  EXPECT_EQ(spring(s), "one");
  EXPECT_EQ(s.taken.at("spring_1d"), "spring_1d.cpp is taken from 'spring_1d/spring_1d (1).cpp'");
  EXPECT_EQ(s.notes, std::vector<std::string>{"spring_1d.cpp is taken from 'spring_1d/spring_1d (1).cpp'"});
}

TEST_F(HandInNames, TheExactOneDoesNotGoBeforeANearOneThatDiffers) {
  folder_.write("spring_1d/spring_1d (1).cpp", "near");
  folder_.write("a/b/spring_1d.cpp", "exact");
  const Submission s = take();
  EXPECT_TRUE(s.sources.empty());
  EXPECT_EQ(s.refused.at("spring_1d"),
            "spring_1d.cpp is there 2 times, and 'a/b/spring_1d.cpp' and 'spring_1d/spring_1d (1).cpp' differ: hand in "
            "one, named spring_1d.cpp");
}

class HandInStubs : public HandIn {
 protected:
  Submission take() const {
    return takeSubmission(folder_.path(), smallCourse(), {}, {},
                          {{"spring_1d", {{"spring_1d.cpp", "// yours\n{}\n"}}}});
  }
};

TEST_F(HandInStubs, DoNotCountBesideAnother) {
  folder_.write("spring_1d.cpp", "\xef\xbb\xbf// yours\r\n{}");
  folder_.write("old/spring_1d/spring_1d.cpp", "// yours\n{}\n");
  folder_.write("spring_1d (1).cpp", "one");
  const Submission s = take();
  EXPECT_EQ(spring(s), "one");
  EXPECT_EQ(s.taken.at("spring_1d"),
            "spring_1d.cpp is taken from 'spring_1d (1).cpp', since 'old/spring_1d/spring_1d.cpp' is the stub as "
            "handed out");
}

TEST_F(HandInStubs, CountAlone) {
  folder_.write("a/spring_1d.cpp", "// yours\n{}\n");
  folder_.write("b/spring_1d.cpp", "// yours\r\n{}\r\n");
  EXPECT_EQ(spring(take()), "// yours\n{}\n");
}

TEST_F(HandInStubs, DoNotHideThatTwoOthersDiffer) {
  folder_.write("spring_1d.cpp", "// yours\n{}\n");
  folder_.write("a/spring_1d.cpp", "one");
  folder_.write("b/spring_1d.cpp", "two");
  EXPECT_NE(take().refused.at("spring_1d").find("'a/spring_1d.cpp' and 'b/spring_1d.cpp' differ"), std::string::npos);
}

TEST_F(HandInNames, AContractIsNotTakenButItsHashIs) {
  folder_.write("spring_1d/spring_1d.cpp", "one");
  folder_.write("spring_1d/spring_1d.h", "double f();\r\n");
  const Submission s = take();
  EXPECT_EQ(s.contracts.at("spring_1d"), std::set<std::uint64_t>{handedOutHash("double f();\n")});
  EXPECT_FALSE(s.contracts.contains("triangle"));
}

TEST_F(HandInNames, TwoNearOnesThatDifferAreBothNamed) {
  folder_.write("spring_1d (1).cpp", "one");
  folder_.write("spring_1d (2).cpp", "two");
  folder_.write("spring_1d (3).cpp", "one");
  const Submission s = take();
  EXPECT_FALSE(s.sources.contains("spring_1d"));
  EXPECT_EQ(s.refused.at("spring_1d"),
            "no spring_1d.cpp, and 'spring_1d (1).cpp' and 'spring_1d (2).cpp' differ: hand in one, named "
            "spring_1d.cpp");
}

TEST_F(HandInNames, EqualOnesCountOnce) {
  folder_.write("spring_1d (1).cpp", "one");
  folder_.write("spring_1d.cc", "one");
  folder_.write("a/triangle.cpp", "two");
  folder_.write("b/triangle.cpp", "two");
  const Submission s = take();
  EXPECT_EQ(spring(s), "one");
  EXPECT_EQ(s.taken.at("spring_1d"), "spring_1d.cpp is taken from 'spring_1d (1).cpp'; is there 2 times, all equal");
  EXPECT_EQ(s.sources.at("triangle").at("triangle.cpp"), "two");
  EXPECT_EQ(s.taken.at("triangle"), "triangle.cpp is there 2 times, all equal");
}

TEST_F(HandInNames, ATextIsTakenWhereThereIsNothingElse) {
  folder_.write("spring_1d.txt", "one");
  EXPECT_EQ(take().taken.at("spring_1d"), "spring_1d.cpp is taken from 'spring_1d.txt'");
  folder_.write("work/spring_1d.cpp", "two");
  EXPECT_EQ(spring(take()), "two");
  EXPECT_TRUE(isNoted(take(), "ignored: spring_1d.txt (another one counts)"));
}

TEST_F(HandInNames, OfAnotherExercisesFolderAreNotTaken) {
  folder_.write("Triangle (1)/spring_1d (1).cpp", "misplaced");
  EXPECT_TRUE(take().sources.empty());
}

TEST_F(HandInNames, AreThoseOfFoldersToo) {
  folder_.write("Spring 1D/spring_1d.cpp", "one");
  folder_.write("triangle (1)/triangle (1).cpp", "two");
  EXPECT_EQ(take().sources.size(), 2u);
}

TEST_F(HandInNames, ALinkWithANearNameIsRefused) {
  std::filesystem::create_symlink("/etc/passwd", folder_.path() / "spring_1d (1).cpp");
  EXPECT_EQ(take().refused.at("spring_1d"), "spring_1d (1).cpp is a symbolic link");
}

TEST_F(HandInTopics, NothingIsSaidOfWhatBelongsToOthers) {
  folder_.write("spring_1d/spring_1d.cpp", "one");
  folder_.write("spring_1d/notes.txt", "mine");
  folder_.write("spring_1d/spring_1d.h", "handed out");
  for (const char* file : {"triangle/triangle.cpp", "triangle/notes.txt", "triangle/build/log.txt",
                           "triangle/draft.cpp", "triangle/triangle.h", "triangle/README.md", "triangle.h"}) {
    folder_.write(file, "of another exercise");
  }
  EXPECT_EQ(take({"spring_1d"}).notes,
            (std::vector<std::string>{"ignored in spring_1d/: notes.txt",
                                      "ignored 1 file that the course hands out; its own are used"}));
  EXPECT_GT(take().notes.size(), 2U) << "who asks for all is told of all";
}

TEST_F(HandInTopics, AskAboutTheFileInTheirFolder) {
  folder_.write("spring_1d/resorte.cpp", "one");
  folder_.write("spring_1d/demo.cpp", "as handed out");
  folder_.write("main.cpp", "other");
  folder_.write("triangle.cpp", "two");
  const Submission s = take();
  EXPECT_EQ(s.missing,
            (std::map<std::string, std::string>{{"spring_1d", "no spring_1d.cpp; is 'spring_1d/resorte.cpp' meant?"}}));
}

TEST_F(HandInTopics, AskAboutANameSpelledAlike) {
  folder_.write("sprng_1d.cpp", "one");
  folder_.write("triangel.cpp", "two");
  const Submission s = take();
  EXPECT_EQ(s.missing.at("spring_1d"), "no spring_1d.cpp; is 'sprng_1d.cpp' meant?");
  EXPECT_EQ(s.missing.at("triangle"), "no triangle.cpp; is 'triangel.cpp' meant?");
}

TEST_F(HandInTopics, AskAboutAnotherSuffix) {
  folder_.write("spring_1d.hpp", "one");
  folder_.write("triangle.cpp.bak", "two");
  folder_.write("triangle.h", "as handed out");
  const Submission s = take();
  EXPECT_EQ(s.missing.at("spring_1d"), "no spring_1d.cpp; is 'spring_1d.hpp' meant?");
  EXPECT_EQ(s.missing.at("triangle"), "no triangle.cpp; is 'triangle.cpp.bak' meant?");
}

TEST_F(HandInTopics, SayThatTheirFileLiesInAHiddenFolder) {
  writeArchive(folder_.path() / "a.zip", Format::Zip, {{".work/spring_1d.cpp", "one"}});
  EXPECT_EQ(take().refused.at("spring_1d"),
            "no spring_1d.cpp; ignored a.zip/.work/spring_1d.cpp: it lies in a hidden folder");
}

TEST_F(HandInTopics, AskAboutTheExactNameInTheWrongFolder) {
  folder_.write("triangle/spring_1d.cpp", "misplaced");
  EXPECT_EQ(take().missing.at("spring_1d"), "no spring_1d.cpp; is 'triangle/spring_1d.cpp' meant?");
}

TEST_F(HandInTopics, AskAboutTheFewSourcesThatThereAre) {
  folder_.write("resorte.cpp", "one");
  folder_.write("otro.cpp", "two");
  EXPECT_EQ(take().missing.at("spring_1d"), "no spring_1d.cpp; is one of 'otro.cpp', 'resorte.cpp' meant?");
}

TEST_F(HandInTopics, SayNothingOfACrowd) {
  for (int i = 0; i < 400; ++i) folder_.write(fmt::format("junk {:03}.cpp", 100 + i), "");
  const Submission s = take();
  EXPECT_EQ(s.missing.at("triangle"), "no triangle.cpp");
  EXPECT_EQ(s.notes, std::vector<std::string>{
                         "ignored 400 other files: junk 100.cpp, junk 101.cpp, junk 102.cpp, junk 103.cpp, ..."});
}

TEST_F(HandInTopics, OfNothingSayThatItIsEmpty) {
  EXPECT_EQ(take().missing.at("triangle"), "no triangle.cpp: the submission is empty");
}

TEST_F(HandInTopics, NotAskedForAreNotSpokenOf) {
  folder_.write("spring_1d.cpp", "one");
  folder_.write("spring_1d (1).cpp", "one");
  folder_.write("triangle (1).cpp", "two");
  folder_.write("triangle (2).cpp", "three");
  folder_.write("old/triangle.cpp", "four");
  const Submission s = take({"spring_1d"});
  EXPECT_EQ(s.sources.size(), 1u);
  EXPECT_TRUE(s.refused.empty());
  EXPECT_TRUE(s.missing.empty());
  EXPECT_EQ(s.notes, std::vector<std::string>{"spring_1d.cpp is there 2 times, all equal"});
}

TEST_F(HandInText, OfUtf16IsConvertedAndSaid) {
  folder_.write("spring_1d.cpp", std::string("\xff\xfe"
                                             "a\0;\0",
                                             6));
  const Submission s = take();
  EXPECT_EQ(spring(s), "a;");
  EXPECT_EQ(s.taken.at("spring_1d"), "spring_1d.cpp converted from UTF-16");
}

TEST_F(HandInText, ThatIsNoneIsRefused) {
  folder_.write("spring_1d.cpp", std::string("\x7f"
                                             "ELF\0\1",
                                             6));
  EXPECT_EQ(take().refused.at("spring_1d"), "spring_1d.cpp is no text: byte 5 is NUL; save it as UTF-8");
}

TEST_F(HandInText, MayNotGrowBeyondTheLimit) {
  std::string bytes = "\xff\xfe";
  for (int i = 0; i < 100'000; ++i) bytes += "\xac\x20";  // the euro sign: three bytes of UTF-8
  folder_.write("spring_1d.cpp", bytes);
  EXPECT_EQ(take().refused.at("spring_1d"), "spring_1d.cpp is larger than 256 KiB");
}

TEST_F(HandInHash, IsOfTheFilesThatCountAlone) {
  folder_.write("spring_1d.cpp", "one");
  const std::string hash = take().hash;
  EXPECT_EQ(hash.size(), 64u);
  folder_.write("junk", "");
  EXPECT_EQ(take().hash, hash);
  folder_.write("triangle.cpp", "two");
  EXPECT_NE(take().hash, hash);
  EXPECT_EQ(take({"spring_1d"}).hash, hash);
  folder_.write("spring_1d.cpp", "One");
  EXPECT_NE(take({"spring_1d"}).hash, hash);
}

}  // namespace
}  // namespace muelle::grader
