# Finds the outside libraries. What is missing is told with its line of packages.txt, the one list of packages.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/packages.txt ENDURING_PACKAGES)

function(enduring_need found package)  # one more argument: a way to do without
  set(lines ${ENDURING_PACKAGES})
  list(FILTER lines INCLUDE REGEX " ${package} ")
  if(NOT lines)
    message(FATAL_ERROR "cmake/packages.txt does not name ${package}")
  elseif(NOT ${found})
    string(REGEX REPLACE "^[a-z]+ +[^ ]+ +" "" what "${lines}")
    message(FATAL_ERROR "${package} was not found: ${what}. On Debian: ./course setup, or apt-get install ${package} ${ARGN}")
  endif()
endfunction()

find_package(PkgConfig QUIET)
enduring_need(PkgConfig_FOUND pkg-config)

find_package(Eigen3 3.4 QUIET NO_MODULE)
enduring_need(Eigen3_FOUND libeigen3-dev)

find_package(nlohmann_json QUIET)
enduring_need(nlohmann_json_FOUND nlohmann-json3-dev)

# Bullet in double precision. CMake's own FindBullet picks the float libraries, which double headers misread silently.
pkg_check_modules(BULLET QUIET IMPORTED_TARGET bullet-float64)
enduring_need(BULLET_FOUND libbullet-extras-dev)

find_package(Boost QUIET CONFIG)
enduring_need(Boost_FOUND libboost-dev)

find_path(CHOLMOD_INCLUDE cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
enduring_need(CHOLMOD_LIBRARY libsuitesparse-dev)

if(NOT PROJECT_NAME STREQUAL EnduringContacts OR NOT PROJECT_IS_TOP_LEVEL)
  return()  # what follows is for the course itself: tests, command lines, pictures
endif()
find_package(doctest QUIET)
enduring_need(doctest_FOUND doctest-dev)
include(doctest)

find_package(CLI11 QUIET)
enduring_need(CLI11_FOUND libcli11-dev)

find_package(pugixml QUIET)
enduring_need(pugixml_FOUND libpugixml-dev)

if(ENDURING_RENDER)
  find_library(OSMESA_LIBRARY OSMesa)
  find_library(EGL_LIBRARY EGL)
  find_library(OPENGL_LIBRARY NAMES OpenGL GL)
  set(ENDURING_osmesa_LIBRARIES ${OSMESA_LIBRARY})
  set(ENDURING_egl_LIBRARIES ${EGL_LIBRARY} ${OPENGL_LIBRARY})
  set(ENDURING_CONTEXTS "")  # what can draw without a screen, the preferred one first
  if(OSMESA_LIBRARY)
    list(APPEND ENDURING_CONTEXTS osmesa)
  endif()
  if(EGL_LIBRARY AND OPENGL_LIBRARY)
    list(APPEND ENDURING_CONTEXTS egl)
  endif()
  enduring_need(ENDURING_CONTEXTS libosmesa6-dev "or libegl-dev (or configure with -DENDURING_RENDER=OFF)")
  find_path(STB_INCLUDE stb/stb_image_write.h)
  enduring_need(STB_INCLUDE libstb-dev)
  find_file(DEJAVU_FONT DejaVuSans.ttf PATHS /usr/share/fonts/truetype/dejavu /usr/share/fonts/dejavu-sans-fonts)
  enduring_need(DEJAVU_FONT fonts-dejavu-core)
endif()

if(ENDURING_BENCHMARKS)
  find_package(benchmark QUIET)
  enduring_need(benchmark_FOUND libbenchmark-dev)
endif()
