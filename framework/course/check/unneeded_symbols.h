#pragma once
/// \file
/// The symbols of the C and C++ libraries that no exercise needs, each with the reason that a student reads.

#include <string>
#include <string_view>

namespace muelle {

/// A symbol that no exercise needs.
struct Unneeded {
  std::string_view symbol;    ///< whole name of a C function, or the beginning of a mangled name
  std::string_view shown;     ///< as the student writes it; "": the symbol
  std::string_view sentence;  ///< completes "it ...", with {} for the name
};

/// What is said of the symbol, without underscore of the system's and version; null when an exercise may need it.
const Unneeded* unneeded(std::string_view symbol);

/// All of them as text, a line each.
std::string unneededSymbols();

}  // namespace muelle
