#include "grader/intake/gzip_checksum.h"

#include "grader/intake/read_file.h"

#include <fmt/format.h>
#define ZLIB_CONST  // its input is not changed
#include <zlib.h>
#include <array>
#include <new>
#include <string_view>

namespace muelle::grader {

namespace {

constexpr int gzipAlone = 15 + 16;  ///< the largest window, and a gzip header and trailer around it, which are checked

/// The members of a gzip file, one after the other.
class Members {
 public:
  Members(const std::string& bytes, std::size_t limit) : rest_(bytes), limit_(limit) {
    if (::inflateInit2(&stream_, gzipAlone) != Z_OK) throw std::bad_alloc();
  }
  Members(const Members&) = delete;
  Members& operator=(const Members&) = delete;
  ~Members() { ::inflateEnd(&stream_); }

  std::string fault() {
    do {
      const std::string why = next();
      if (!why.empty()) return why;
    } while (rest_.find_first_not_of('\0') != std::string_view::npos);  // tapes and disks pad with zeros
    return "";
  }

 private:
  /// Inflates one member; zlib compares its checksum and size.
  std::string next() {
    ::inflateReset(&stream_);
    stream_.next_in = reinterpret_cast<const Bytef*>(rest_.data());
    stream_.avail_in = static_cast<uInt>(rest_.size());
    for (;;) {
      stream_.next_out = reinterpret_cast<Bytef*>(buffer_.data());
      stream_.avail_out = static_cast<uInt>(buffer_.size());
      const int status = ::inflate(&stream_, Z_NO_FLUSH);
      unpacked_ += buffer_.size() - stream_.avail_out;
      if (unpacked_ > limit_) return fmt::format("it unpacks to more than {}", showBytes(limit_));
      if (status == Z_STREAM_END) break;
      if (status == Z_BUF_ERROR) return "it ends too early";
      if (status != Z_OK) return whatZlibSays();
    }
    rest_.remove_prefix(rest_.size() - stream_.avail_in);
    isFirst_ = false;
    return "";
  }

  std::string whatZlibSays() const {
    const std::string_view said = stream_.msg == nullptr ? "" : stream_.msg;
    if (said == "incorrect data check") return "its checksum is wrong";
    if (said == "incorrect length check") return "its size is wrong";
    return isFirst_ ? "it is damaged" : "something else follows its end";
  }

  z_stream stream_{};
  std::string_view rest_;
  std::size_t limit_;
  std::size_t unpacked_ = 0;
  bool isFirst_ = true;
  std::array<char, 64UL * 1024> buffer_;
};

}  // namespace

std::string gzipFault(const std::string& bytes, std::size_t limit) { return Members(bytes, limit).fault(); }

}  // namespace muelle::grader
