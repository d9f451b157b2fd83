#include "lab/bench/contestant.h"

#include <stdexcept>

namespace muelle::bench {

std::string nameOf(Row row) { return row == Row::Ours ? "ours" : row == Row::Plain ? "A" : "B"; }

Row rowOf(const std::string& name) {
  for (const Row row : {Row::Ours, Row::Plain, Row::Kernel}) {
    if (nameOf(row) == name) return row;
  }
  throw std::invalid_argument("no row '" + name + "'; there are ours, A and B");
}

}  // namespace muelle::bench
