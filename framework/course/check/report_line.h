#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace muelle {

/// The lines in which the public test program tells the check what happens: "kind<TAB>text", with \n for a newline.
std::string reportLine(std::string_view kind, std::string_view text);

/// Kind and text of every whole line.
std::vector<std::pair<std::string, std::string>> readReport(std::string_view report);

}  // namespace muelle
