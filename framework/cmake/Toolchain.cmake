# Language, warnings and linker, and the flags with which students' files are compiled.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_COMPILE_OPTIONS_PIE -fPIC)  # programs too, so that all share one precompiled header
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
# Assertions stay on: Eigen's range checks are part of what the course teaches.
set(CMAKE_CXX_FLAGS_RELEASE "-O2")

option(MUELLE_ASAN "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)

# For programs that compute little: -O1 compiles faster. With sanitizers nothing is optimised: they take twice as long to
# compile optimised code as plain code.
set(MUELLE_LIGHT -O1)
if(MUELLE_ASAN)
  set(MUELLE_LIGHT -O0)
  set(CMAKE_CXX_FLAGS_RELEASE "-O0")
endif()

# For the engine, where the time of a run goes: Eigen's range checks are for students' files.
set(MUELLE_ENGINE -DEIGEN_NO_DEBUG -O3)
if(MUELLE_ASAN)
  set(MUELLE_ENGINE "")
endif()

# The same for all of a folder. Call it before targets are added. In a student's tree, where the first check waits for
# all of it, our own code is not optimised at all; what simulates is.
macro(muelle_optimise_little)
  if(MUELLE_STUDENTS_TREE)
    add_compile_options(-O0)
  else()
    add_compile_options(${MUELLE_LIGHT})
  endif()
endmacro()

# For all of our code; muelle_flags adds the sanitizers, which the worker cannot have: they want an address space without
# a limit and system calls that its filter refuses.
add_library(muelle_plain_flags INTERFACE)
target_include_directories(muelle_plain_flags INTERFACE ${CMAKE_SOURCE_DIR}/framework)
target_compile_options(muelle_plain_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(NOT MUELLE_STUDENTS_TREE)  # whose compiler may know warnings that ours does not
  target_compile_options(muelle_plain_flags INTERFACE -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 sees overruns inside std::string's own concatenation that are not there (GCC bugs 105329, 105651).
  target_compile_options(muelle_plain_flags INTERFACE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread
                                                      -Wno-restrict)
endif()

add_library(muelle_flags INTERFACE)
target_link_libraries(muelle_flags INTERFACE muelle_plain_flags)
set(MUELLE_SANITIZER_LINK_FLAG "")
if(MUELLE_ASAN)
  set(MUELLE_SANITIZER_LINK_FLAG "-fsanitize=address,undefined")
  # Null pointers and bad addresses are AddressSanitizer's to catch; asked at every access they double the time that
  # Eigen's templates take to compile.
  set(unasked -fno-sanitize=null,alignment,object-size,vptr,nonnull-attribute,returns-nonnull-attribute,pointer-overflow)
  # GCC 12 with sanitizers takes std::regex's own members for uninitialised (GCC bug 105562).
  target_compile_options(muelle_flags INTERFACE -Wno-maybe-uninitialized)
  target_compile_options(muelle_flags INTERFACE ${MUELLE_SANITIZER_LINK_FLAG} ${unasked} -fno-sanitize-recover=all -g1
                                                -fno-omit-frame-pointer)
  # With the sanitizer Eigen aligns what it allocates by hand, and a student's file, which has none, would free the wrong
  # address: both as without.
  target_compile_definitions(muelle_flags INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
  target_link_options(muelle_flags INTERFACE ${MUELLE_SANITIZER_LINK_FLAG})
endif()

# mold links a student's file in a few hundredths of a second; without it the default linker does.
find_program(MUELLE_MOLD NAMES mold)
set(MUELLE_LINKER_FLAG "")
if(MUELLE_MOLD)
  set(MUELLE_LINKER_FLAG "-fuse-ld=mold")
  add_link_options(${MUELLE_LINKER_FLAG})
endif()

# A student's file: optimised a little, position independent for the worker's shared object, same for check and grade,
# so that both use one precompiled header. The standard library checks indices, as Eigen does.
# What nobody has written holds a pattern, and an Eigen object NaN, so that luck earns nothing; whoever shares Eigen
# objects with a student's file is compiled with the same define.
set(MUELLE_FILL_DEFINE EIGEN_INITIALIZE_MATRICES_BY_NAN)
set(MUELLE_STUDENT_FLAGS -std=c++20 -O1 -fPIC -Wall -Wextra -D_GLIBCXX_ASSERTIONS -D${MUELLE_FILL_DEFINE})
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-ftrivial-auto-var-init=pattern MUELLE_HAS_PATTERN_FILL)  # GCC 12, clang 8
if(MUELLE_HAS_PATTERN_FILL)
  list(APPEND MUELLE_STUDENT_FLAGS -ftrivial-auto-var-init=pattern)
endif()
# GCC takes what was never written for whatever another branch assigns, pattern or not, and then warns of nothing either;
# the pass that does so is of no use to what students write.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND MUELLE_STUDENT_FLAGS -fno-tree-fre)
  # Where a constructor begins, GCC takes what the object held for dead, the pattern too.
  list(APPEND MUELLE_STUDENT_FLAGS -flifetime-dse=1)
endif()
string(JOIN " " MUELLE_STUDENT_FLAGS_TEXT ${MUELLE_STUDENT_FLAGS})

# Defines NAME PATH ... as string literals for a target's sources: a path may have quotes.
function(muelle_define_paths target)
  while(ARGN)
    list(POP_FRONT ARGN name path)
    target_compile_definitions(${target} PRIVATE "${name}=R\"(${path})\"")
  endwhile()
endfunction()
