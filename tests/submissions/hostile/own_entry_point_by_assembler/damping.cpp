// attack: defines by the assembler the function that the worker looks up; expect: zero points
#include "damping.h"

asm(".pushsection .text\n\t.weak muelleServe\n\t.type muelleServe, @function\nmuelleServe:\n\txor %eax, "
    "%eax\n\tret\n\t.popsection");

Vec3 nodeDamping(const Vec3&, double) { return Vec3::Zero(); }
Vec3 relativeDamping(const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
Vec3 projectedDamping(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
