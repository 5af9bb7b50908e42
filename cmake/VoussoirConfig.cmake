# find_package(Voussoir) gives the target Voussoir::voussoir; include its headers as "mesh/mesh.hpp".
include(${CMAKE_CURRENT_LIST_DIR}/voussoir_dependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/VoussoirTargets.cmake)
