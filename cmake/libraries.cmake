# The libraries of a native build, from the system.
find_package(Threads REQUIRED)
find_package(tomlplusplus 3.3 CONFIG REQUIRED)
find_package(nlohmann_json 3.11 CONFIG REQUIRED)
find_package(CLI11 2.1 CONFIG REQUIRED)
find_package(fmt 9 CONFIG REQUIRED)
find_package(Eigen3 3.4 CONFIG REQUIRED)
find_package(NLopt 2.7 CONFIG REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(SQLite3 3.35 REQUIRED)
find_package(HDF5 1.10 REQUIRED COMPONENTS C)
find_path(RANDOM123_INCLUDE Random123/philox.h REQUIRED)
find_library(TOMLPLUSPLUS_LIBRARY tomlplusplus REQUIRED)

# toml++ as the compiled library: its header-only form costs three seconds a file.
add_library(mahlwerk_toml INTERFACE)
target_compile_definitions(mahlwerk_toml INTERFACE TOML_HEADER_ONLY=0)
target_link_libraries(mahlwerk_toml INTERFACE ${TOMLPLUSPLUS_LIBRARY})

set(MAHLWERK_CAMPAIGN_LIBRARIES Eigen3::Eigen NLopt::nlopt SQLite::SQLite3)
set(MAHLWERK_RESULTS_LIBRARIES HDF5::HDF5)
