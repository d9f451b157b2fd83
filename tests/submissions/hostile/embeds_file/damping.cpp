// attack: embeds a file of the system as numbers; expect: zero points; says: does not compile
#include "damping.h"
#ifdef __has_embed
#if __has_embed("/etc/passwd")
#error a file is there
#endif
#endif
static const unsigned char bytes[] = {
#embed "/etc/passwd"
};
