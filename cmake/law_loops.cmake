# The innermost loops of the soft engine are compiled for each law, which is the type in
# contact/laws/<law>.hpp named as its file: hertz_mindlin.hpp has HertzMindlin. They are explicit
# vectors, to which -O3 adds time of the compiler only (docs/performance.md), as does the allocation of
# registers loop by loop: without it they have fewer instructions. contact/laws.cpp checks that the
# list of laws has as many as there are files.
function(mahlwerk_law_loops)
  file(GLOB laws CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/contact/laws/*.hpp)
  foreach(law ${laws})
    cmake_path(GET law STEM file)
    string(REPLACE "_" ";" words ${file})
    set(type "")
    foreach(word ${words})
      string(SUBSTRING ${word} 0 1 first)
      string(SUBSTRING ${word} 1 -1 rest)
      string(TOUPPER ${first} first)
      string(APPEND type ${first}${rest})
    endforeach()
    set(loops ${CMAKE_CURRENT_BINARY_DIR}/soft/law_loops_${file}.cpp)
    configure_file(soft/law_loops.cpp.in ${loops} @ONLY)
    target_sources(mahlwerk_soft PRIVATE ${loops})
    set_source_files_properties(${loops} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON
      COMPILE_OPTIONS "$<$<CONFIG:Release>:-O1>;$<$<CXX_COMPILER_ID:GNU>:-fira-region=one>")
  endforeach()
  list(LENGTH laws count)
  set_source_files_properties(contact/laws.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON
    COMPILE_DEFINITIONS MAHLWERK_LAW_FILES=${count})
endfunction()
