// attack: lets the linker quote a symbol made of terminal escapes; expect: zero points
#include "spring_3d.h"

asm(".pushsection .data\n\t.quad \"[2J]0;owned\\n<script>alert(1)</script>\"\n\t.popsection");

double springForceMagnitude(const Vec3&, const Vec3&, double, double) { return 0; }
Vec3 springDirection(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec3 springForce(const Vec3&, const Vec3&, double, double) { return Vec3::Zero(); }
Vec3 nodeAcceleration(const Vec3&, double, const std::vector<Attachment>&, double) { return Vec3::Zero(); }
