# Packages of Debian, one for each component of cmake/install.cmake that exists: `cpack -G DEB`.
# tools/make_packages builds them.
set(MAHLWERK_MAINTAINER "The Mahlwerk authors <authors@mahlwerk.invalid>" CACHE STRING
  "name and address in the packages of Debian")
set(version ${PROJECT_VERSION}-1)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mahlwerk)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT ${MAHLWERK_MAINTAINER})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${MAHLWERK_MAINTAINER})
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS OFF)

set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME mahlwerk)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "python3-mahlwerk, python3-matplotlib")  # papers
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "simulator of ball mills
Mahlwerk computes how often the balls of a mill hit, how hard, at which angle
and where, from a short text file that names mill, jar, balls and speed. From
the collisions it calculates power, wear, temperatures and particle sizes. It
has an event engine and a soft engine (discrete element method).")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libmahlwerk-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "mahlwerk (= ${version}), libtomlplusplus-dev, \
libfmt-dev, libhdf5-dev, libnlopt-dev, libsqlite3-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "simulator of ball mills - library for C++
Headers and static library of Mahlwerk, with the package files for CMake
(find_package(Mahlwerk), target Mahlwerk::mahlwerk) and pkg-config.")

set(packages mahlwerk libmahlwerk-dev)
set(components program development)
if(TARGET mahlwerk_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  list(APPEND packages python3-mahlwerk)
  list(APPEND components python)
  add_dependencies(installable mahlwerk_python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-mahlwerk)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(scripts ${PROJECT_SOURCE_DIR}/packaging/debian/python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${scripts}/postinst ${scripts}/prerm)
  # The compiled module belongs to one minor version of Python.
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "mahlwerk (= ${version}), python3-numpy")
  if(Python_VERSION_MINOR)
    math(EXPR next "${Python_VERSION_MINOR} + 1")
    string(APPEND CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      ", python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next})")
  endif()
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas, python3-matplotlib, python3-xarray, python3-uncertainties")
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "simulator of ball mills - Python module
Reads, changes and runs cases of Mahlwerk from Python and gives its results as
arrays and tables.")
endif()

# Copyright and changelogs of each package, as Debian's policy demands, and what lintian reports without reason.
if(MAHLWERK_DEBIAN)
  set(folder ${PROJECT_BINARY_DIR}/texts/debian)
  configure_file(packaging/debian/changelog.in ${folder}/changelog.Debian @ONLY)
  configure_file(CHANGELOG.md ${folder}/changelog COPYONLY)
  add_custom_command(OUTPUT ${folder}/changelog.gz ${folder}/changelog.Debian.gz
    COMMAND ${GZIP_PROGRAM} -9nkf changelog changelog.Debian
    DEPENDS ${folder}/changelog ${folder}/changelog.Debian WORKING_DIRECTORY ${folder} VERBATIM)
  add_custom_target(mahlwerk_changelogs
    DEPENDS ${folder}/changelog.gz ${folder}/changelog.Debian.gz)
  add_dependencies(installable mahlwerk_changelogs)
  foreach(package component IN ZIP_LISTS packages components)
    install(FILES packaging/debian/copyright ${folder}/changelog.gz ${folder}/changelog.Debian.gz
      DESTINATION share/doc/${package} COMPONENT ${component})
    configure_file(packaging/debian/lintian-overrides.in ${folder}/overrides/${package} @ONLY)
    install(FILES ${folder}/overrides/${package} DESTINATION share/lintian/overrides COMPONENT ${component})
  endforeach()
endif()
include(CPack)
