#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// The source with the lines joined that a backslash at their end continues.
std::string withoutSplices(std::string_view source);

/// The words, numbers and single signs of a C++ source in their order, without comments, texts and characters. As rough
/// as that: it compiles nothing, and refuses nothing. \param source must outlive the tokens
std::vector<std::string_view> sourceTokens(std::string_view source);

/// Whether the token stands in the line, or in the body of the function that the line belongs to; lines count from 1.
bool isInFunctionOfLine(std::string_view source, int line, std::string_view token);

}  // namespace muelle
