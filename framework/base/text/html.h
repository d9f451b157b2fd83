#pragma once
#include <string>
#include <string_view>

namespace muelle {

/// Untrusted text, made printable (base/text/printable.h), for the content of an HTML element or a quoted attribute;
/// lines are kept.
std::string escapeHtml(std::string_view raw);

}  // namespace muelle
