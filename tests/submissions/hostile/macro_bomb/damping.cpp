// attack: doubles a macro thirty times; expect: zero points
#include "damping.h"

#define TWICE_0(x) x x
#define TWICE_1(x) TWICE_0(x) TWICE_0(x)
#define TWICE_2(x) TWICE_1(x) TWICE_1(x)
#define TWICE_3(x) TWICE_2(x) TWICE_2(x)
#define TWICE_4(x) TWICE_3(x) TWICE_3(x)
#define TWICE_5(x) TWICE_4(x) TWICE_4(x)
#define TWICE_6(x) TWICE_5(x) TWICE_5(x)
#define TWICE_7(x) TWICE_6(x) TWICE_6(x)
#define TWICE_8(x) TWICE_7(x) TWICE_7(x)
#define TWICE_9(x) TWICE_8(x) TWICE_8(x)
#define TWICE_10(x) TWICE_9(x) TWICE_9(x)
#define TWICE_11(x) TWICE_10(x) TWICE_10(x)
#define TWICE_12(x) TWICE_11(x) TWICE_11(x)
#define TWICE_13(x) TWICE_12(x) TWICE_12(x)
#define TWICE_14(x) TWICE_13(x) TWICE_13(x)
#define TWICE_15(x) TWICE_14(x) TWICE_14(x)
#define TWICE_16(x) TWICE_15(x) TWICE_15(x)
#define TWICE_17(x) TWICE_16(x) TWICE_16(x)
#define TWICE_18(x) TWICE_17(x) TWICE_17(x)
#define TWICE_19(x) TWICE_18(x) TWICE_18(x)
#define TWICE_20(x) TWICE_19(x) TWICE_19(x)
#define TWICE_21(x) TWICE_20(x) TWICE_20(x)
#define TWICE_22(x) TWICE_21(x) TWICE_21(x)
#define TWICE_23(x) TWICE_22(x) TWICE_22(x)
#define TWICE_24(x) TWICE_23(x) TWICE_23(x)
#define TWICE_25(x) TWICE_24(x) TWICE_24(x)
#define TWICE_26(x) TWICE_25(x) TWICE_25(x)
#define TWICE_27(x) TWICE_26(x) TWICE_26(x)
#define TWICE_28(x) TWICE_27(x) TWICE_27(x)
#define TWICE_29(x) TWICE_28(x) TWICE_28(x)

int sum() { return 0 TWICE_29(+1); }

Vec3 nodeDamping(const Vec3& va, double d) { return sum() == 0 ? Vec3(-d * va) : Vec3(0, 0, 0); }
Vec3 relativeDamping(const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
Vec3 projectedDamping(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
