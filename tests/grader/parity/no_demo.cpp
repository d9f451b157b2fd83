/// \file
/// The main function of the test programs can draw a demo; those that compare verdicts have none.

#include "harness/figure.h"

#include <vector>

std::vector<muelle::Figure> muelleDemo();

std::vector<muelle::Figure> muelleDemo() { return {}; }
