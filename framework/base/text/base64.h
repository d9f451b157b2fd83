#pragma once
#include <string>
#include <string_view>

namespace muelle {

/// Base64 (RFC 4648), padded, of raw bytes.
std::string base64(std::string_view bytes);

}  // namespace muelle
