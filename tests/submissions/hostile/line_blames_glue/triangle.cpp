// attack: places its mistakes in a file of the grader, in a line of two thousand million; expect: zero points
#include "triangle.h"
#line 2147483647 "framework/grader/worker/glue.cpp"
int broken = "text";
