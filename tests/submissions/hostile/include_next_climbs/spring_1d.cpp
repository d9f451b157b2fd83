// attack: climbs out of the folders of headers by include_next; expect: zero points; says: does not compile
#include "spring_1d.h"
#include_next <../../../../../../etc/passwd>
#include_next "../../etc/shadow"
#include <../local/../../etc/hostname>
