# Cross-compiles for ARM64 with Debian's g++-aarch64-linux-gnu. MAHLWERK_SYSROOT is a folder with the
# libraries of that architecture; tools/check_aarch64 makes it, builds, and runs the program under QEMU.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES MAHLWERK_SYSROOT)
set(CMAKE_SYSROOT ${MAHLWERK_SYSROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L ${MAHLWERK_SYSROOT})
# The folder with links of Debian's libhdf5-dev, instead of asking the h5cc of this machine.
set(HDF5_ROOT ${MAHLWERK_SYSROOT}/usr/lib/aarch64-linux-gnu/hdf5/serial)
