# The libraries of the build for browsers (web/), where nothing of the system can be linked: those that
# are headers, found in the system's folders and shown to the compiler through links, because its own
# headers of the C library must not meet the system's.
set(headers ${PROJECT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(part fmt toml++ nlohmann Random123 boost fast_float range concepts meta std)
  find_path(found_${part} ${part} PATHS /usr/include NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  file(CREATE_LINK ${found_${part}}/${part} ${headers}/${part} SYMBOLIC)
endforeach()
set(RANDOM123_INCLUDE ${headers})

# Files that need other libraries, or write files.
string(CONCAT MAHLWERK_LEFT_OUT "campaign/(calibrate|fit|search|store|surrogate|wear|sweep/.*work|sweep/campaign)"
  "|soft/device/"
  "|campaign/run/(resumable|streams)|lammps/program|results/files/(hdf5|result_file|writer)|report/(write|scripts|(fit|calibration|optimum)(_page)?|match|parameters|study_json|wear_evolution)[.]cpp"
  "|report/(campaign|record)/"
  "|commands/([a-z_]+[.]cpp|(reporting|campaigns|runs|searches|help)/)|/measure/")

function(header_library name)
  add_library(${name} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${name} INTERFACE ${headers})  # imported: as system headers
endfunction()
header_library(fmt::fmt)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
header_library(nlohmann_json::nlohmann_json)
header_library(Boost::headers)
add_library(Threads::Threads INTERFACE IMPORTED GLOBAL)

# toml++ is compiled once here.
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/toml.cpp
  CONTENT "#define TOML_IMPLEMENTATION\n#include <toml++/toml.h>\n")
add_library(mahlwerk_toml STATIC ${PROJECT_BINARY_DIR}/toml.cpp)
target_include_directories(mahlwerk_toml SYSTEM PUBLIC ${headers})
target_compile_definitions(mahlwerk_toml PUBLIC TOML_HEADER_ONLY=0)

# What its standard library lacks stands before every file (cmake/standard_library).
target_include_directories(mahlwerk_flags SYSTEM INTERFACE ${headers} ${PROJECT_SOURCE_DIR}/cmake/standard_library)
target_compile_definitions(mahlwerk_flags INTERFACE FMT_HEADER_ONLY)
target_compile_options(mahlwerk_flags INTERFACE "SHELL:-include missing.hpp" -fwasm-exceptions -msimd128
  -Wno-shorten-64-to-32)  # a size has 32 bits here
target_link_options(mahlwerk_flags INTERFACE -fwasm-exceptions)
