# The sources of one folder of a target are compiled together: half of what a small one takes goes into what all of them
# include. Each compiles alone, too (preset plain). For work on a few sources: -D CMAKE_UNITY_BUILD=OFF.
set(CMAKE_UNITY_BUILD ON CACHE BOOL "Compile the sources of a folder together")

# Not where everyone adds sources (exercises, figures), whose names need not differ from each other's, nor where large
# templates take the time. Call it before targets are added.
macro(muelle_compile_one_by_one)
  set(CMAKE_UNITY_BUILD OFF)
endmacro()

# By folder and not by number, so that a new source changes nothing elsewhere. For a target whose sources are all known.
function(muelle_group_by_folder target)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    if(source MATCHES "[.]cpp$")
      get_filename_component(folder ${source} DIRECTORY)
      string(MAKE_C_IDENTIFIER "${target}_${folder}" group)
      set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

function(muelle_group_all_by_folder)
  muelle_targets_below(${CMAKE_SOURCE_DIR} targets)
  foreach(target ${targets})
    get_target_property(together ${target} UNITY_BUILD)
    if(together)
      muelle_group_by_folder(${target})
    endif()
  endforeach()
endfunction()
