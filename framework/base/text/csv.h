#pragma once
#include <string>
#include <string_view>

namespace muelle {

/// A field of a CSV file (RFC 4180), quoted only when it must be: for this project's own texts and numbers.
std::string csvField(std::string_view text);

/// An untrusted text, made printable, as a field: always quoted, on one line; what a spreadsheet would take for a
/// formula (it begins with = + - @, spaces before that included) gets an apostrophe in front.
std::string untrustedCsvField(std::string_view text);

}  // namespace muelle
