#include "tools.h"

#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>
#include <locale.h>
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace muelle::grader {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "muelle_intake_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path TemporaryFolder::write(const std::string& name, const std::string& text) const {
  const std::filesystem::path file = path_ / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

std::vector<Manifest> smallCourse() {
  std::vector<Manifest> course(2);
  course[0].topic = "spring_1d";
  course[0].files = {"spring_1d.cpp"};
  course[1].topic = "triangle";
  course[1].files = {"triangle.cpp"};
  return course;
}

namespace {

void check(int status, archive* a) {
  if (status < ARCHIVE_WARN) throw std::runtime_error(::archive_error_string(a));
}

void setFormat(archive* a, Format format) {
  switch (format) {
    case Format::EncryptedZip:
      check(::archive_write_set_format_zip(a), a);
      check(::archive_write_set_options(a, "zip:encryption=zipcrypt"), a);
      check(::archive_write_set_passphrase(a, "secret"), a);
      return;
    case Format::Zip:
      return check(::archive_write_set_format_zip(a), a);
    case Format::SevenZip:
      return check(::archive_write_set_format_7zip(a), a);
    case Format::TarGzip:
      check(::archive_write_add_filter_gzip(a), a);
      break;
    case Format::TarBzip2:
      check(::archive_write_add_filter_bzip2(a), a);
      break;
    case Format::TarXz:
      check(::archive_write_add_filter_xz(a), a);
      break;
    case Format::TarZstd:
      check(::archive_write_add_filter_zstd(a), a);
      break;
    case Format::Tar:
      break;
  }
  check(::archive_write_set_format_pax_restricted(a), a);
}

/// The writer needs to know how names are encoded; the reader under test must do without.
class Utf8Locale {
 public:
  Utf8Locale() : utf8_(::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)), before_(::uselocale(utf8_)) {}
  Utf8Locale(const Utf8Locale&) = delete;
  Utf8Locale& operator=(const Utf8Locale&) = delete;
  ~Utf8Locale() {
    ::uselocale(before_);
    ::freelocale(utf8_);
  }

 private:
  locale_t utf8_;
  locale_t before_;
};

void writeEntry(archive* a, const ArchiveEntry& given) {
  const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(::archive_entry_new(), ::archive_entry_free);
  ::archive_entry_set_pathname_utf8(entry.get(), given.name.c_str());
  ::archive_entry_set_filetype(entry.get(), given.type);
  ::archive_entry_set_perm(entry.get(), 0644);
  ::archive_entry_set_size(entry.get(), static_cast<la_int64_t>(given.text.size()));
  if (!given.symbolicLink.empty()) ::archive_entry_set_symlink(entry.get(), given.symbolicLink.c_str());
  if (!given.hardLink.empty()) ::archive_entry_set_hardlink(entry.get(), given.hardLink.c_str());
  check(::archive_write_header(a, entry.get()), a);
  if (!given.text.empty() && ::archive_write_data(a, given.text.data(), given.text.size()) < 0)
    throw std::runtime_error(::archive_error_string(a));
}

}  // namespace

void writeArchive(const std::filesystem::path& file, Format format, const std::vector<ArchiveEntry>& entries) {
  const Utf8Locale locale;
  const std::unique_ptr<archive, int (*)(archive*)> a(::archive_write_new(), ::archive_write_free);
  setFormat(a.get(), format);
  check(::archive_write_open_filename(a.get(), file.c_str()), a.get());
  for (const ArchiveEntry& entry : entries) writeEntry(a.get(), entry);
  check(::archive_write_close(a.get()), a.get());
}

std::string refusal(const std::filesystem::path& submission, const IntakeLimits& limits) {
  try {
    takeSubmission(submission, smallCourse(), limits);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  ADD_FAILURE() << "was not refused";
  return "";
}

bool isNoted(const Submission& submission, const std::string& text) {
  return std::any_of(submission.notes.begin(), submission.notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

}  // namespace muelle::grader
