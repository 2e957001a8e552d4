# Headers that most files include are compiled once. Every file includes what it needs all the same;
# -DMAHLWERK_PCH=OFF builds without.
#
#   standard   the standard library and {fmt}: the rooms below cases
#   case       these, a case and an outcome: cases and what uses it
#   test       these and GoogleTest: tests
set(standard_headers <algorithm> <array> <charconv> <chrono> <cmath> <cstdint> <filesystem> <fstream>
  <functional> <map> <memory> <mutex> <numbers> <numeric> <optional> <random> <set> <span> <sstream>
  <string> <string_view> <thread> <utility> <variant> <vector> <fmt/format.h>)
set(case_headers ${standard_headers} <mahlwerk/cases/case.hpp> <mahlwerk/results/outcome.hpp>)
set(test_headers ${case_headers} <gtest/gtest.h>)

# Makes the precompiled headers of a kind; the targets that use them must have the same flags.
function(mahlwerk_make_precompiled kind)
  if(NOT MAHLWERK_PCH)
    return()
  endif()
  set(source ${PROJECT_BINARY_DIR}/precompiled_${kind}.cpp)
  file(GENERATE OUTPUT ${source} CONTENT "")
  add_library(mahlwerk_precompiled_${kind} OBJECT ${source})
  target_link_libraries(mahlwerk_precompiled_${kind} PRIVATE mahlwerk_flags fmt::fmt ${ARGN})
  target_precompile_headers(mahlwerk_precompiled_${kind} PRIVATE ${${kind}_headers})
endfunction()

function(mahlwerk_precompiled target kind)
  if(MAHLWERK_PCH)
    target_link_libraries(${target} PRIVATE fmt::fmt)  # its flags are those of the headers
    target_precompile_headers(${target} REUSE_FROM mahlwerk_precompiled_${kind})
  endif()
endfunction()
