# Files of a folder are compiled together, up to eight at a time: headers are read and templates
# are made once for all of them. A name in an anonymous namespace therefore stands once in its
# folder. -DMAHLWERK_BATCHES=OFF compiles each file by itself, which suits who changes one again and
# again. Files that make a template for one shape are large enough by themselves; so are those that
# CMake makes for each law (src/mahlwerk/CMakeLists.txt).
function(mahlwerk_batches target)
  if(NOT MAHLWERK_BATCHES)
    return()
  endif()
  set(files ${ARGN})
  list(SORT files)
  set(last "")
  foreach(file ${files})
    if(file MATCHES "/engine_[^/]*$")
      set_source_files_properties(${file} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
      continue()
    endif()
    cmake_path(GET file PARENT_PATH folder)
    if(NOT folder STREQUAL last)
      set(last ${folder})
      set(count 0)
      cmake_path(GET folder FILENAME name)
    endif()
    math(EXPR batch "${count} / 8")
    math(EXPR count "${count} + 1")
    set_source_files_properties(${file} PROPERTIES UNITY_GROUP ${name}_${batch})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
