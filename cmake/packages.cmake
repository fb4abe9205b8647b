# Finds the outside libraries. What is missing is told with its line of packages.txt, the one list of packages. A program that cannot be
# built without stops here; what misses of the rest costs only itself, and stands in left_out.txt of the build folder.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/packages.txt ENDURING_PACKAGES)
set(ENDURING_LEFT_OUT "")

function(enduring_purpose package what)  # what the list says that a package is for
  set(lines ${ENDURING_PACKAGES})
  string(REPLACE "+" "[+]" pattern ${package})
  list(FILTER lines INCLUDE REGEX "^${pattern} ")
  if(NOT lines)
    message(FATAL_ERROR "cmake/packages.txt does not name ${package}")
  endif()
  string(REGEX REPLACE "^[^ ]+ +(.*)$" "\\1" purpose "${lines}")
  set(${what} "${purpose}" PARENT_SCOPE)
endfunction()

function(enduring_need found package)
  enduring_purpose(${package} what)
  if(NOT ${found})
    message(FATAL_ERROR "${package} was not found: ${what}. On Debian: ./course setup start, or apt-get install ${package}")
  endif()
endfunction()

function(enduring_want found package costs)  # where it is missing, the variable FOUND is OFF, and a line says what that costs
  enduring_purpose(${package} what)
  if(NOT ${found})
    message(STATUS "${package} was not found (${what}): ${costs}. On Debian: apt-get install ${package}")
    list(APPEND ENDURING_LEFT_OUT ${package})
    set(ENDURING_LEFT_OUT ${ENDURING_LEFT_OUT} PARENT_SCOPE)
    set(${found} OFF PARENT_SCOPE)
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
set(ENDURING_CHOLMOD ON)
if(NOT CHOLMOD_INCLUDE OR NOT CHOLMOD_LIBRARY)
  set(ENDURING_CHOLMOD OFF)
endif()
enduring_want(ENDURING_CHOLMOD libsuitesparse-dev "soft bodies take Eigen's solver, and numbers differ in their last digits")

find_package(TBB QUIET CONFIG)
set(ENDURING_TBB ${TBB_FOUND})
enduring_want(ENDURING_TBB libtbb-dev "islands of bodies are solved on one core, to the same bytes")

# the serial one: FCLIB's files are small, and its name is the same on every Debian
pkg_check_modules(HDF5 QUIET hdf5-serial)
set(ENDURING_HDF5 ${HDF5_FOUND})
enduring_want(ENDURING_HDF5 libhdf5-dev "chapter 11 reads no problems in HDF5")

if(NOT PROJECT_NAME STREQUAL EnduringContacts OR NOT PROJECT_IS_TOP_LEVEL)
  return()  # what follows is for the course itself: tests, command lines, pictures
endif()
# other physics engines, to compare with
pkg_check_modules(ODE QUIET ode)
set(ENDURING_ODE ${ODE_FOUND})
enduring_want(ENDURING_ODE libode-dev "no rows of ODE beside ours")
find_path(MUJOCO_INCLUDE mujoco/mujoco.h)
find_library(MUJOCO_LIBRARY mujoco)
set(ENDURING_MUJOCO ON)
if(NOT MUJOCO_INCLUDE OR NOT MUJOCO_LIBRARY)
  set(ENDURING_MUJOCO OFF)
endif()
enduring_want(ENDURING_MUJOCO libmujoco-dev "no rows of Debian's MuJoCo beside ours")
# an option, and so not wanted: DART, whose Bullet is single
pkg_check_modules(DART QUIET dart)
pkg_check_modules(BULLET_OF_DART QUIET bullet)
find_library(DART_DETECTOR dart-collision-bullet)
find_library(ASSIMP_LIBRARY assimp)

find_package(doctest QUIET)
enduring_need(doctest_FOUND doctest-dev)
include(doctest)

find_package(CLI11 QUIET)
enduring_need(CLI11_FOUND libcli11-dev)

find_package(pugixml QUIET)
enduring_need(pugixml_FOUND libpugixml-dev)

find_package(TinyGLTF QUIET CONFIG)
set(ENDURING_GLTF ${TinyGLTF_FOUND})
enduring_want(ENDURING_GLTF libtinygltf-dev "no runs as glTF")

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
  set(ENDURING_RENDER_CONTEXT ${ENDURING_CONTEXTS})
  enduring_want(ENDURING_RENDER_CONTEXT libegl-dev "no pictures (libosmesa6-dev draws them as well)")
  find_path(STB_INCLUDE stb/stb_image_write.h)
  enduring_want(STB_INCLUDE libstb-dev "no pictures")
  find_file(DEJAVU_FONT DejaVuSans.ttf PATHS /usr/share/fonts/truetype/dejavu /usr/share/fonts/dejavu-sans-fonts)
  enduring_want(DEJAVU_FONT fonts-dejavu-core "no pictures")
  if(NOT ENDURING_RENDER_CONTEXT OR NOT STB_INCLUDE OR NOT DEJAVU_FONT)
    set(ENDURING_RENDER OFF)
  endif()
  if(NOT ENDURING_RENDER_CONTEXT)
    list(APPEND ENDURING_LEFT_OUT libosmesa6-dev)  # either will do
  endif()
endif()

if(ENDURING_PYTHON)
  find_package(pybind11 QUIET CONFIG)
  enduring_need(pybind11_FOUND pybind11-dev)
endif()

if(ENDURING_BENCHMARKS)
  find_package(benchmark QUIET)
  enduring_want(benchmark_FOUND libbenchmark-dev "no benchmarks")
  if(NOT benchmark_FOUND)
    set(ENDURING_BENCHMARKS OFF)
  endif()
endif()
list(JOIN ENDURING_LEFT_OUT "\n" lines)
file(WRITE ${CMAKE_BINARY_DIR}/left_out.txt "${lines}")
