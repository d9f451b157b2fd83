/// \file
/// Writes the rabbit: muelle-rabbit FILE.off.

#include "base/errors.h"
#include "base/file.h"
#include "lab/meshes/rabbit.h"

#include <stdexcept>

int main(int argc, char** argv) {
  return muelle::withErrorsOnOneLine([=] {
    if (argc != 2)
      throw std::invalid_argument("name the file to write, for example exercises/mesh_to_springs/rabbit.off");
    muelle::writeFile(argv[1],
                      muelle::lab::offText(muelle::lab::rabbitMesh(), "A rabbit of ellipsoids, made by muelle-rabbit"));
    return 0;
  });
}
