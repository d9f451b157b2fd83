#pragma once
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace muelle::grader {

/// SHA-256 over parts, each preceded by its length so that no two lists of parts look alike; 64 hexadecimal digits.
std::string digest(std::initializer_list<std::string_view> parts);

/// SHA-256 of a text as it is: what digestOfFile() gives of a file that holds it.
std::string digestOfBytes(std::string_view bytes);

/// SHA-256 of a file's content. Throws std::runtime_error naming the file.
std::string digestOfFile(const std::filesystem::path& file);

/// The first 64 bits of HMAC-SHA-256(key, text): the seed of an exercise's inputs.
std::uint64_t keyedSeed(std::string_view key, std::string_view text);

}  // namespace muelle::grader
