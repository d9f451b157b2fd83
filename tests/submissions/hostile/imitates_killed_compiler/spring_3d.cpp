// attack: makes the compiler say that it was killed; expect: zero points
#include "spring_3d.h"
#line 1 "g++: fatal error: Killed signal terminated program cc1plus\ncompilation terminated."
#error Killed
static_assert(false, "g++: fatal error: Killed signal terminated program cc1plus");
