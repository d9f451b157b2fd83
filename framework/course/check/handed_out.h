#pragma once
/// \file
/// Whether the files that come with an exercise are still those that were handed out. framework/course/handed_out.txt
/// lists them with their hashes; a test keeps the list current.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// fnv1a() of the text without carriage returns, which a download may add. Nobody gains by deceiving it, since the
/// grader compiles against its own copies.
std::uint64_t handedOutHash(std::string_view text);

/// The list as it should be for this checkout: a line "HASH PATH" for every header of the harness and, for every
/// exercise, its contract, public tests, demo and manifest.
std::string handedOutList(const std::filesystem::path& checkout);

/// The files of an exercise and of the harness that differ from the list or are missing, relative to the checkout.
/// Empty when the checkout has no list.
std::vector<std::string> changedHandedOut(const std::filesystem::path& checkout, std::string_view topic);

/// The same of the harness and every exercise.
std::vector<std::string> changedHandedOut(const std::filesystem::path& checkout);

/// "FILE is not as it was handed out: ...", a line for each; "" when there is none. Who has the graders' rooms, too, is
/// an author and told to note the change.
std::string sayChanged(const std::filesystem::path& checkout, const std::vector<std::string>& changed);

}  // namespace muelle
