// attack: puts terminal escapes and a right-to-left mark into a compiler message; expect: zero points; says: does not compile
#error ]0;owned[2J 10 / 10 ‮gnp
