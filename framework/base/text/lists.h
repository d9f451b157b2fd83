#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// A range of texts in one, with `separator` between each two.
template <class Texts>
std::string joined(const Texts& texts, std::string_view separator) {
  std::string all;
  bool isFirst = true;
  for (const std::string_view text : texts) {
    if (!isFirst) all += separator;
    isFirst = false;
    all += text;
  }
  return all;
}

/// The reverse: what stands before, between and behind the separators, without the blanks around it. One text, which
/// may be empty, where there is no separator.
std::vector<std::string> parted(std::string_view text, std::string_view separator);

}  // namespace muelle
