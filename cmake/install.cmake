# `cmake --install`, and what find_package(EnduringContacts) then reads. Scenes and meshes stay where the sources are.
include(CMakePackageConfigHelpers)
set(ENDURING_PACKAGE ${CMAKE_INSTALL_LIBDIR}/cmake/EnduringContacts)
install(TARGETS enduring_options EXPORT EnduringContactsTargets)
install(EXPORT EnduringContactsTargets NAMESPACE Enduring:: DESTINATION ${ENDURING_PACKAGE})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/EnduringContactsConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/EnduringContactsConfig.cmake cmake/packages.cmake cmake/packages.txt ${CMAKE_CURRENT_BINARY_DIR}/EnduringContactsConfigVersion.cmake
        DESTINATION ${ENDURING_PACKAGE})
