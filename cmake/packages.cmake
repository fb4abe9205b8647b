# Every outside library, and the Debian package that brings it.
function(enduring_need found package what)
  if(NOT ${found})
    message(FATAL_ERROR "${what} was not found. On Debian: apt-get install ${package}   (or: ./course setup)")
  endif()
endfunction()

find_package(PkgConfig QUIET)
enduring_need(PkgConfig_FOUND pkg-config "pkg-config")

find_package(Eigen3 3.4 QUIET NO_MODULE)
enduring_need(Eigen3_FOUND libeigen3-dev "Eigen 3.4")

find_package(doctest QUIET)
enduring_need(doctest_FOUND doctest-dev "doctest")
include(doctest)

find_package(CLI11 QUIET)
enduring_need(CLI11_FOUND libcli11-dev "CLI11")

find_package(nlohmann_json QUIET)
enduring_need(nlohmann_json_FOUND nlohmann-json3-dev "JSON for Modern C++")

find_package(pugixml QUIET)
enduring_need(pugixml_FOUND libpugixml-dev "pugixml")

# Bullet in double precision. CMake's own FindBullet picks the float libraries, which double headers misread silently.
pkg_check_modules(BULLET QUIET IMPORTED_TARGET bullet-float64)
enduring_need(BULLET_FOUND "libbullet-dev libbullet-extras-dev" "Bullet in double precision (bullet-float64.pc)")

find_package(Boost QUIET CONFIG)
enduring_need(Boost_FOUND libboost-dev "Boost (multiprecision, header only)")

find_path(TINYOBJLOADER_INCLUDE tiny_obj_loader.h)
find_library(TINYOBJLOADER_LIBRARY tinyobjloader_double)   # doubles: geometry is never read through float
enduring_need(TINYOBJLOADER_LIBRARY libtinyobjloader-dev "tinyobjloader")

find_path(CHOLMOD_INCLUDE cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
enduring_need(CHOLMOD_LIBRARY libsuitesparse-dev "CHOLMOD")

if(ENDURING_RENDER)
  find_path(OSMESA_INCLUDE GL/osmesa.h)
  find_library(OSMESA_LIBRARY OSMesa)
  enduring_need(OSMESA_LIBRARY libosmesa6-dev "OSMesa, which draws the pictures (or configure with -DENDURING_RENDER=OFF),")
  find_path(STB_INCLUDE stb/stb_image_write.h)
  enduring_need(STB_INCLUDE libstb-dev "stb")
  find_file(DEJAVU_FONT DejaVuSans.ttf PATHS /usr/share/fonts/truetype/dejavu /usr/share/fonts/dejavu-sans-fonts)
  enduring_need(DEJAVU_FONT fonts-dejavu-core "the font DejaVu Sans")
endif()

if(ENDURING_BENCHMARKS)
  find_package(benchmark QUIET)
  enduring_need(benchmark_FOUND libbenchmark-dev "Google Benchmark")
endif()
