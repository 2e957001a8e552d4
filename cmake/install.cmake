# What `cmake --install` copies. Components: program (with data, completions, manual pages, examples)
# and development (headers, libmahlwerk.a, package files for CMake and pkg-config). The program finds
# its data relative to its own place, and so do the package files: an installation can be moved.
#
#   cmake --build build/release --target installable && cmake --install build/release --prefix ...
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # tests and benchmarks are not installed
set(zsh_completions share/zsh/site-functions)
if(MAHLWERK_DEBIAN)
  set(zsh_completions share/zsh/vendor-completions)
  set(CMAKE_INSTALL_LIBDIR lib/${CMAKE_LIBRARY_ARCHITECTURE})
endif()
add_custom_target(installable)

# One library of all rooms: a user's program links Mahlwerk::mahlwerk alone.
set(objects "")
foreach(room ${MAHLWERK_ROOMS})
  list(APPEND objects $<TARGET_OBJECTS:mahlwerk_${room}>)
endforeach()
add_library(mahlwerk_library STATIC EXCLUDE_FROM_ALL ${objects})
set_target_properties(mahlwerk_library PROPERTIES LINKER_LANGUAGE CXX OUTPUT_NAME mahlwerk
  ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib EXPORT_NAME mahlwerk)
target_compile_features(mahlwerk_library INTERFACE cxx_std_20)
# Inline functions of the headers must have the bits of the library, for any -march of the user. The
# linker may also take the user's copy of such a function for the library's own calls.
target_compile_options(mahlwerk_library INTERFACE -ffp-contract=off
  $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi>)
target_include_directories(mahlwerk_library INTERFACE $<INSTALL_INTERFACE:include>)
add_dependencies(installable mahlwerk mahlwerk_library device_code)

# Manual pages and completions are what the program prints about itself.
set(texts ${PROJECT_BINARY_DIR}/texts)
set(made "")
find_program(GZIP_PROGRAM gzip)
function(mahlwerk_text file)  # file, arguments of the program
  list(JOIN ARGN " " arguments)
  set(command "\"$<TARGET_FILE:mahlwerk>\" ${arguments}")
  if(file MATCHES "[.]gz$")
    string(APPEND command " | \"${GZIP_PROGRAM}\" -9n")
  endif()
  cmake_path(GET file PARENT_PATH folder)
  add_custom_command(OUTPUT ${texts}/${file} DEPENDS mahlwerk VERBATIM
    COMMAND ${CMAKE_COMMAND} -E make_directory ${texts}/${folder}
    COMMAND sh -c "set -e; ${command} > \"${texts}/${file}\"")
  set(made ${made} ${texts}/${file} PARENT_SCOPE)
endfunction()
set(page_end "")
if(GZIP_PROGRAM)
  set(page_end .gz)
endif()
file(STRINGS ${PROJECT_SOURCE_DIR}/src/mahlwerk/commands/commands.cpp names REGEX "^ .*_command\\(\\)[,}]")
string(REGEX MATCHALL "[a-z_]+_command" names "${names}")
list(REMOVE_DUPLICATES names)
mahlwerk_text(man1/mahlwerk.1${page_end} manual)
foreach(name ${names})
  string(REPLACE _command "" name ${name})
  string(REPLACE _ - name ${name})
  mahlwerk_text(man1/mahlwerk-${name}.1${page_end} manual ${name})
endforeach()
mahlwerk_text(bash/mahlwerk completion bash)
mahlwerk_text(zsh/_mahlwerk completion zsh)
add_custom_target(mahlwerk_texts DEPENDS ${made})
add_dependencies(installable mahlwerk_texts)

install(TARGETS mahlwerk RUNTIME DESTINATION bin COMPONENT program)
install(DIRECTORY ${texts}/man1 DESTINATION share/man COMPONENT program)
install(FILES ${texts}/bash/mahlwerk DESTINATION share/bash-completion/completions
  COMPONENT program)
install(FILES ${texts}/zsh/_mahlwerk DESTINATION ${zsh_completions} COMPONENT program)
install(DIRECTORY ${PROJECT_BINARY_DIR}/share/mahlwerk/device DESTINATION share/mahlwerk
  COMPONENT program OPTIONAL FILES_MATCHING PATTERN "*.ptx")  # where clang has made it
install(DIRECTORY catalogue papers validation examples DESTINATION share/mahlwerk
  COMPONENT program PATTERN __pycache__ EXCLUDE)
# The documents, with the folders that they link to beside them.
install(FILES README.md CONTRIBUTING.md SUPPORT.md SECURITY.md CITATION.cff DESTINATION share/doc/mahlwerk
  COMPONENT program)
install(DIRECTORY docs DESTINATION share/doc/mahlwerk COMPONENT program
  FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN "*.png" PATTERN site EXCLUDE)
install(CODE "
  set(documents \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/share/doc/mahlwerk\")
  foreach(part catalogue papers validation examples)
    file(CREATE_LINK ../../mahlwerk/\${part} \"\${documents}/\${part}\" SYMBOLIC)
    list(APPEND CMAKE_INSTALL_MANIFEST_FILES \"\${CMAKE_INSTALL_PREFIX}/share/doc/mahlwerk/\${part}\")
  endforeach()" COMPONENT program)
if(NOT MAHLWERK_DEBIAN)  # its packages have one file with both
  install(FILES LICENSE packaging/debian/copyright CHANGELOG.md DESTINATION share/doc/mahlwerk
    COMPONENT program)
endif()

install(TARGETS mahlwerk_library EXPORT Mahlwerk ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  COMPONENT development)
# CMake strips programs, but not static libraries.
install(CODE "
  if(CMAKE_INSTALL_DO_STRIP)
    execute_process(COMMAND \"${CMAKE_STRIP}\" --strip-unneeded -R .comment
      \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/libmahlwerk.a\"
      COMMAND_ERROR_IS_FATAL ANY)
  endif()" COMPONENT development)
install(DIRECTORY src/mahlwerk DESTINATION include COMPONENT development
  FILES_MATCHING PATTERN "*.hpp")
set(config ${CMAKE_INSTALL_LIBDIR}/cmake/Mahlwerk)
install(EXPORT Mahlwerk NAMESPACE Mahlwerk:: FILE MahlwerkTargets.cmake DESTINATION ${config}
  COMPONENT development)
set(data_folder share/mahlwerk)
configure_package_config_file(cmake/MahlwerkConfig.cmake.in texts/MahlwerkConfig.cmake
  INSTALL_DESTINATION ${config} PATH_VARS data_folder)
# A new minor version may change the interface (docs/developers/releases.md).
write_basic_package_version_file(texts/MahlwerkConfigVersion.cmake COMPATIBILITY SameMinorVersion)
file(RELATIVE_PATH MAHLWERK_PREFIX_FROM_PC
  /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
find_package(PkgConfig QUIET)
pkg_search_module(MAHLWERK_HDF5 QUIET hdf5-serial hdf5)  # Debian's hdf5 may be the one for MPI
set(MAHLWERK_HDF5_MODULE ${MAHLWERK_HDF5_MODULE_NAME})
configure_file(cmake/mahlwerk.pc.in texts/mahlwerk.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/texts/MahlwerkConfig.cmake
  ${PROJECT_BINARY_DIR}/texts/MahlwerkConfigVersion.cmake DESTINATION ${config}
  COMPONENT development)
install(FILES ${PROJECT_BINARY_DIR}/texts/mahlwerk.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
