#pragma once
/// \file
/// Whether the files that come with an exercise are still those that were handed out. framework/course/handed_out.txt
/// lists them with their hashes; a test keeps the list current.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace muelle {

/// fnv1a() of the text without carriage returns, which a download may add. Nobody gains by deceiving it, since the
/// grader compiles against its own copies.
std::uint64_t handedOutHash(std::string_view text);

/// The list as it should be for this checkout: a line "HASH PATH" for every header of the harness and, for every
/// exercise, its contract, public tests, demo and manifest.
std::string handedOutList(const std::filesystem::path& checkout);

/// Whether the checkout is an author's: it has the graders' room, which is never handed out. The launcher and
/// CMakeLists.txt tell by the same file.
bool isAuthors(const std::filesystem::path& checkout);

/// "FILE is not as it was handed out: ...", a line for each file of the harness and of any exercise that differs from
/// the list or is missing; "" when there is none, or no list. A student is told to get it back, an author to note the
/// change.
std::string sayChanged(const std::filesystem::path& checkout);

/// The same of the harness and one exercise.
std::string sayChanged(const std::filesystem::path& checkout, std::string_view topic);

}  // namespace muelle
