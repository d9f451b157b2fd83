#include "lab/published/problem.h"

#include <cmath>

namespace muelle::published {

double Quantity::printedValue() const { return std::stod(printed); }

double Quantity::lastDigit() const {
  const std::size_t e = printed.find('e');
  const std::size_t end = e == std::string::npos ? printed.size() : e;
  const std::size_t point = printed.find('.');
  const int decimals = point < end ? static_cast<int>(end - point) - 1 : 0;
  return std::pow(10.0, (e == std::string::npos ? 0 : std::stoi(printed.substr(e + 1))) - decimals);
}

std::vector<Problem> problems() {
  std::vector<Problem> all = frequencyProblems();
  for (const auto& more : {motionProblems(), nonlinearProblems()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace muelle::published
