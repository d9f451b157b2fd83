// attack: makes the compiler speak of an internal error; expect: zero points
#include "damping.h"
#line 1 "during RTL pass: expand"
#error internal compiler error: Segmentation fault
static_assert(false, "internal compiler error: in gimplify_expr, please submit a full bug report");
