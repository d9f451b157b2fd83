#include "grader/run/digest.h"

#include "base/file.h"
#include "grader/record.h"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <array>
#include <cstring>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <tuple>

namespace muelle::grader {

namespace {

class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free) {
    if (!context_ || EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) != 1) {
      throw std::runtime_error("libcrypto has no SHA-256");
    }
  }

  void add(std::string_view bytes) { EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()); }

  std::string hexadecimal() {
    std::array<unsigned char, 32> bytes{};
    EVP_DigestFinal_ex(context_.get(), bytes.data(), nullptr);
    std::string text;
    for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

}  // namespace

std::string digest(std::initializer_list<std::string_view> parts) {
  Sha256 sha;
  for (const std::string_view part : parts) {
    sha.add(fmt::format("{}:", part.size()));
    sha.add(part);
  }
  return sha.hexadecimal();
}

std::string digestOfBytes(std::string_view bytes) {
  Sha256 sha;
  sha.add(bytes);
  return sha.hexadecimal();
}

std::string digestOfFile(const std::filesystem::path& file) {
  // One run asks for the same programs and headers thousands of times; a file that was written has another time.
  using Version = std::tuple<std::string, std::filesystem::file_time_type, std::uintmax_t>;
  static std::map<Version, std::string> known;
  static std::mutex mutex;
  std::error_code ignored;  // a missing file is readFile's to report
  const Version version{file.string(), std::filesystem::last_write_time(file, ignored),
                        std::filesystem::file_size(file, ignored)};
  {
    const std::lock_guard lock(mutex);
    if (const auto found = known.find(version); found != known.end()) return found->second;
  }
  std::string result = digestOfBytes(readFile(file));
  const std::lock_guard lock(mutex);
  known.emplace(version, result);
  return result;
}

std::uint64_t keyedSeed(std::string_view key, std::string_view text) {
  std::array<unsigned char, 32> bytes{};
  unsigned length = 0;
  if (HMAC(EVP_sha256(), key.data(), static_cast<int>(key.size()), reinterpret_cast<const unsigned char*>(text.data()),
           text.size(), bytes.data(), &length) == nullptr) {
    throw std::runtime_error("libcrypto refused an HMAC");
  }
  std::uint64_t seed = 0;
  std::memcpy(&seed, bytes.data(), sizeof seed);
  return seed;
}

}  // namespace muelle::grader
