// attack: hides a directive in an encoding of seven bits and in bytes that are no text; expect: zero points; says: does not compile
#include "damping.h"
+ACM-include +ACI-/etc/passwd+ACI-
ÿþÃ( broken í €
