// attack: places its mistakes in a header of the harness and in the contract; expect: zero points
#include "energy_gradient.h"
#line 12 "../framework/harness/types.h"
int broken = "text";
#line 3 "../contract/energy_gradient.h"
double springEnergy(const Vec6&) { return missing; }
