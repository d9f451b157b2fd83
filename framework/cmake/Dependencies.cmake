# One target for each library, from the distribution's packages.

find_package(Threads REQUIRED)

# Eigen as a system header folder, so that its warnings are not ours.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
get_target_property(MUELLE_EIGEN_INCLUDE Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)

find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(GTest REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET tomlplusplus)
pkg_check_modules(utf8proc REQUIRED IMPORTED_TARGET libutf8proc)
find_library(MUELLE_UTF8PROC_LIBRARY utf8proc REQUIRED)

# The same definitions everywhere, or the precompiled header would not fit.
target_link_libraries(muelle_flags INTERFACE fmt::fmt Eigen3::Eigen)
target_compile_definitions(muelle_flags INTERFACE GTEST_HAS_PTHREAD=1)

# The grader's own: absent on a student's machine.
if(NOT MUELLE_STUDENTS_TREE)
  find_package(nlohmann_json REQUIRED)
  find_package(pugixml REQUIRED)
  pkg_check_modules(libarchive REQUIRED IMPORTED_TARGET libarchive)
  pkg_check_modules(libseccomp REQUIRED IMPORTED_TARGET libseccomp)
  pkg_check_modules(libcrypto REQUIRED IMPORTED_TARGET libcrypto)
  find_package(ZLIB REQUIRED)
endif()
