#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace muelle::grader::wire {

/// A message that does not say what it should: wrong shape, impossible length, bytes missing or left over.
class WireError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Appends plain numbers to a buffer, in the machine's byte order (both ends are one machine).
class Writer {
 public:
  template <class Number>
  requires std::is_arithmetic_v<Number>
  void number(Number value) {
    const auto* bytes = reinterpret_cast<const std::byte*>(&value);
    bytes_.insert(bytes_.end(), bytes, bytes + sizeof value);
  }

  void numbers(const double* values, std::size_t count) {
    const auto* bytes = reinterpret_cast<const std::byte*>(values);
    bytes_.insert(bytes_.end(), bytes, bytes + count * sizeof(double));
  }

  std::vector<std::byte>& bytes() { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

/// Takes numbers from bytes that nobody vouches for: every read is bounded, and a length is believed only when the
/// bytes that it announces are there.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class Number>
  requires std::is_arithmetic_v<Number> Number number() {
    Number value;
    std::memcpy(&value, take(sizeof value), sizeof value);
    return value;
  }

  void numbers(double* values, std::size_t count) {
    if (count > remaining() / sizeof(double)) throw WireError("a list is longer than its message");
    if (count > 0) std::memcpy(values, take(count * sizeof(double)), count * sizeof(double));
  }

  /// A length whose elements take at least `bytesEach` of what is left of the message.
  std::size_t length(std::size_t bytesEach) {
    const auto value = number<std::uint64_t>();
    if (value > remaining() / bytesEach)
      throw WireError("a length of " + std::to_string(value) + " exceeds its message");
    return static_cast<std::size_t>(value);
  }

  std::size_t remaining() const { return bytes_.size() - position_; }
  void expectEnd() const {
    if (remaining() != 0) throw WireError(std::to_string(remaining()) + " bytes are left over");
  }

 private:
  const std::byte* take(std::size_t count) {
    if (count > remaining()) throw WireError("the message is too short");
    const std::byte* begin = bytes_.data() + position_;
    position_ += count;
    return begin;
  }

  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
};

}  // namespace muelle::grader::wire
