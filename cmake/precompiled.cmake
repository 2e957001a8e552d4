# Precompiled headers: headers that most files include are compiled once. Every file still includes
# all headers that it needs; -DMAHLWERK_PCH=OFF builds without precompiled headers.
#
#   standard   the standard library and {fmt}; for the folders on which cases depends
#   case       standard, a case and an outcome; for cases and the folders that use it
#   test       case and GoogleTest; for tests
set(standard_headers <algorithm> <array> <charconv> <chrono> <cmath> <cstdint> <filesystem> <fstream>
  <functional> <map> <memory> <mutex> <numbers> <numeric> <optional> <random> <set> <span> <sstream>
  <string> <string_view> <thread> <utility> <variant> <vector> <fmt/format.h>)
set(case_headers ${standard_headers} <mahlwerk/cases/case.hpp> <mahlwerk/results/outcome.hpp>)
set(test_headers ${case_headers} <gtest/gtest.h>)

# Creates the precompiled headers of a kind. Targets that use them must have the same flags.
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
    target_link_libraries(${target} PRIVATE fmt::fmt)  # same flags as the headers
    target_precompile_headers(${target} REUSE_FROM mahlwerk_precompiled_${kind})
  endif()
endfunction()
