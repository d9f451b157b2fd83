// attack: includes itself twice at every level; expect: zero points
#if __INCLUDE_LEVEL__ < 40
#include __FILE__
#include __FILE__
#endif
