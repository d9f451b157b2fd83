# The sources of one folder of a target are compiled together (CMake's unity build): half of what a small one takes goes
# into what all of them include. Each compiles alone, too (preset plain). For work on a few: -D MUELLE_TOGETHER=OFF.
option(MUELLE_TOGETHER "Compile the sources of a folder together" ON)
set(CMAKE_UNITY_BUILD ${MUELLE_TOGETHER})  # what targets begin with; in the cache it would outlive the option

# Not where everyone adds sources (exercises), whose names need not differ from each other's, nor where large templates
# take the time, nor in what a student's program links: it takes no object but those that it calls, and may bring a
# function of its own in place of ours. Call it before targets are added, or name those that are.
macro(muelle_compile_one_by_one)
  set(targets ${ARGN})
  if(targets)
    set_target_properties(${targets} PROPERTIES UNITY_BUILD OFF)
  else()
    set(CMAKE_UNITY_BUILD OFF)
  endif()
endmacro()

# What a student's program links, as above; not in a student's tree, where the first check would wait twice as long.
macro(muelle_compile_for_students)
  if(NOT MUELLE_STUDENTS_TREE)
    muelle_compile_one_by_one(${ARGN})
  endif()
endmacro()

# The sources of one folder of a target, by their absolute paths: a relative one would be looked for below the caller's
# folder, and be in no group. A group has the target's name, as two programs' objects may stand side by side. More than
# ten sources would take too long; they part at the middle of the alphabet, so that a new one moves no other. In a
# student's tree all sources of a target are together: there the time of all is what counts.
function(muelle_group target folder)
  list(LENGTH ARGN count)
  string(REGEX REPLACE "/$" "" folder "${target}${folder}")
  foreach(source IN LISTS ARGN)
    get_filename_component(name ${source} NAME)
    set(half "")
    if(count GREATER 10 AND NOT MUELLE_STUDENTS_TREE AND name MATCHES "^[a-m]")
      set(half "/a_to_m")
    endif()
    string(MAKE_C_IDENTIFIER "${folder}${half}" group)
    set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()

# For a target whose sources are all known. By folder and not by number: a new source changes nothing elsewhere.
function(muelle_group_by_folder target)
  get_target_property(sources ${target} SOURCES)
  get_target_property(own_folder ${target} SOURCE_DIR)
  set(folders "")
  foreach(source IN LISTS sources)
    if(source MATCHES "[.]cpp$")
      get_filename_component(source ${source} ABSOLUTE BASE_DIR ${own_folder})
      get_filename_component(folder ${source} DIRECTORY)
      file(RELATIVE_PATH folder ${own_folder} ${folder})
      if(MUELLE_STUDENTS_TREE)
        set(folder "")
      endif()
      list(APPEND folders "/${folder}")
      list(APPEND "in/${folder}" ${source})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder IN LISTS folders)
    list(LENGTH "in${folder}" count)
    if(count GREATER 1)
      muelle_group(${target} ${folder} ${in${folder}})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

function(muelle_group_all_by_folder)
  muelle_targets_below(${CMAKE_SOURCE_DIR} targets)
  foreach(target IN LISTS targets)
    get_target_property(together ${target} UNITY_BUILD)
    if(together)
      muelle_group_by_folder(${target})
    endif()
  endforeach()
endfunction()
