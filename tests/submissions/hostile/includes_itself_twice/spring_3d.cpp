// attack: includes itself twice at every level; expect: zero points
#if __INCLUDE_LEVEL__ < 40
#include "spring_3d.cpp"
#include "spring_3d.cpp"
#endif
