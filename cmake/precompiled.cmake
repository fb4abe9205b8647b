# What nearly every file reads, and reads for longer than its own lines: parsed once here. The fuzz preset goes without,
# so that a file which forgets an include of its own is found.
option(ENDURING_PRECOMPILE "parse Eigen and the standard library once, and compile some files of the base together" ON)

function(enduring_precompiled name)
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp CONTENT "")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE enduring_options Eigen3::Eigen)
  target_precompile_headers(${name} PRIVATE
    <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <limits> <map> <memory> <numbers> <optional> <random>
    <set> <span> <sstream> <stdexcept> <string> <variant> <vector> <Eigen/Dense> <Eigen/SparseCore>)
endfunction()

# TARGET reads them from the library NAME, whose options for the compiler have to be its own.
function(enduring_reuse_precompiled target name)
  if(PROJECT_IS_TOP_LEVEL AND ENDURING_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()

# TARGET is compiled eight files at a time: its own headers are parsed, and what they take of Eigen is made, once for eight; 13 files of
# experiments take 12 s so, and 39 s one by one. No two of its files have a name of their own in common. Not for what an answer to an
# exercise, or a wrong version as of `./course prove --layers`, takes the place of file by file: it would be compiled eight times as often.
function(enduring_compile_together target)
  if(PROJECT_IS_TOP_LEVEL AND ENDURING_PRECOMPILE)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON)
  endif()
endfunction()
