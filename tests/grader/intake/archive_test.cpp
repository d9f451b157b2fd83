#include "tools.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <chrono>
#include <fstream>
#include <iterator>

namespace muelle::grader {
namespace {

class Archive : public ::testing::Test {
 protected:
  std::filesystem::path make(const std::vector<ArchiveEntry>& entries, Format format = Format::Tar) const {
    const auto file = folder_.path() / "hand-in";
    writeArchive(file, format, entries);
    return file;
  }
  Submission take(const std::vector<ArchiveEntry>& entries, Format format = Format::Tar) const {
    return takeSubmission(make(entries, format), smallCourse());
  }

  TemporaryFolder folder_;
};

using Named = std::pair<const char*, Format>;

class ArchiveFormats : public Archive, public ::testing::WithParamInterface<Named> {};
using ArchivePaths = Archive;
using ArchiveLinks = Archive;
using ArchiveBombs = Archive;
using ArchiveFaults = Archive;

TEST_P(ArchiveFormats, GiveTheSameText) {
  const std::string text = "double f() { return 1.0; }\n" + std::string(100'000, '/');
  const Submission s = take({{"exercises/spring_1d/spring_1d.cpp", text},
                             {"exercises/spring_1d/notes.txt", "hello"},
                             {"exercises/triangle/triangle.cpp", "two"}},
                            GetParam().second);
  EXPECT_EQ(s.sources.at("spring_1d").at("spring_1d.cpp"), text);
  EXPECT_EQ(s.sources.at("triangle").at("triangle.cpp"), "two");
  EXPECT_EQ(s.notes, std::vector<std::string>{"ignored in exercises/spring_1d/: notes.txt"});
  EXPECT_EQ(s.name, "hand-in");
}

TEST_P(ArchiveFormats, StopAtTheLimitOfUnpackedBytes) {
  // 40 MB of zeros take a few kB packed; the limit is 32 MiB.
  const auto file = make({{"zeros", std::string(40'000'000, '\0')}, {"spring_1d.cpp", "one"}}, GetParam().second);
  if (std::filesystem::file_size(file) < 32 * 1024 * 1024) {
    EXPECT_NE(refusal(file).find("unpacks to more than 32 MiB"), std::string::npos);
  } else {
    EXPECT_NE(refusal(file).find("is larger than 32 MiB"), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(All, ArchiveFormats,
                         ::testing::Values(Named{"Zip", Format::Zip}, Named{"Tar", Format::Tar},
                                           Named{"TarGzip", Format::TarGzip}, Named{"TarBzip2", Format::TarBzip2},
                                           Named{"TarXz", Format::TarXz}, Named{"TarZstd", Format::TarZstd},
                                           Named{"SevenZip", Format::SevenZip}),
                         [](const auto& test) { return test.param.first; });

TEST_F(ArchivePaths, ThatLeadOutsideAreIgnored) {
  for (const Format format : {Format::Tar, Format::Zip}) {
    const Submission s = take({{"../spring_1d.cpp", "up"},
                               {"a/../../spring_1d/spring_1d.cpp", "up"},
                               {"/spring_1d/spring_1d.cpp", "absolute"},
                               {"./triangle/./triangle.cpp", "fine"}},
                              format);
    EXPECT_FALSE(s.sources.contains("spring_1d"));
    EXPECT_EQ(s.sources.at("triangle").at("triangle.cpp"), "fine");
    EXPECT_TRUE(isNoted(s, "ignored ../spring_1d.cpp: it leads out of the submission"));
    EXPECT_TRUE(isNoted(s, "ignored /spring_1d/spring_1d.cpp: an absolute path"));
    EXPECT_NE(s.refused.at("spring_1d").find("no spring_1d.cpp; ignored ../spring_1d.cpp: it leads out"),
              std::string::npos);
  }
}

TEST_F(ArchivePaths, ThatAllLeadOutsideAreNotCalledEmpty) {
  const Submission s = take({{"/notes", "absolute"}});
  EXPECT_NE(s.refused.at("spring_1d").find("all that was handed in is passed over; ignored /notes: an absolute"),
            std::string::npos);
}

TEST_F(ArchivePaths, OfOneNameTwiceAreRefused) {
  for (const Format format : {Format::Tar, Format::Zip, Format::TarGzip}) {
    const Submission s = take({{"spring_1d/spring_1d.cpp", "one"}, {"spring_1d/spring_1d.cpp", "two"}}, format);
    EXPECT_TRUE(s.sources.empty());
    EXPECT_NE(s.refused.at("spring_1d").find("is there 2 times"), std::string::npos);
  }
}

TEST_F(ArchivePaths, OfOneNameSpelledDifferentlyAreRefused) {
  EXPECT_TRUE(take({{"spring_1d.cpp", "one"}, {".//spring_1d.cpp", "two"}}).refused.contains("spring_1d"));
}

TEST_F(ArchivePaths, MayHaveNamesInUtf8) {
  for (const Format format : {Format::Tar, Format::Zip, Format::SevenZip}) {
    const Submission s = take({{"José Núñez/triangle/triangle.cpp", "two"}, {"José Núñez/año.txt", ""}}, format);
    EXPECT_EQ(s.sources.at("triangle").at("triangle.cpp"), "two");
    ASSERT_EQ(s.notes.size(), 1u);
    EXPECT_EQ(s.notes[0], "ignored in José Núñez/: año.txt") << static_cast<int>(format);
  }
}

TEST_F(ArchivePaths, WithEscapesAndLineBreaksAreMadePrintable) {
  const Submission s = take({{"a\nb\x1b[2J.txt", ""}, {"<script>alert(1)</script>", ""}});
  for (const std::string& note : s.notes) {
    EXPECT_EQ(note.find('\n'), std::string::npos);
    EXPECT_EQ(note.find('\x1b'), std::string::npos);
  }
  EXPECT_TRUE(isNoted(s, "a\\nb\\x1b[2J.txt"));
}

TEST_F(ArchivePaths, ThatAreEndlessAreIgnored) {
  std::string name;
  for (int i = 0; i < 500; ++i) name += "d/";
  EXPECT_TRUE(isNoted(take({{name + "spring_1d.cpp", "deep"}}), "too deep"));
}

TEST_F(ArchiveLinks, AreRefused) {
  const Submission s = take({{"spring_1d/spring_1d.cpp", "", S_IFLNK, "/etc/passwd"},
                             {"triangle/triangle.cpp", "", S_IFREG, "", "/etc/passwd"}});
  EXPECT_TRUE(s.sources.empty());
  EXPECT_EQ(s.refused.at("spring_1d"), "spring_1d/spring_1d.cpp is a symbolic link");
  EXPECT_EQ(s.refused.at("triangle"),
            "triangle/triangle.cpp is a hard link to what the archive does not hold: hand in the file itself");
}

/// tar writes a file that has two names once, and its second name as a hard link to the first.
TEST_F(ArchiveLinks, HardOnesToWhatTheArchiveHoldsAreThat) {
  const Submission s = take({{"triangle/real.cpp", "two"},
                             {"triangle/triangle.cpp", "", S_IFREG, "", "triangle/real.cpp"},
                             {"spring_1d.cpp", "", S_IFREG, "", "triangle/triangle.cpp"}});
  EXPECT_EQ(s.sources.at("triangle").at("triangle.cpp"), "two");
  EXPECT_EQ(s.sources.at("spring_1d").at("spring_1d.cpp"), "two");
}

TEST_F(ArchiveLinks, InAZipAreRefused) {
  const Submission s = take({{"spring_1d.cpp", "", S_IFLNK, "/etc/passwd"}}, Format::Zip);
  EXPECT_EQ(s.refused.at("spring_1d"), "spring_1d.cpp is a symbolic link");
}

TEST_F(ArchiveLinks, AreNotWrittenThrough) {
  const TemporaryFolder outside;
  take({{"spring_1d", "", S_IFLNK, outside.path().string()}, {"spring_1d/spring_1d.cpp", "through"}});
  EXPECT_TRUE(std::filesystem::is_empty(outside.path()));
}

TEST_F(ArchiveLinks, PipesAndDevicesAreRefused) {
  const Submission s = take({{"spring_1d.cpp", "", S_IFIFO}, {"triangle.cpp", "", S_IFCHR}});
  EXPECT_EQ(s.refused.at("spring_1d"), "spring_1d.cpp is a named pipe");
  EXPECT_EQ(s.refused.at("triangle"), "triangle.cpp is a device");
}

TEST_F(ArchiveBombs, ALargeSourceIsRefusedAlone) {
  const Submission s = take({{"spring_1d.cpp", std::string(300'000, ' ')}, {"triangle.cpp", "two"}}, Format::Zip);
  EXPECT_EQ(s.refused.at("spring_1d"), "spring_1d.cpp is larger than 256 KiB");
  EXPECT_TRUE(s.sources.contains("triangle"));
}

TEST_F(ArchiveBombs, EntriesBeyondTheLimitAreNotLookedAt) {
  std::vector<ArchiveEntry> entries{{"spring_1d.cpp", "one"}};
  for (int i = 0; i < 20'000; ++i) entries.push_back({fmt::format("junk/{}", i), ""});
  entries.push_back({"triangle.cpp", "two"});
  for (const Format format : {Format::TarGzip, Format::Zip}) {
    const auto start = std::chrono::steady_clock::now();
    const Submission s = take(entries, format);
    EXPECT_TRUE(s.sources.contains("spring_1d"));
    EXPECT_FALSE(s.sources.contains("triangle"));
    EXPECT_EQ(s.refused.at("triangle"),
              "no triangle.cpp; only the first 10000 entries were looked at: hand in the exercises alone");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  }
}

TEST_F(ArchiveBombs, ACompressedArchiveIsNotUnpackedTwice) {
  // A gzip file within a gzip file: only the outer layer is taken off, and what is inside is no tar archive.
  const auto once = make({{"spring_1d.cpp", "one"}}, Format::TarGzip);
  std::ifstream in(once, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  const Submission s = take({{"spring_1d.cpp", "one"}}, Format::TarGzip);
  EXPECT_TRUE(s.sources.contains("spring_1d"));
  const auto twice = folder_.path() / "twice.tar.gz.gz";
  ASSERT_EQ(std::system(fmt::format("gzip -c '{}' > '{}'", once.string(), twice.string()).c_str()), 0);
  EXPECT_NE(refusal(twice).find("cannot read the archive"), std::string::npos);
}

TEST_F(ArchiveBombs, TheArchiveItselfHasALimit) {
  IntakeLimits limits;
  limits.archiveBytes = 1000;
  const auto file = make({{"spring_1d.cpp", "one"}});
  EXPECT_NE(refusal(file, limits).find("is larger than 1000 bytes"), std::string::npos);
}

TEST_F(ArchiveFaults, EncryptionIsSaid) {
  const auto file = make({{"spring_1d.cpp", "one"}}, Format::EncryptedZip);
  EXPECT_EQ(refusal(file), "the archive hand-in is encrypted: make it again without a password");
}

TEST_F(ArchiveFaults, ATruncatedArchiveIsOneLine) {
  for (const Format format : {Format::Tar, Format::TarGzip, Format::TarXz, Format::Zip, Format::SevenZip}) {
    std::string noise;
    for (unsigned i = 0, x = 1; i < 100'000; ++i) noise += static_cast<char>((x = x * 1664525u + 1013904223u) >> 24);
    const auto file = make({{"notes", noise}, {"spring_1d.cpp", "one"}}, format);
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    const std::string line = refusal(file);
    EXPECT_NE(line.find("cannot read the archive hand-in"), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

TEST_F(ArchiveFaults, OtherFilesAreNoArchive) {
  for (const std::string& text :
       {std::string(), std::string("int main() {}\n"), std::string("#mtree\na type=file contents=/etc/passwd\n"),
        std::string("\x1f\x8b rest"), std::string(5000, '\xff')}) {
    const std::string line = refusal(folder_.write("some.zip", text));
    EXPECT_NE(line.find("cannot read the archive some.zip"), std::string::npos) << line;
  }
}

TEST_F(ArchiveFaults, ADeviceIsNoArchive) {
  EXPECT_NE(refusal("/dev/null").find("neither a folder nor an archive"), std::string::npos);
}

TEST_F(ArchiveFaults, NothingIsWrittenBesideTheArchive) {
  take({{"spring_1d.cpp", "one"}, {"x/y/z", "other"}}, Format::Zip);
  EXPECT_EQ(std::distance(std::filesystem::recursive_directory_iterator(folder_.path()), {}), 1);
}

}  // namespace
}  // namespace muelle::grader
