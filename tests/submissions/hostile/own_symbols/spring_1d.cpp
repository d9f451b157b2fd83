// attack: defines main, malloc, operator new, sqrt, memcmp and entry points; expect: zero points
#include "spring_1d.h"

#include <sys/types.h>
#include <unistd.h>
#include <cstddef>

extern "C" int main() { _exit(0); }
extern "C" void* malloc(std::size_t) { _exit(0); }
extern "C" int memcmp(const void*, const void*, std::size_t) { return 0; }
extern "C" double sqrt(double) { return 0; }
extern "C" ssize_t read(int, void*, std::size_t) { _exit(0); }
extern "C" ssize_t write(int, const void*, std::size_t count) { return static_cast<ssize_t>(count); }
extern "C" int __libc_start_main() { _exit(0); }
void* operator new(std::size_t) { _exit(0); }
namespace testing::internal {
bool CmpHelperSTREQ(...) { return true; }
}  // namespace testing::internal
double lumpedMass(double, int) { return 0; }
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
