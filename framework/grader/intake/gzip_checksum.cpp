#include "grader/intake/gzip_checksum.h"

#include <archive.h>
#include <archive_entry.h>
#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

namespace muelle::grader {

namespace {

constexpr std::size_t trailerBytes = 8;  ///< CRC-32 and size modulo 2^32, least byte first (RFC 1952)

std::uint32_t word(std::string_view bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[static_cast<std::size_t>(i)]);
  return value;
}

constexpr std::array<std::uint32_t, 256> crcTable() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t c = i;
    for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? 0xedb88320u ^ (c >> 1) : c >> 1;
    table[i] = c;
  }
  return table;
}

class Crc32 {
 public:
  void add(std::string_view bytes) {
    static constexpr auto table = crcTable();
    for (const char c : bytes) state_ = table[(state_ ^ static_cast<unsigned char>(c)) & 0xff] ^ (state_ >> 8);
  }
  std::uint32_t value() const { return ~state_; }

 private:
  std::uint32_t state_ = 0xffffffffu;
};

}  // namespace

std::string gzipFault(const std::string& bytes, std::size_t limit) {
  const std::unique_ptr<archive, int (*)(archive*)> raw(::archive_read_new(), ::archive_read_free);
  archive_entry* entry = nullptr;
  if (!raw) throw std::bad_alloc();
  ::archive_read_support_format_raw(raw.get());
  ::archive_read_support_format_empty(raw.get());
  if (::archive_read_append_filter(raw.get(), ARCHIVE_FILTER_GZIP) != ARCHIVE_OK ||
      ::archive_read_open_memory(raw.get(), bytes.data(), bytes.size()) != ARCHIVE_OK ||
      ::archive_read_next_header(raw.get(), &entry) < ARCHIVE_WARN)
    return "it cannot be unpacked";
  Crc32 crc;
  std::uint64_t size = 0;
  std::array<char, 64 * 1024> buffer;
  for (;;) {
    const la_ssize_t got = ::archive_read_data(raw.get(), buffer.data(), buffer.size());
    if (got < 0) return "it ends too early";
    if (got == 0) break;
    size += static_cast<std::uint64_t>(got);
    if (size > limit) return "";
    crc.add(std::string_view(buffer.data(), static_cast<std::size_t>(got)));
  }
  if (bytes.size() < trailerBytes) return "it ends too early";
  const std::string_view trailer = std::string_view(bytes).substr(bytes.size() - trailerBytes);
  // Where the sizes differ the file may have several members, whose last one alone the trailer is about.
  const bool isOfAll = word(trailer.substr(4)) == static_cast<std::uint32_t>(size);
  return isOfAll && word(trailer) != crc.value() ? "its checksum is wrong" : "";
}

}  // namespace muelle::grader
