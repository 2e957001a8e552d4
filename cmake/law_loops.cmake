# Compiles the innermost loops of the soft engine for each law. The type of a law is named after its
# file in contact/laws/: hertz_mindlin.hpp defines HertzMindlin. contact/laws.cpp checks that the list of
# laws has as many entries as there are files. By measurement (docs/performance.md) -O2 runs 1.2 to 1.5
# times as fast as -O1, -O3 adds compile time only, and -fira-region=one, which disables register
# allocation by loop, saves compile time. Of the sanitizer presets, some checks of undefined behaviour are
# made at each access to a vector: the loops would take five times as long to compile (clang: 28 instead
# of 6 CPU s a law), so they are left out here.
# The type that is named after a file: hertz_mindlin gives HertzMindlin.
function(mahlwerk_type_of file type)
  string(REPLACE "_" ";" words ${file})
  set(joined "")
  foreach(word ${words})
    string(SUBSTRING ${word} 0 1 first)
    string(SUBSTRING ${word} 1 -1 rest)
    string(TOUPPER ${first} first)
    string(APPEND joined ${first}${rest})
  endforeach()
  set(${type} ${joined} PARENT_SCOPE)
endfunction()

function(mahlwerk_law_loops)
  file(GLOB laws CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/contact/laws/*.hpp)
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=[a-z,]*undefined")
    set(fewer_checks
      -fno-sanitize=alignment,null,object-size,vptr,pointer-overflow,signed-integer-overflow)
  endif()
  foreach(law ${laws})
    cmake_path(GET law STEM file)
    mahlwerk_type_of(${file} type)
    set(device_header "")
    set(device_kernels "")
    if(NOT EMSCRIPTEN)
      set(device_header "#include \"mahlwerk/soft/device/law_kernels.hpp\"")
      set(device_kernels "template LawKernels law_kernels<contact::${type}>();")
    endif()
    set(loops ${CMAKE_CURRENT_BINARY_DIR}/soft/law_loops_${file}.cpp)
    configure_file(soft/law_loops.cpp.in ${loops} @ONLY)
    target_sources(mahlwerk_soft PRIVATE ${loops})
    set_source_files_properties(${loops} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON
      COMPILE_OPTIONS "$<$<CONFIG:Release>:-O2>;$<$<CXX_COMPILER_ID:GNU>:-fira-region=one;-Wno-maybe-uninitialized>;${fewer_checks}")
  endforeach()
  list(LENGTH laws count)
  set_source_files_properties(contact/laws.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON
    COMPILE_DEFINITIONS MAHLWERK_LAW_FILES=${count})
endfunction()
