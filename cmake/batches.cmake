# Files of a folder are compiled together, up to sixteen at a time, or eight where these are tests:
# headers are read and templates are made once for all of them. A name in an anonymous namespace
# therefore stands once in its folder; tests have a namespace for each file. -DMAHLWERK_BATCHES=OFF
# compiles each file by itself, which suits who changes one again and again. Files that make the
# event engine for one shape are large enough by themselves; so are those that CMake makes for each
# law (src/mahlwerk/CMakeLists.txt). Files that include a register form batches of their own, so that
# a changed model recompiles these and leaves the rest of the folder; which files do is read when
# CMake configures.
set(mahlwerk_registers "mahlwerk/(geometry/shapes|kinematics/motions|contact/laws|powder/models)[.]hpp")
function(mahlwerk_batches target size)
  if(NOT MAHLWERK_BATCHES)
    return()
  endif()
  set(files ${ARGN})
  list(SORT files)
  set(folders "")
  foreach(file ${files})
    if(file MATCHES "/event/engine_[^/]*$")
      set_source_files_properties(${file} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
      continue()
    endif()
    cmake_path(GET file PARENT_PATH folder)
    cmake_path(GET folder FILENAME name)
    file(STRINGS ${file} register REGEX "#include \"${mahlwerk_registers}\"")
    if(register)
      string(APPEND name _models)
    endif()
    if(NOT name IN_LIST folders)
      list(APPEND folders ${name})
      set(count_${name} 0)
    endif()
    math(EXPR batch "${count_${name}} / ${size}")
    math(EXPR count_${name} "${count_${name}} + 1")
    set_source_files_properties(${file} PROPERTIES UNITY_GROUP ${name}_${batch})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
