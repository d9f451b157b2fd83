// attack: includes a hidden file by a trigraph and by an underscore that is an operator; expect: zero points; says: does not compile
#include "contact.h"
??=include "../../tests/hidden/contact/oracle.cpp"
_Pragma("include \"/etc/passwd\"") _Pragma("GCC dependency \"/etc/shadow\"")
int broken = "text";
