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

# Half the time of most source files goes into reading the headers of Trilinos: they are read once. Every file includes
# what it uses, so this may be turned off: ccache then serves all copies of the sources with what one has compiled.
option(VOUSSOIR_PRECOMPILED_HEADERS "Read the headers of Trilinos once for all files" ON)
set(VOUSSOIR_HEADERS_OF_LIBRARY <Teuchos_CommHelpers.hpp> <Teuchos_ParameterList.hpp> <Tpetra_CrsMatrix.hpp>
                                <Tpetra_MultiVector.hpp> <Tpetra_Vector.hpp> <functional> <map> <sstream>)
set(VOUSSOIR_HEADERS_OF_TESTS ${VOUSSOIR_HEADERS_OF_LIBRARY} <Teuchos_UnitTestHarness.hpp> <Tpetra_Core.hpp>)
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
