// attack: imports a file as a module; expect: zero points; says: does not compile
#include "triangle.h"
import "/etc/passwd";
import <vector>;
