#pragma once
#include "grader/wire/bytes.h"

#include <cstdint>
#include <string>
#include <vector>

namespace muelle::grader::worker {

/// Before the name of a function of the standard library that asserts; Eigen's have none before theirs.
inline constexpr const char* standardLibrary = "std: ";

/// What the host process lends to the code that it has loaded.
class HostPort {
 public:
  /// Asks the test process to evaluate its function `id`; returns the encoded answer.
  virtual std::vector<std::byte> callback(std::uint32_t id, const std::vector<std::byte>& arguments) = 0;
  /// Reports that an assertion of Eigen or of the standard library refused an operation, and ends the process.
  [[noreturn]] virtual void refuse(const std::string& condition, const std::string& function, bool indexKnown,
                                   long index) = 0;

 protected:
  ~HostPort() = default;
};

/// One function of the contract.
struct ServedFunction {
  std::uint32_t id;
  const char* name;
  void (*call)(wire::Reader& in, wire::Writer& out, HostPort& port);
};

/// How a call ended.
enum class Served { Returned, Threw, Unknown };

/// The one symbol that the host looks up in a submission. `text` receives an exception's words, `name` the function's.
using ServeFunction = Served (*)(std::uint32_t id, const std::vector<std::byte>& arguments,
                                 std::vector<std::byte>& result, std::string& text, HostPort& port);
inline constexpr const char* serveSymbol = "muelleServe";

}  // namespace muelle::grader::worker
