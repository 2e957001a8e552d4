# Unity build: up to sixteen files of a folder are compiled together, or eight in tests, so that
# headers are parsed and templates instantiated once for all of them. A name in an anonymous namespace
# must therefore be unique in its folder, or in the room if its folders are compiled TOGETHER; tests
# have a namespace for each file.
# -DMAHLWERK_BATCHES=OFF compiles each file separately, which is faster while one file is edited
# repeatedly. Files that instantiate the event engine for one shape are compiled separately, and so
# are those that CMake generates for each law (src/mahlwerk/CMakeLists.txt). Files that include a
# register form separate batches, so that a changed model recompiles only these. CMake finds these
# files at configuration.
set(mahlwerk_registers "mahlwerk/(geometry/shapes|kinematics/motions|contact/laws|powder/models)[.]hpp")
function(mahlwerk_batches target size)
  if(NOT MAHLWERK_BATCHES)
    return()
  endif()
  cmake_parse_arguments(BATCH "TOGETHER" "" "" ${ARGN})
  set(files ${BATCH_UNPARSED_ARGUMENTS})
  list(SORT files)
  set(folders "")
  foreach(file ${files})
    if(file MATCHES "/event/engine_[^/]*$")
      set_source_files_properties(${file} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
      continue()
    endif()
    cmake_path(GET file PARENT_PATH folder)
    cmake_path(GET folder FILENAME name)
    if(BATCH_TOGETHER)
      set(name all)
    elseif(file MATCHES "/mahlwerk/parts/")  # folders of one or two files, each with a namespace
      set(name parts)
    endif()
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
