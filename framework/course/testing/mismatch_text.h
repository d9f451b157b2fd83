#pragma once
/// \file
/// Numbers and mismatches as text from which they read back exactly: how they travel from process to process.

#include "course/testing/mismatch.h"

#include <optional>
#include <string>
#include <string_view>

namespace muelle {

/// The shortest decimal that reads back as the same number; "bits:7ff8000000000000" of what is not finite, so that the
/// bits of a NaN survive.
std::string exactText(double number);

/// The number of exactText(); nullopt for any other text.
std::optional<double> exactNumber(std::string_view text);

/// A mismatch as one field of a report line.
std::string mismatchText(const Mismatch& mismatch);

/// The mismatch of mismatchText(); nullopt for any other text.
std::optional<Mismatch> readMismatch(std::string_view text);

}  // namespace muelle
