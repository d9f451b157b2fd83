// attack: puts terminal escapes and markup into a failed assertion, a warning and a message; expect: zero points; says: does not compile
#include "damping.h"
#pragma message("[31m<script>alert(1)</script>]52;c;b3duZWQ=")
#warning [1A[2K 10 / 10
static_assert(sizeof(int) == 3, "[2J[H all tests passed ‮ =cmd|' /C calc'!A0");
