#include "grader/intake/class_folder.h"
#include "grader/intake/looks_like_a_class.h"

#include "tools.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

class ClassFolders : public ::testing::Test {
 protected:
  std::vector<std::string> students() const {
    std::vector<std::string> names;
    for (const ClassEntry& entry : listClass(folder_.path()).entries) names.push_back(entry.student);
    return names;
  }
  std::string whyAClass() const { return looksLikeAClass(folder_.path(), smallCourse()).value_or(""); }
  std::string hint(const std::string& what) const {
    return fmt::format("holds {}; to grade each as a submission: ./muelle grade --class {}", what,
                       folder_.path().string());
  }

  TemporaryFolder folder_;
};

using ClassListing = ClassFolders;
using ClassHint = ClassFolders;

TEST(StudentName, IsTheChildsName) {
  EXPECT_EQ(studentOf("Ana García_12345_assignsubmission_file_"), "Ana García (12345)");
  EXPECT_EQ(studentOf("Ana_de_la_Cruz_7_assignsubmission_file"), "Ana_de_la_Cruz (7)");
  EXPECT_EQ(studentOf("Ana_7_assignsubmission_file_work.zip"), "Ana (7)");
  EXPECT_EQ(studentOf("submission_12345"), "submission_12345");
  EXPECT_EQ(studentOf("ana.tar.gz"), "ana");
  EXPECT_EQ(studentOf("ana.garcia"), "ana.garcia");
  EXPECT_EQ(studentOf("ana.cpp"), "ana");
  EXPECT_EQ(studentOf("ana.cpp.txt"), "ana");
  EXPECT_EQ(studentOf("a\nb\x1b[2J"), "a\\nb\\x1b[2J");
  EXPECT_EQ(studentOf("x_assignsubmission_file_"), "x_assignsubmission_file_");
}

TEST_F(ClassListing, TakesEveryChildOnceInOrder) {
  folder_.write("zoe/spring_1d.cpp", "");
  folder_.write("luis.zip", "");
  folder_.write("Ana García_12345_assignsubmission_file_/spring_1d.cpp", "");
  folder_.write("eva.cpp", "");
  folder_.write("old.rar", "");
  EXPECT_EQ(students(), (std::vector<std::string>{"Ana García (12345)", "eva", "luis", "old.rar", "zoe"}));
  EXPECT_EQ(listClass(folder_.path()).entries[4].parts.front(), folder_.path() / "zoe");
}

TEST_F(ClassListing, NotesWhatIsNoSubmission) {
  folder_.write("grades.csv", "");
  folder_.write("list.XLSX", "");
  folder_.write("assignment.pdf", "");
  folder_.write(".DS_Store", "");
  folder_.write("._Ana", "fork");
  folder_.write(".bo/spring_1d.cpp", "one");
  folder_.write("Ana_7_assignsubmission_onlinetext_/onlinetext.html", "");
  folder_.write("Ana_7_assignsubmission_file_report.pdf", "");
  std::filesystem::create_symlink("/etc/passwd", folder_.path() / "link");
  const ClassFolder listing = listClass(folder_.path());
  EXPECT_EQ(students(), std::vector<std::string>{"Ana (7)"});
  EXPECT_EQ(listing.notes,
            (std::vector<std::string>{
                ".bo is not graded: hidden", "Ana_7_assignsubmission_onlinetext_ is not graded: a text typed online",
                "assignment.pdf is not graded: no submission", "grades.csv is not graded: no submission",
                "link is not graded: a symbolic link", "list.XLSX is not graded: no submission"}));
}

TEST_F(ClassListing, RefusesALinkThatMayBeMeant) {
  folder_.write("ana.cpp", "");
  std::filesystem::create_symlink("/etc", folder_.path() / "Bo_2_assignsubmission_file_");
  std::filesystem::create_symlink("/etc", folder_.path() / "eva");
  std::filesystem::create_symlink("ana.cpp", folder_.path() / "luis.zip");
  ASSERT_EQ(students(), (std::vector<std::string>{"Bo (2)", "ana", "eva", "luis"}));
  for (const ClassEntry& entry : listClass(folder_.path()).entries) {
    EXPECT_EQ(entry.refusal.find("is a symbolic link") != std::string::npos, entry.student != "ana") << entry.student;
  }
}

TEST_F(ClassListing, NotesStrayTextsAndPictures) {
  folder_.write("ana/spring_1d.cpp", "");
  folder_.write("README", "what this folder is");
  folder_.write("Makefile", "all:");
  folder_.write("foto.png", "\x89PNG");
  EXPECT_EQ(students(), std::vector<std::string>{"ana"});
  EXPECT_EQ(listClass(folder_.path()).notes,
            (std::vector<std::string>{"Makefile is not graded: no submission", "README is not graded: no submission",
                                      "foto.png is not graded: no submission"}));
}

TEST_F(ClassListing, ABrokenArchiveOfAStrangeNameIsASubmission) {
  folder_.write("ana", std::string("PK\x03\x04 cut"));
  folder_.write("bo.zip (1)", std::string("cut\0\x01", 5));
  folder_.write("cy", "Rar!\x1a\x07");
  folder_.write(".di.zip.icloud", "bplist00");
  EXPECT_EQ(students(), (std::vector<std::string>{".di.zip.icloud", "ana", "bo.zip (1)", "cy"}));
  EXPECT_NE(refusal(folder_.path() / ".di.zip.icloud").find("a placeholder"), std::string::npos);
  EXPECT_NE(refusal(folder_.path() / "cy").find("an archive of the kind RAR is not opened"), std::string::npos);
}

TEST_F(ClassListing, JoinsWhatMoodleGivesSideBySide) {
  folder_.write("Ana Ruiz_101_assignsubmission_file_spring_1d.cpp", "one");
  writeArchive(folder_.path() / "Ana Ruiz_101_assignsubmission_file_work.zip", Format::Zip, {{"triangle.cpp", "two"}});
  folder_.write("Ana Ruiz_101_assignsubmission_file_report.pdf", "%PDF");
  folder_.write("Ana Ruiz_102_assignsubmission_file_spring_1d.cpp", "another Ana's");
  ASSERT_EQ(students(), (std::vector<std::string>{"Ana Ruiz (101)", "Ana Ruiz (102)"}));
  const std::vector<ClassEntry> entries = listClass(folder_.path()).entries;
  const Submission s = takeSubmission(entries[0].parts, smallCourse());
  EXPECT_EQ(s.sources.at("spring_1d").at("spring_1d.cpp"), "one");
  EXPECT_EQ(s.sources.at("triangle").at("triangle.cpp"), "two");
  EXPECT_TRUE(isNoted(s, "report.pdf"));
  EXPECT_EQ(entries[1].parts.size(), 1u);
}

TEST_F(ClassListing, KeepsNamesakesApart) {
  folder_.write("ana.zip", "");
  folder_.write("ana/spring_1d.cpp", "");
  folder_.write("b\x1b/spring_1d.cpp", "");
  folder_.write("b\\x1b/spring_1d.cpp", "");
  EXPECT_EQ(students(),
            (std::vector<std::string>{"ana [ana.zip]", "ana [ana]", "b\\x1b [b\\x1b]", "b\\x1b [b\\x1b] #2"}));
}

TEST_F(ClassListing, OfNoFolderIsOneLine) {
  try {
    listClass(folder_.path() / "nobody\n");
    FAIL() << "was read";
  } catch (const std::runtime_error& error) {
    const std::string line = error.what();
    EXPECT_NE(line.find("nobody\\n: No such file"), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

TEST_F(ClassHint, IsGivenForArchives) {
  for (int i = 0; i < 28; ++i) folder_.write(fmt::format("student {}.zip", i), "");
  EXPECT_EQ(whyAClass(), hint("28 archives"));
}

TEST_F(ClassHint, IsGivenForHandIns) {
  folder_.write("ana/spring_1d.cpp", "one");
  folder_.write("luis/exercises/spring_1d/spring_1d (1).cpp", "two");
  folder_.write("grades.csv", "");
  EXPECT_EQ(whyAClass(), hint("2 hand-ins"));
}

TEST_F(ClassHint, IsGivenForServersFolders) {
  folder_.write("submission_1/spring_1d.cpp", "");
  folder_.write("submission_2/work.txt", "");
  EXPECT_EQ(whyAClass(), hint("2 hand-ins"));
}

TEST_F(ClassHint, IsGivenForMoodlesFlatFiles) {
  folder_.write("Ana_7_assignsubmission_file_spring_1d.cpp", "");
  folder_.write("Luis_8_assignsubmission_file_spring_1d.cpp", "");
  EXPECT_EQ(whyAClass(), hint("2 hand-ins"));
}

TEST_F(ClassHint, IsNotGivenForOneStudentsFlatFiles) {
  folder_.write("Ana_7_assignsubmission_file_spring_1d.cpp", "");
  folder_.write("Ana_7_assignsubmission_file_triangle.cpp", "");
  EXPECT_EQ(whyAClass(), "");
}

TEST_F(ClassHint, IsGivenForNumbersBehindAnExercisesName) {
  for (int i = 1; i <= 3; ++i) folder_.write(fmt::format("triangle-{}/triangle.cpp", i), fmt::format("{}", i));
  EXPECT_EQ(whyAClass(), hint("3 hand-ins"));
}

TEST_F(ClassHint, IsGivenForNumberedArchives) {
  for (int i = 1; i <= 3; ++i) folder_.write(fmt::format("triangle-{}.zip", i), "");
  EXPECT_EQ(whyAClass(), hint("3 archives"));
}

TEST_F(ClassHint, IsNotGivenForCopiesOfAnExercisesFolder) {
  folder_.write("spring_1d (1)/spring_1d.cpp", "one");
  folder_.write("spring_1d (2)/spring_1d.cpp", "one");
  EXPECT_EQ(whyAClass(), "");
}

/// As a server packs a class: in a folder or without, hand-ins as folders or as archives.
TEST_F(ClassHint, IsANoteOnAnArchiveOfAClass) {
  using Files = std::vector<ArchiveEntry>;
  const auto noteOn = [this](const Files& files) {
    writeArchive(folder_.path() / "a.zip", Format::Zip, files);
    return archiveOfAClass(takeSubmission(folder_.path() / "a.zip", smallCourse()).archived, smallCourse())
        .value_or("");
  };
  const std::string advice = "if that is a class, unpack it and type ./muelle grade --class FOLDER";
  EXPECT_EQ(noteOn({{"ana/spring_1d.cpp", "1"}, {"ben/spring_1d/spring_1d.cpp", "2"}, {"cid/triangle.cpp", "3"}}),
            "the archive holds 2 hand-ins: " + advice);
  EXPECT_EQ(noteOn({{"class/Ana_7_assignsubmission_file_/x.cpp", "1"}, {"class/Bo_8_assignsubmission_file_/y", "2"}}),
            "the archive holds 2 hand-ins: " + advice);
  EXPECT_EQ(noteOn({{"spring_1d/spring_1d.cpp", "1"}, {"triangle/triangle.cpp", "2"}}), "");
  EXPECT_EQ(noteOn({{"work/spring_1d/spring_1d.cpp", "1"}, {"work/triangle/triangle.cpp", "2"}}), "");
  EXPECT_EQ(noteOn({{"week 1/spring_1d.cpp", "1"}, {"week 2/triangle.cpp", "2"}}), "");
  EXPECT_EQ(noteOn({{"spring_1d.cpp", "1"}, {"old/spring_1d.cpp", "1"}, {"older/spring_1d.cpp", "1"}}), "");
  EXPECT_EQ(noteOn({{"exercises/spring_1d/spring_1d.cpp", "1"}, {"exercises/triangle/triangle.cpp", "2"}}), "");
}

TEST_F(ClassHint, IsNotGivenForOneHandIn) {
  folder_.write("spring_1d/spring_1d.cpp", "");
  folder_.write("triangle/triangle.cpp", "");
  folder_.write("v1/spring_1d.cpp", "");
  folder_.write("v2/spring_1d.cpp", "");
  folder_.write("a.zip", "");
  folder_.write("b.zip", "");
  EXPECT_EQ(whyAClass(), "");
}

TEST_F(ClassHint, IsNotGivenForOneHandInSpreadOverFolders) {
  folder_.write("week 1/spring_1d.cpp", "");
  folder_.write("week 2/triangle.cpp", "");
  EXPECT_EQ(whyAClass(), "");
}

TEST_F(ClassHint, IsNotGivenForAnArchiveAnExercise) {
  folder_.write("spring_1d.zip", "");
  folder_.write("triangle.zip", "");
  EXPECT_EQ(whyAClass(), "");
}

TEST_F(ClassHint, IsNotGivenForACheckout) {
  for (const char* room : {"exercises", "solutions", "tests/hidden"})
    folder_.write(std::string(room) + "/spring_1d/spring_1d.cpp", "");
  EXPECT_EQ(whyAClass(), "");
  folder_.write("submission.cpp", "");
  EXPECT_FALSE(looksLikeAClass(folder_.path() / "submission.cpp", smallCourse()).has_value());
}

}  // namespace
}  // namespace muelle::grader
