#pragma once
/// \file
/// What a compiled file uses and defines, judged before it is linked: what no exercise needs is refused by its name, so
/// that it is refused in the same words wherever the file runs.

#include "course/check/outcome.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// A variable, and the room that it takes in memory before anything has run.
struct StaticData {
  std::string symbol;
  std::size_t bytes = 0;
};

/// The symbols of compiled files, as the assembler spells them.
struct Symbols {
  std::vector<std::string> undefined;  ///< taken from elsewhere
  std::vector<std::string> defined;    ///< seen from elsewhere
  std::vector<StaticData> data;        ///< as far as the system's nm tells sizes: a Mac's does not
};

/// Reads what `nm -P` writes, of several files too: what one defines and another uses is not undefined.
Symbols readSymbols(std::string_view nmText);

/// What the symbols alone say.
struct SymbolVerdict {
  Outcome outcome = Outcome::Passed;  ///< Passed, Link (main), Forbidden, or Crash (more memory than there is)
  std::string message;                ///< one sentence that names the cause; "" when passed
};

/// All that judgeSymbols() goes by, as text: a key of what it has judged holds it, so that a new rule judges again.
std::string symbolRules();

/// The first thing that stands against the file. main comes before what it may use.
SymbolVerdict judgeSymbols(const Symbols& symbols);

}  // namespace muelle
