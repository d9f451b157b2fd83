// attack: makes the compiler say that its parts are missing; expect: zero points
#include "triangle.h"
#line 1 "g++: fatal error: cannot execute 'cc1plus': posix_spawnp: No such file or directory"
#error cannot execute 'as': No such file or directory
static_assert(false, "collect2: fatal error: cannot find 'ld'");
