#include "grader/report/report.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace muelle::grader {

namespace {

/// Removes the half-written file unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target) : name_(target.string() + ".XXXXXX"), target_(target) {
    fd_ = ::mkstemp(name_.data());
    if (fd_ < 0) fail();
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (fd_ >= 0) ::close(fd_);
    if (!renamed_) ::unlink(name_.c_str());
  }

  void write(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t wrote = ::write(fd_, text.data(), text.size());
      if (wrote < 0 && errno == EINTR) continue;
      if (wrote < 0) fail();
      text.remove_prefix(static_cast<std::size_t>(wrote));
    }
  }

  void rename() {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    const bool closed = ::fchmod(fd_, 0666 & ~mask) == 0 && ::close(std::exchange(fd_, -1)) == 0;
    if (!closed || ::rename(name_.c_str(), target_.c_str()) != 0) fail();
    renamed_ = true;
  }

 private:
  [[noreturn]] void fail() const {
    throw std::runtime_error(fmt::format("cannot write the report {}: {}; free some space or choose another folder",
                                         target_.string(), std::strerror(errno)));
  }

  std::string name_;
  std::filesystem::path target_;
  int fd_ = -1;
  bool renamed_ = false;
};

void writeWhole(const std::filesystem::path& target, const std::string& text) {
  TemporaryFile file(target);
  file.write(text);
  file.rename();
}

}  // namespace

void writeReports(const GradedSubmission& graded, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error(fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
  writeWhole(folder / "results.json", resultsJson(graded));
  writeWhole(folder / "results.xml", junitXml(graded));
  writeWhole(folder / "report.html", htmlPage(graded));
}

}  // namespace muelle::grader
