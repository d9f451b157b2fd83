/// \file
/// Archives that fail their own checksums or sizes, and archives in archives.

#include "tools.h"

#include "base/file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <fstream>

namespace muelle::grader {
namespace {

class Broken : public ::testing::Test {
 protected:
  std::filesystem::path make(const std::vector<ArchiveEntry>& entries, Format format) const {
    const auto file = folder_.path() / "hand-in";
    writeArchive(file, format, entries);
    return file;
  }
  /// The bytes of an archive, to lie in another one.
  std::string packed(const std::vector<ArchiveEntry>& entries, Format format = Format::Zip) const {
    return readFile(make(entries, format));
  }
  Submission take(const std::filesystem::path& file, const IntakeLimits& limits = {}) const {
    return takeSubmission(file, smallCourse(), limits);
  }
  /// Changes the bytes behind the last place of `mark`, `offset` bytes on.
  void damage(const std::filesystem::path& file, const std::string& mark, std::size_t offset) const {
    std::string bytes = readFile(file);
    const std::size_t place = bytes.rfind(mark);
    ASSERT_NE(place, std::string::npos);
    bytes[place + offset] = static_cast<char>(bytes[place + offset] ^ 1);
    writeFile(file, bytes);
  }
  void expectBroken(const std::filesystem::path& file, const std::string& why) const {
    const std::string line = refusal(file);
    EXPECT_NE(line.find("cannot read the archive hand-in: "), std::string::npos) << line;
    EXPECT_NE(line.find(why), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }

  TemporaryFolder folder_;
};

using BrokenArchive = Broken;
using InnerArchive = Broken;

/// A gzip file with no bytes in it: one more member.
const std::string gzipOfNothing("\x1f\x8b\x08\0\0\0\0\0\0\x03\x03\0\0\0\0\0\0\0\0\0", 20);

const std::vector<ArchiveEntry> handIn{{"notes", "nobody wants this: a text of some length"},
                                       {"spring_1d.cpp", "double f() { return 1.0; }\n"}};
class BrokenGzip : public Broken {
 protected:
  void expectTaken(const std::string& bytes) const {
    EXPECT_TRUE(take(folder_.write("hand-in", bytes)).sources.contains("spring_1d"));
  }
  void expectBrokenBytes(const std::string& bytes, const std::string& why) const {
    expectBroken(folder_.write("hand-in", bytes), why);
  }
  /// With another bit so many bytes before the end: 8 to 5 are of the checksum, 4 to 1 of the size.
  std::string damaged(std::size_t beforeEnd) const {
    std::string bytes = gzip_;
    bytes[bytes.size() - beforeEnd] = static_cast<char>(bytes[bytes.size() - beforeEnd] ^ 1);
    return bytes;
  }

  std::string gzip_ = packed(handIn, Format::TarGzip);
};

const std::string endOfCentralDirectoryEntry = "PK\x01\x02";
constexpr std::size_t crcInCentralDirectory = 16;
constexpr std::size_t sizeInCentralDirectory = 24;

TEST_F(BrokenArchive, AWrongChecksumOfAWantedFileIsFound) {
  const auto file = make(handIn, Format::Zip);
  damage(file, endOfCentralDirectoryEntry, crcInCentralDirectory);
  expectBroken(file, "");
}

TEST_F(BrokenArchive, AWrongChecksumOfAnIgnoredFileIsFound) {
  const auto file = make({handIn[1], handIn[0]}, Format::Zip);
  damage(file, endOfCentralDirectoryEntry, crcInCentralDirectory);
  expectBroken(file, "");
}

TEST_F(BrokenArchive, AWrongSizeIsFound) {
  const auto file = make(handIn, Format::Zip);
  damage(file, endOfCentralDirectoryEntry, sizeInCentralDirectory);
  expectBroken(file, "");
}

TEST_F(BrokenArchive, AChangedByteOfAStoredFileIsFound) {
  // libarchive stores what is short; Python's and Windows' zip files carry the checksum in the local header.
  const auto file = make({{"spring_1d.cpp", "AbCdEfGh"}}, Format::SevenZip);
  std::string bytes = readFile(file);
  bytes[40] = static_cast<char>(bytes[40] ^ 0x10);
  writeFile(file, bytes);
  EXPECT_NE(refusal(file).find("cannot read the archive"), std::string::npos);
}

TEST_F(BrokenArchive, AWrongChecksumOfGzipIsFound) {
  const auto file = make(handIn, Format::TarGzip);
  std::string bytes = readFile(file);
  bytes[bytes.size() - 6] = static_cast<char>(bytes[bytes.size() - 6] ^ 1);
  writeFile(file, bytes);
  expectBroken(file, "its checksum is wrong");
}

TEST_F(BrokenGzip, AWholeOnePasses) { expectTaken(gzip_); }

TEST_F(BrokenGzip, ZerosMayFollow) { expectTaken(gzip_ + std::string(512, '\0')); }

TEST_F(BrokenGzip, SeveralMembersAreOneStream) { expectTaken(gzip_ + gzipOfNothing); }

TEST_F(BrokenGzip, AWrongSizeIsFound) { expectBrokenBytes(damaged(1), "its size is wrong"); }

TEST_F(BrokenGzip, AWrongChecksumIsFoundWhateverFollows) {
  expectBrokenBytes(damaged(6) + std::string(3, '\0'), "its checksum is wrong");
  expectBrokenBytes(damaged(6) + gzipOfNothing, "its checksum is wrong");
}

TEST_F(BrokenGzip, OfALaterMemberIsFound) {
  std::string later = gzipOfNothing;
  later[later.size() - 6] = 1;
  expectBrokenBytes(gzip_ + later, "its checksum is wrong");
}

TEST_F(BrokenGzip, NothingElseMayFollow) { expectBrokenBytes(gzip_ + "rest", "something else follows its end"); }

TEST_F(BrokenGzip, ThatEndsEarlyIsFound) { expectBrokenBytes(gzip_.substr(0, gzip_.size() - 4), "it ends too early"); }

TEST_F(BrokenArchive, AnEmptyOneIsSaidInEveryExercise) {
  for (const Format format : {Format::Zip, Format::Tar, Format::TarGzip}) {
    const Submission s = take(make({}, format));
    EXPECT_EQ(s.missing.at("spring_1d"), "no spring_1d.cpp: the submission is empty");
    EXPECT_TRUE(isNoted(s, "the archive hand-in is empty"));
  }
}

TEST_F(BrokenArchive, BackslashesAreFolders) {
  const Submission s = take(make({{"work\\spring_1d\\spring_1d.cpp", "one"}}, Format::Tar));
  EXPECT_EQ(s.sources.at("spring_1d").at("spring_1d.cpp"), "one");
}

TEST_F(InnerArchive, IsOpened) {
  for (const Format format : {Format::Zip, Format::Tar}) {
    const std::string inner = packed({{"work/spring_1d/spring_1d.cpp", "one"}, {"notes", ""}}, format);
    const Submission s = take(make({{"Ana/work.zip", inner}, {"triangle.cpp", "two"}}, Format::Zip));
    EXPECT_EQ(s.sources.at("spring_1d").at("spring_1d.cpp"), "one");
    EXPECT_EQ(s.sources.at("triangle").at("triangle.cpp"), "two");
    EXPECT_TRUE(isNoted(s, "ignored in Ana/work.zip/: notes"));
  }
}

TEST_F(InnerArchive, ADeeperOneIsSaidAndIgnored) {
  const std::string deepest = packed({{"spring_1d.cpp", "one"}});
  const std::string inner = packed({{"c.zip", deepest}});
  const Submission s = take(make({{"b.zip", inner}}, Format::Zip));
  EXPECT_TRUE(s.sources.empty());
  EXPECT_TRUE(isNoted(s, "ignored b.zip/c.zip: an archive in an archive is opened, a deeper one is not"));
  EXPECT_EQ(
      s.refused.at("triangle"),
      "no triangle.cpp; ignored b.zip/c.zip: an archive in an archive is opened, a deeper one is not; hand in the "
      "folder");
}

TEST_F(InnerArchive, SharesTheLimits) {
  const std::string zeros = packed({{"zeros", std::string(20'000'000, '\0')}});
  EXPECT_NE(refusal(make({{"a.zip", zeros}, {"b.zip", zeros}}, Format::Zip)).find("unpacks to more than 32 MiB"),
            std::string::npos);
  std::vector<ArchiveEntry> many;
  for (int i = 0; i < 40; ++i) many.push_back({fmt::format("junk {}", i), ""});
  const std::string crowd = packed(many);
  many.push_back({"a.zip", crowd});
  many.push_back({"spring_1d.cpp", "one"});
  IntakeLimits limits;
  limits.entries = 60;
  const Submission s = take(make(many, Format::Tar), limits);
  EXPECT_FALSE(s.sources.contains("spring_1d"));
  EXPECT_TRUE(isNoted(s, "only the first 60 entries were looked at"));
}

/// One rule, whatever else is there: who marks by hand what was left of a hand-in cannot know what it lacks.
TEST_F(InnerArchive, ABrokenOneIsBrokenWhateverElseIsThere) {
  for (const char* text : {"no archive", "PK\x03\x04 cut"}) {
    std::vector<ArchiveEntry> entries{{"rest.zip", text}, {"spring_1d.cpp", "one"}};
    for (const bool isComplete : {false, true}) {
      if (isComplete) entries.push_back({"triangle.cpp", "two"});
      EXPECT_NE(refusal(make(entries, Format::Zip)).find("cannot read the archive rest.zip"), std::string::npos);
    }
  }
}

TEST_F(InnerArchive, ADamagedSourceInItIsRefusedInAFolderToo) {
  const auto file = folder_.path() / "ana" / "hand-in.zip";
  folder_.write("ana/triangle.cpp", "two");
  for (const char* name : {"spring_1d.cpp", "notes"}) {
    writeArchive(file, Format::Zip, {{name, "double f() { return 1.0; }\n"}});
    damage(file, endOfCentralDirectoryEntry, crcInCentralDirectory);
    EXPECT_NE(refusal(file.parent_path()).find("cannot read the archive hand-in.zip"), std::string::npos) << name;
    const std::string inner = readFile(file);
    EXPECT_NE(refusal(make({{"a/b.zip", inner}}, Format::Zip)).find("cannot read the archive a/b.zip"),
              std::string::npos);
  }
}

TEST_F(InnerArchive, ABombInItIsRefused) {
  folder_.write("ana/triangle.cpp", "two");
  writeArchive(folder_.path() / "ana" / "work.zip", Format::Zip, {{"spring_1d.cpp", std::string(40'000'000, ' ')}});
  EXPECT_NE(refusal(folder_.path() / "ana").find("the archive work.zip unpacks to more than 32 MiB"),
            std::string::npos);
}

TEST_F(InnerArchive, OfAHiddenFolderIsNobodys) {
  const Submission s =
      take(make({{".git/x.zip", "no archive"}, {"__MACOSX/y.zip", "fork"}, {"spring_1d.cpp", "one"}}, Format::Zip));
  EXPECT_TRUE(s.sources.contains("spring_1d"));
}

}  // namespace
}  // namespace muelle::grader
