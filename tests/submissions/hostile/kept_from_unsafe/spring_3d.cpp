// attack: includes a solution, which compiles without a sandbox, in the hope that the object is kept; expect: zero points; says: does not compile
#include "/CHECKOUT/solutions/spring_3d/spring_3d.cpp"
