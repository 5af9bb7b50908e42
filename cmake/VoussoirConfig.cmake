# find_package(Voussoir) gives the target Voussoir::voussoir; include its headers as "mesh/mesh.hpp".
# Trilinos is built without compiler extensions and warns users who leave them on.
set(CMAKE_CXX_EXTENSIONS OFF)
include(${CMAKE_CURRENT_LIST_DIR}/voussoir_dependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/VoussoirTargets.cmake)
