#pragma once
/// \file
/// Untrusted text inside a format. Each of these makes the text printable first (base/text/printable.h).

#include <string>
#include <string_view>

namespace muelle {

/// For the content of an HTML element or a quoted attribute; lines are kept.
std::string escapeHtml(std::string_view text);

/// For the content of an XML 1.0 element; lines are kept.
std::string escapeXml(std::string_view text);

/// For a quoted XML attribute: one line.
std::string escapeXmlAttribute(std::string_view text);

/// A field of a CSV file (RFC 4180), quoted only when it must be: for this project's own texts and numbers.
std::string csvField(std::string_view text);

/// An untrusted text as a field: always quoted, on one line; what a spreadsheet would take for a formula (it begins
/// with = + - @, spaces before that included) gets an apostrophe in front.
std::string untrustedCsvField(std::string_view text);

/// Base64 (RFC 4648), padded, of raw bytes.
std::string base64(std::string_view bytes);

}  // namespace muelle
