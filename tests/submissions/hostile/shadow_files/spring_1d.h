#define SHADOWED
#include <cmath>
struct Attachment {
  double x, k, L0;
};
