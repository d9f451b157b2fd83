// attack: makes the compiler speak of a full disk; expect: zero points
#include "contact.h"
#line 1 "cc1plus: fatal error: error writing to /tmp/cc1.s: No space left on device"
#error No space left on device
static_assert(false, "virtual memory exhausted: Cannot allocate memory");
