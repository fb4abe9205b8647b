# find_package(EnduringContacts): the layers, Enduring::chapter01 to Enduring::chapter10, and what they stand on.
include(${CMAKE_CURRENT_LIST_DIR}/packages.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/EnduringContactsTargets.cmake)
