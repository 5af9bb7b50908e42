# cmake --install: the library, its headers in the layout of src/, and find_package(Voussoir).
include(CMakePackageConfigHelpers)
set(VOUSSOIR_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Voussoir)

install(TARGETS voussoir EXPORT VoussoirTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(
  DIRECTORY ${PROJECT_SOURCE_DIR}/src/
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/voussoir
  FILES_MATCHING
  PATTERN "*.hpp")
install(EXPORT VoussoirTargets NAMESPACE Voussoir:: DESTINATION ${VOUSSOIR_CMAKE_DIR})
write_basic_package_version_file(VoussoirConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/VoussoirConfig.cmake
              ${PROJECT_SOURCE_DIR}/cmake/voussoir_dependencies.cmake
              ${PROJECT_BINARY_DIR}/VoussoirConfigVersion.cmake DESTINATION ${VOUSSOIR_CMAKE_DIR})
