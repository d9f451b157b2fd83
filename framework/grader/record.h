#pragma once
#include "grader/verdict.h"

#include <filesystem>
#include <optional>

namespace muelle::grader {

/// Writes a verdict, whole or not at all. Throws std::runtime_error naming the file and the system's reason: a full
/// disk leaves what was there before.
void writeRecord(const Verdict& verdict, const std::filesystem::path& file);

/// Reads a verdict; nullopt when there is none, or none of this version that is readable as one: then it is as if the
/// test had not run.
std::optional<Verdict> readRecord(const std::filesystem::path& file);

}  // namespace muelle::grader
