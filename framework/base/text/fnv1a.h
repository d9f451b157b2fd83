#pragma once
#include <cstdint>
#include <string_view>

namespace muelle {

/// FNV-1a (64 bits) of bytes: the same on every platform, which std::hash is not. It finds slips and tells things
/// apart; where somebody could gain by two that are alike it is not enough. \param hash that of what stands before them
constexpr std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash = 14695981039346656037ULL) {
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
  return hash;
}

}  // namespace muelle
