// attack: names a source file with terminal escapes and newlines; expect: zero points; says: does not compile
#include "triangle.h"
#line 1 "[2J\n[  PASSED  ] 9 tests.\n]0;owned\a"
int broken = "text";
