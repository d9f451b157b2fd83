#include "base/text/count.h"

namespace muelle {

std::string nounFor(long long count, std::string_view one, std::string_view several) {
  if (count == 1) return std::string(one);
  return several.empty() ? std::string(one) + "s" : std::string(several);
}

std::string counted(long long count, std::string_view one, std::string_view several) {
  return std::to_string(count) + " " + nounFor(count, one, several);
}

std::string countedInGroups(long long count, std::string_view one, std::string_view several) {
  return grouped(count) + " " + nounFor(count, one, several);
}

std::string grouped(long long count) {
  std::string digits = std::to_string(count);
  const std::ptrdiff_t first = count < 0 ? 1 : 0;
  for (std::ptrdiff_t i = std::ssize(digits) - 3; i > first; i -= 3) digits.insert(static_cast<std::size_t>(i), ",");
  return digits;
}

}  // namespace muelle
