# The kernels of the soft engine as PTX, which the driver of a graphics card compiles for the card it
# finds. Clang alone makes it, without CUDA's toolkit; no header or library of CUDA is needed. A module
# for each law and each shape, so that a run loads what it needs. A target of its own, not part of the
# program: `./mahlwerk device`, packages and tests build it. Products and sums stay separate
# (-ffp-contract=off), so that a card has the bits of the host.
find_program(MAHLWERK_CLANG NAMES clang++ clang++-19 clang++-16 clang++-15 clang++-14)
mark_as_advanced(MAHLWERK_CLANG)
option(MAHLWERK_DEVICE_CODE "compile the code for graphics cards, where there is clang" ON)
add_custom_target(device_code)
if(NOT MAHLWERK_CLANG OR NOT MAHLWERK_DEVICE_CODE)
  return()
endif()

function(mahlwerk_device_module name template file type)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/device/${name}.cu)
  set(module ${PROJECT_BINARY_DIR}/share/mahlwerk/device/${name}.ptx)
  configure_file(${PROJECT_SOURCE_DIR}/src/mahlwerk/soft/device/${template} ${source} @ONLY)
  add_custom_command(OUTPUT ${module} DEPENDS ${source} DEPFILE ${source}.d VERBATIM
    COMMENT "Building device code ${name}.ptx"
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/share/mahlwerk/device
    COMMAND ${MAHLWERK_CLANG} -std=c++20 -O3 -x cuda --cuda-device-only -S --cuda-gpu-arch=sm_80
      -nocudainc -nocudalib -ffp-contract=off -Xclang -fcuda-allow-variadic-functions
      -Wno-unknown-cuda-version -mllvm -inline-threshold=1000000
      -I ${PROJECT_SOURCE_DIR}/src -MD -MT ${module} -MF ${source}.d ${source} -o ${module})
  add_custom_target(device_code_${name} DEPENDS ${module})
  add_dependencies(device_code device_code_${name})
endfunction()

mahlwerk_device_module(common common.cu common "")
foreach(kind laws shapes)
  if(kind STREQUAL laws)
    file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/mahlwerk/contact/laws/*.hpp)
    set(template law.cu.in)
  else()
    set(files attritor box capsule cylinder lifter_cylinder mesh periodic_box periodic_cylinder
      periodic_lifter_cylinder
      rounded_cylinder sphere)
    set(template shape.cu.in)
  endif()
  foreach(path ${files})
    cmake_path(GET path STEM file)
    mahlwerk_type_of(${file} type)
    mahlwerk_device_module(${file} ${template} ${file} ${type})
  endforeach()
endforeach()
