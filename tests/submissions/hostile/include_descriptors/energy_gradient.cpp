// attack: includes the descriptors and the input of the compiler; expect: zero points
#include "energy_gradient.h"
#include "/dev/stdin"
#include "/proc/self/fd/0"
#include "/proc/self/fd/3"
#include "/dev/fd/10"
