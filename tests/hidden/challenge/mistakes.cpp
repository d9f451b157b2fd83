/// \file
/// The method is free, so that no numbers are those of a mistake: what students do wrong is seen at work, by the tests
/// themselves (seen.h). Here the calls to the worker are compiled.

#include "challenge.h"
