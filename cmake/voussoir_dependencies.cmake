# The libraries Voussoir stands on, as targets Voussoir::trilinos, ::hdf5, ::metis, ::ptscotch, ::gmsh, ::cholmod, ::umfpack,
# ::mumps, ::clp, ::openmp.
# Used by the build and, installed, by find_package(Voussoir).

find_package(MPI REQUIRED COMPONENTS CXX)
find_package(nlohmann_json 3 REQUIRED)
find_package(CLI11 2 REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(pugixml 1.11 REQUIRED)
find_package(Trilinos 13 REQUIRED COMPONENTS MueLu Ifpack2 Zoltan2 Belos Xpetra Tpetra Sacado Kokkos Teuchos)

# Makes an imported target from one header and one library; names what to install when they are missing.
function(voussoir_find_library name header library package)
  cmake_parse_arguments(PARSE_ARGV 4 arg "" "" "HEADER_PATHS")
  if(TARGET Voussoir::${name})
    return()
  endif()
  find_path(VOUSSOIR_${name}_INCLUDE_DIR ${header} HINTS ${arg_HEADER_PATHS})
  find_library(VOUSSOIR_${name}_LIBRARY ${library})
  mark_as_advanced(VOUSSOIR_${name}_INCLUDE_DIR VOUSSOIR_${name}_LIBRARY)
  if(NOT VOUSSOIR_${name}_INCLUDE_DIR OR NOT VOUSSOIR_${name}_LIBRARY)
    message(FATAL_ERROR "Voussoir needs ${header} and lib${library}, which were not found.\n"
                        "On Debian: apt-get install ${package}")
  endif()
  add_library(Voussoir::${name} UNKNOWN IMPORTED)
  set_target_properties(
    Voussoir::${name} PROPERTIES IMPORTED_LOCATION ${VOUSSOIR_${name}_LIBRARY}
                                 INTERFACE_INCLUDE_DIRECTORIES ${VOUSSOIR_${name}_INCLUDE_DIR})
endfunction()

voussoir_find_library(hdf5 hdf5.h hdf5_openmpi libhdf5-openmpi-dev HEADER_PATHS /usr/include/hdf5/openmpi)
voussoir_find_library(metis metis.h metis libmetis-dev)
# What PT-Scotch calls lies in two more libraries beside it.
voussoir_find_library(scotch scotch.h scotch libscotch-dev HEADER_PATHS /usr/include/scotch)
voussoir_find_library(ptscotcherr ptscotch.h ptscotcherr libptscotch-dev HEADER_PATHS /usr/include/scotch)
voussoir_find_library(ptscotch ptscotch.h ptscotch libptscotch-dev HEADER_PATHS /usr/include/scotch)
set_property(TARGET Voussoir::ptscotch APPEND PROPERTY INTERFACE_LINK_LIBRARIES Voussoir::scotch Voussoir::ptscotcherr)
voussoir_find_library(gmsh gmsh.h gmsh libgmsh-dev)
voussoir_find_library(cholmod suitesparse/cholmod.h cholmod libsuitesparse-dev)
voussoir_find_library(umfpack suitesparse/umfpack.h umfpack libsuitesparse-dev)
voussoir_find_library(mumps dmumps_c.h dmumps libmumps-dev)
# Linear programmes; CLP's headers need those of CoinUtils, which lie beside them.
voussoir_find_library(coinutils CoinPackedMatrix.hpp CoinUtils coinor-libcoinutils-dev HEADER_PATHS /usr/include/coin)
voussoir_find_library(clp ClpSimplex.hpp Clp coinor-libclp-dev HEADER_PATHS /usr/include/coin)
set_property(TARGET Voussoir::clp APPEND PROPERTY INTERFACE_LINK_LIBRARIES Voussoir::coinutils)

# CHOLMOD's threads are told to stay away: only the library, no pragmas.
find_package(OpenMP REQUIRED COMPONENTS CXX)
if(NOT TARGET Voussoir::openmp)
  add_library(Voussoir::openmp INTERFACE IMPORTED)
  target_link_libraries(Voussoir::openmp INTERFACE ${OpenMP_CXX_LIBRARIES})
endif()

# Trilinos' own targets carry no MPI and do not mark their headers as system headers.
if(NOT TARGET Voussoir::trilinos)
  add_library(Voussoir::trilinos INTERFACE IMPORTED)
  target_include_directories(Voussoir::trilinos SYSTEM INTERFACE ${Trilinos_INCLUDE_DIRS})
  target_link_libraries(Voussoir::trilinos INTERFACE ${Trilinos_LIBRARIES} MPI::MPI_CXX)
  # The C++ bindings of MPI were withdrawn in 2012; nobody here calls them.
  target_compile_definitions(Voussoir::trilinos INTERFACE OMPI_SKIP_MPICXX=1)
endif()
