/// \file
/// Files that hold others under an unusual name, and files that only stand for what is wanted.

#include "tools.h"

#include "base/file.h"
#include "grader/intake/package.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

class Packages : public ::testing::Test {
 protected:
  void pack(const std::string& name, Format format = Format::Zip) const {
    std::filesystem::create_directories((folder_.path() / name).parent_path());
    writeArchive(folder_.path() / name, format, {{"work/spring_1d.cpp", "one"}, {"triangle.cpp", "two"}});
  }
  Submission take() const { return takeSubmission(folder_.path(), smallCourse()); }
  /// What is said of spring_1d in a folder, and in an archive, that hold that file alone.
  void expectSaid(const std::string& name, const std::string& text, const std::string& line) const {
    const TemporaryFolder other;
    other.write(name, text);
    EXPECT_EQ(takeSubmission(other.path(), smallCourse()).refused.at("spring_1d"), "no spring_1d.cpp; " + line);
    writeArchive(folder_.path() / "hand-in.tar", Format::Tar, {{name, text}});
    const Submission s = takeSubmission(folder_.path() / "hand-in.tar", smallCourse());
    EXPECT_EQ(s.refused.at("spring_1d"), "no spring_1d.cpp; " + line);
    EXPECT_TRUE(isNoted(s, line));
  }

  TemporaryFolder folder_;
};

TEST_F(Packages, OfEveryKindAreTakenUnderTheirUsualName) {
  const std::vector<std::pair<const char*, Format>> kinds{
      {"ana.tar.gz", Format::TarGzip}, {"ana.tgz", Format::TarGzip},     {"ana.tar.bz2", Format::TarBzip2},
      {"ana.tar.xz", Format::TarXz},   {"ana.tar.zst", Format::TarZstd}, {"ana.tar", Format::Tar},
      {"ana.zip", Format::Zip},        {"ana.7z", Format::SevenZip}};
  for (const auto& [name, format] : kinds) {
    writeArchive(folder_.path() / name, format, {{"spring_1d.cpp", "one"}});
    EXPECT_TRUE(takeSubmission(folder_.path() / name, smallCourse()).sources.contains("spring_1d")) << name;
  }
}

TEST_F(Packages, AreKnownByTheirContentWhateverTheirName) {
  for (const char* name : {"handin", "handin.zip (1)", "Ana.hand-in", "spring_1d.cpp"}) {
    for (const Format format : {Format::Zip, Format::SevenZip, Format::Tar}) {
      const TemporaryFolder other;
      writeArchive(other.path() / name, format, {{"work/spring_1d.cpp", "one"}});
      EXPECT_TRUE(takeSubmission(other.path(), smallCourse()).sources.contains("spring_1d")) << name;
      writeArchive(folder_.path() / "outer.tar", Format::Tar, {{name, readFile(other.path() / name)}});
      EXPECT_TRUE(takeSubmission(folder_.path() / "outer.tar", smallCourse()).sources.contains("spring_1d")) << name;
    }
  }
}

TEST_F(Packages, OfTarAreKnownCompressedToo) {
  pack("handin", Format::TarGzip);
  EXPECT_EQ(take().sources.size(), 2u);
}

TEST_F(Packages, OfficeDocumentsAreNone) {
  pack("report.docx");
  folder_.write("mesh.obj.gz", "\x1f\x8b no gzip");
  EXPECT_TRUE(take().sources.empty());
  EXPECT_TRUE(isNoted(take(), "report.docx"));
}

TEST_F(Packages, ThatAreNotOpenedAreSaid) {
  const std::string line = "an archive of the kind RAR is not opened: hand in a folder, or a zip, tar or 7z archive";
  expectSaid("handin.rar", "Rar!\x1a\x07\x01 and so on", "ignored handin.rar: " + line);
  expectSaid("handin", "Rar!\x1a\x07\x01 and so on", "ignored handin: " + line);
  expectSaid("handin.zip.001", "PK",
             "ignored handin.zip.001: an archive of the kind .001 is not opened: hand in a folder, "
             "or a zip, tar or 7z archive");
}

TEST_F(Packages, PlaceholdersAreSaid) {
  const std::string line = "a placeholder: the file itself was never downloaded; download it and hand that in";
  expectSaid(".spring_1d.cpp.icloud", "bplist00", "ignored .spring_1d.cpp.icloud: " + line);
  expectSaid("spring_1d.cpp.cloud", "", "ignored spring_1d.cpp.cloud: " + line);
  expectSaid(".handin.zip.icloud", "bplist00", "ignored .handin.zip.icloud: " + line);
}

TEST_F(Packages, ShortcutsAndPartsOfDownloadsAreSaid) {
  expectSaid("spring_1d.cpp - Shortcut.lnk", "L",
             "ignored spring_1d.cpp - Shortcut.lnk: a shortcut: hand in the file itself");
  expectSaid("spring_1d.cpp.crdownload", "one",
             "ignored spring_1d.cpp.crdownload: a download that did not end: hand in the "
             "whole file");
  expectSaid("spring_1d.cpp.gz", "\x1f\x8b",
             "ignored spring_1d.cpp.gz: a compressed file alone is not opened: hand in the "
             "file itself");
}

TEST_F(Packages, OfAnotherFileSayNothingOfThisOne) {
  folder_.write(".triangle.cpp.icloud", "bplist00");
  const Submission s = take();
  EXPECT_TRUE(s.refused.contains("triangle"));
  EXPECT_EQ(s.missing.at("spring_1d"), "no spring_1d.cpp");
}

TEST_F(Packages, CostNothingBesideTheFile) {
  folder_.write("spring_1d.cpp", "one");
  folder_.write("old.rar", "Rar!\x1a\x07");
  folder_.write(".spring_1d.cpp.icloud", "bplist00");
  EXPECT_TRUE(take().sources.contains("spring_1d"));
}

}  // namespace
}  // namespace muelle::grader
