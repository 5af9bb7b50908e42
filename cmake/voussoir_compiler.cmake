# How our own code is compiled: warnings, sanitizers, ccache.
#
# voussoir_warnings is linked PRIVATE by every target of ours; it never reaches users of the library.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release or Debug" FORCE)
endif()
set(CMAKE_CXX_EXTENSIONS OFF)

find_program(VOUSSOIR_CCACHE ccache)
mark_as_advanced(VOUSSOIR_CCACHE)
if(VOUSSOIR_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${VOUSSOIR_CCACHE})
endif()

# CMake calls it a unity build. Names in the nameless namespaces of a folder must differ for it; who changes one file at a
# time, or has an editor that asks compile_commands.json for each of them, turns it off.
option(VOUSSOIR_FOLDERS_AS_ONE "Compile the sources of each folder as one" ON)
# Tests are compiled one by one, so that what helps one has no name that others must avoid: for them the headers of Trilinos
# are read once.
option(VOUSSOIR_PRECOMPILED_HEADERS "Read the headers of Trilinos once for all tests" ON)
set(VOUSSOIR_HEADERS_OF_TESTS <Teuchos_CommHelpers.hpp> <Teuchos_ParameterList.hpp> <Teuchos_UnitTestHarness.hpp> <Tpetra_Core.hpp>
                              <Tpetra_CrsMatrix.hpp> <Tpetra_MultiVector.hpp> <Tpetra_Vector.hpp> <functional> <map> <sstream>)
# Where a file is compiled otherwise than the headers were, it reads them itself.
set(CMAKE_PCH_WARN_INVALID OFF)

add_library(voussoir_warnings INTERFACE)
target_compile_options(voussoir_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
if(VOUSSOIR_WARNINGS_AS_ERRORS)
  target_compile_options(voussoir_warnings INTERFACE -Werror)
endif()

if(VOUSSOIR_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined)
  add_link_options(-fsanitize=address,undefined)
  # GCC 12 finds uninitialised memory in its own <regex> under sanitizers: https://gcc.gnu.org/PR105562
  target_compile_options(voussoir_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

if(VOUSSOIR_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# Trilinos names every library it can reach; record only those a program calls, or each start loads them all.
add_link_options(-Wl,--as-needed)
# Eighty programs are linked, each in a quarter of the time where this linker of binutils is there.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold VOUSSOIR_GOLD)
if(VOUSSOIR_GOLD)
  add_link_options(-fuse-ld=gold)
endif()
