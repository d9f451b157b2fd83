#pragma once
#include <string>
#include <string_view>

namespace muelle {

/// Whether standard output is a terminal and the user has not refused colours (NO_COLOR, TERM=dumb).
bool coloursWanted();

/// The text in a colour or weight, when colours are wanted; else as it is.
std::string bold(std::string_view text);
std::string red(std::string_view text);
std::string green(std::string_view text);
std::string dim(std::string_view text);

/// Whether somebody may answer a question: standard input and output are terminals.
bool isTalkedTo();

/// Columns of the terminal, or 100 when standard output is none.
int terminalWidth();

}  // namespace muelle
