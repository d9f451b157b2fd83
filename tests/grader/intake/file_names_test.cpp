#include "grader/intake/file_names.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

TEST(NearNames, AreWhatBrowsersAndSystemsMakeOfThem) {
  for (const char* name : {"spring_1d (1).cpp",
                           "spring_1d(1).cpp",
                           "spring_1d-1.cpp",
                           "spring_1d_2.cpp",
                           "spring_1d - Copy.cpp",
                           "spring_1d - Copy (2).cpp",
                           "spring_1d copy 2.cpp",
                           "spring_1d - copia.cpp",
                           "Copia de spring_1d.cpp",
                           "Copy of spring_1d.cpp",
                           "spring_1d.cc",
                           "spring_1d.cxx",
                           "spring_1d.C",
                           "spring_1d.c++",
                           "spring_1d.cpp.txt",
                           "Spring_1D.CPP",
                           "spring-1d.cpp",
                           "spring 1d.cpp",
                           " spring_1d .cpp ",
                           "spring_1d (1).cpp.txt",
                           "spring_1d.cpp (1)",
                           "spring_1d.cpp(2)",
                           "spring_1d.cpp.1",
                           "spring_1d.cpp.download",
                           "spring_1d.cpp.txt.txt",
                           "spring_1d.cpp copy",
                           "spring_1d (1).cpp.download",
                           "Ana García_123_assignsubmission_file_spring_1d.cpp"})
    EXPECT_TRUE(isNearName(name, "spring_1d.cpp")) << name;
}

TEST(NearNames, AreNoOtherFiles) {
  for (const char* name : {"spring_1d.cpp", "spring_3d.cpp", "spring.cpp", "spring_1d.h", "spring_1d.txt", "spring_1d",
                           "spring_1d.cpp.bak", "spring_1d.cpp~", "my_spring_1d.cpp", "spring_1d_100.cpp", ".cpp", ""})
    EXPECT_FALSE(isNearName(name, "spring_1d.cpp")) << name;
}

TEST(NearNames, OfATextMayBeANotes) {
  for (const char* name : {"spring_1d.txt", "Spring-1D (1).txt"})
    EXPECT_TRUE(isTextNamedAs(name, "spring_1d.cpp")) << name;
  for (const char* name : {"spring_1d.cpp.txt", "notes.txt", "spring_1d.pdf", "spring_1d"})
    EXPECT_FALSE(isTextNamedAs(name, "spring_1d.cpp")) << name;
}

TEST(NearNames, ThatAreOnlyAlikeAreAskedAbout) {
  for (const char* name : {"spring_1d.hpp", "spring_1d.cpp.bak", "spring_1d", "spring_1d.cpp~", "spring_1d.cp_"})
    EXPECT_TRUE(isNamedAlike(name, "spring_1d.cpp")) << name;
  EXPECT_FALSE(isNamedAlike("spring_1d_notes.txt", "spring_1d.cpp"));
}

TEST(NearNames, KeepTheNumberThatIsAskedFor) {
  EXPECT_TRUE(isNearName("practice_2 (1).cpp", "practice_2.cpp"));
  EXPECT_FALSE(isNearName("practice_3.cpp", "practice_2.cpp"));
}

TEST(NearNames, OfFoldersAreTheSame) {
  EXPECT_TRUE(isNearFolderName("Spring 1D (2)", "spring_1d"));
  EXPECT_FALSE(isNearFolderName("spring_3d", "spring_1d"));
  EXPECT_FALSE(isNearFolderName("spring_1d", "spring_1d"));
}

TEST(FileNames, LoseWhatStandsBehindASource) {
  EXPECT_EQ(withoutSourceSuffix("Ana.García.CPP"), "Ana.García");
  EXPECT_EQ(withoutSourceSuffix("ana.cpp.txt"), "ana");
  EXPECT_EQ(withoutSourceSuffix("ana.cpp (1)"), "ana");
}

TEST(FileNames, TellArchivesBySuffix) {
  for (const char* name : {"a.zip", "a.ZIP", "a.tar.gz", "a.tgz", "a.7z", "a b.tar"}) EXPECT_TRUE(isArchiveName(name));
  for (const char* name : {"zip", ".zip", "a.gz", "a.cpp", ""}) EXPECT_FALSE(isArchiveName(name)) << name;
  EXPECT_EQ(withoutArchiveSuffix("Hand-in.Tar.GZ"), "Hand-in");
  EXPECT_EQ(withoutArchiveSuffix("hand-in"), "hand-in");
}

}  // namespace
}  // namespace muelle::grader
