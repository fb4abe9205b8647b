# How a folder becomes targets. See the head of CMakeLists.txt for the layout.

include(GNUInstallDirs)

# What our headers need of whoever includes them.
add_library(enduring_options INTERFACE)
target_compile_features(enduring_options INTERFACE cxx_std_20)
target_include_directories(enduring_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/enduring>)
target_compile_definitions(enduring_options INTERFACE
  EIGEN_MAX_ALIGN_BYTES=16
  # A Vec3 written as three doubles and read back as a pair and a single stalls the processor: an impulse inlined where
  # its pair is made took 43 ns with Eigen's unaligned packets and 30 ns without. Since the impulses have a file of their
  # own, packets would be a tenth faster (44 against 48 ns), and elements 3 %.
  EIGEN_UNALIGNED_VECTORIZE=0)
# The error bounds of chapter 2 count every rounding: no contraction into fused multiply-adds.
target_compile_options(enduring_options INTERFACE -ffp-contract=off)

set(ENDURING_TEST_ENVIRONMENT
  "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/cmake/leaks.supp"
  "UBSAN_OPTIONS=print_stacktrace=1")

if(PROJECT_IS_TOP_LEVEL)
  enduring_precompiled(enduring_headers)
endif()

function(enduring_packages target)
  target_link_libraries(${target} PUBLIC enduring_options Eigen3::Eigen nlohmann_json::nlohmann_json
                        PkgConfig::BULLET Boost::headers)
  target_include_directories(${target} SYSTEM PUBLIC ${BULLET_INCLUDE_DIRS})
  if(ENDURING_CHOLMOD)
    target_link_libraries(${target} PUBLIC ${CHOLMOD_LIBRARY})
    target_include_directories(${target} SYSTEM PUBLIC ${CHOLMOD_INCLUDE})
  endif()
endfunction()

# A library from a list of sources; header-only folders become interface-like libraries with one empty source.
# With OUTSIDE it is one that other projects may use, as Enduring::OUTSIDE, and FOLDER's headers are installed with it.
function(enduring_library target)
  cmake_parse_arguments(ARG "" "OUTSIDE;FOLDER" "SOURCES;USES" ${ARGN})
  if(NOT ARG_SOURCES)
    file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp "")
    set(ARG_SOURCES ${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp)
  endif()
  add_library(${target} STATIC ${ARG_SOURCES})
  enduring_packages(${target})
  enduring_reuse_precompiled(${target} enduring_headers)
  target_link_libraries(${target} PUBLIC ${ARG_USES})
  if(ARG_OUTSIDE)
    add_library(Enduring::${ARG_OUTSIDE} ALIAS ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${ARG_OUTSIDE})
    file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${ARG_FOLDER}/*.hpp)
    install(TARGETS ${target} EXPORT EnduringContactsTargets)
    install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/enduring/${ARG_FOLDER})
  endif()
endfunction()

# doctest's cases, one CTest each, named "PREFIX:area: sentence". Long names of cases are the documentation of a failure.
function(enduring_tests target)
  cmake_parse_arguments(ARG "" "LABEL;PREFIX" "SOURCES;USES" ${ARGN})
  if(ARG_SOURCES AND PROJECT_IS_TOP_LEVEL)
    if(NOT TARGET doctest_main)  # the main program of all tests, which takes long to compile
      add_library(doctest_main OBJECT EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/cmake/doctest_main.cpp)
      target_link_libraries(doctest_main PRIVATE enduring_options doctest::doctest)
    endif()
    add_executable(${target} ${ARG_SOURCES} $<TARGET_OBJECTS:doctest_main>)
    target_link_libraries(${target} PRIVATE ${ARG_USES} doctest::doctest)
    enduring_reuse_precompiled(${target} enduring_headers)
    if(NOT TARGET tests_${ARG_LABEL})
      add_custom_target(tests_${ARG_LABEL})
    endif()
    add_dependencies(tests_${ARG_LABEL} ${target})
    doctest_discover_tests(${target} WORKING_DIRECTORY ${CMAKE_BINARY_DIR} TEST_PREFIX "${ARG_PREFIX}:"
      PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT 1500 ENVIRONMENT "${ENDURING_TEST_ENVIRONMENT}")
  endif()
endfunction()

function(enduring_benchmarks target)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES" ${ARGN})
  if(ARG_SOURCES AND ENDURING_BENCHMARKS)
    add_executable(${target} ${ARG_SOURCES})
    target_link_libraries(${target} PRIVATE ${ARG_USES} benchmark::benchmark_main)
    set_property(GLOBAL APPEND PROPERTY ENDURING_BENCHMARK_TARGETS ${target})
  endif()
endfunction()

# libFuzzer targets: each common/.../NAME/fuzz/X.cpp is one program.
function(enduring_fuzzers)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES" ${ARGN})
  if(ENDURING_FUZZ)
    foreach(source ${ARG_SOURCES})
      get_filename_component(name ${source} NAME_WE)
      add_executable(fuzz_${name} ${source})
      target_compile_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
      target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
      target_link_libraries(fuzz_${name} PRIVATE ${ARG_USES})
    endforeach()
  endif()
endfunction()

# A folder of the base, common/PATH, is the library enduring_NAME by the last word of its path; with PROGRAM, main.cpp in it is one.
# TOGETHER: several of its files at a time are one for the compiler, so no two of them have a name of their own in common.
function(enduring_common path)
  cmake_parse_arguments(ARG "TOGETHER" "PROGRAM" "USES;TESTS_USE" ${ARGN})
  set(folder ${PROJECT_SOURCE_DIR}/common/${path})
  get_filename_component(name ${path} NAME)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  list(REMOVE_ITEM sources ${folder}/main.cpp)
  file(GLOB tests CONFIGURE_DEPENDS ${folder}/tests/*.cpp)
  file(GLOB benchmarks CONFIGURE_DEPENDS ${folder}/benchmarks/*.cpp)
  file(GLOB fuzzers CONFIGURE_DEPENDS ${folder}/fuzz/*.cpp)
  if(name STREQUAL "render")  # the same interface twice: drawn, or not drawn at all
    if(ENDURING_RENDER)
      file(GLOB machine CONFIGURE_DEPENDS ${folder}/on/*.cpp)
    else()
      file(GLOB machine CONFIGURE_DEPENDS ${folder}/off/*.cpp)
    endif()
    list(APPEND sources ${machine})
  endif()
  if(name STREQUAL "gltf" AND NOT ENDURING_GLTF)
    set(tests "")  # they read the file back
  endif()
  if(name STREQUAL "fem" AND NOT ENDURING_CHOLMOD)
    list(REMOVE_ITEM sources ${folder}/supernodal_solver.cpp)
  endif()
  list(TRANSFORM ARG_USES PREPEND enduring_)
  list(TRANSFORM ARG_TESTS_USE PREPEND enduring_)
  if(NOT path MATCHES "/|worked_step")
    set(outside OUTSIDE ${name} FOLDER common/${path})
  endif()
  enduring_library(enduring_${name} SOURCES ${sources} USES ${ARG_USES} ${outside})
  if(ARG_TOGETHER)
    enduring_compile_together(enduring_${name})
  endif()
  enduring_tests(test_${name} SOURCES ${tests} USES enduring_${name} enduring_run ${ARG_TESTS_USE} LABEL common PREFIX ${name})
  enduring_benchmarks(bench_${name} SOURCES ${benchmarks} USES enduring_${name})
  enduring_fuzzers(SOURCES ${fuzzers} USES enduring_${name})
  if(ARG_PROGRAM)
    add_executable(${ARG_PROGRAM} ${folder}/main.cpp)
    target_link_libraries(${ARG_PROGRAM} PRIVATE enduring_${name})
    enduring_reuse_precompiled(${ARG_PROGRAM} enduring_headers)
  endif()
  if(name STREQUAL "fem" AND ENDURING_CHOLMOD)
    set_source_files_properties(${folder}/linear_solver.cpp PROPERTIES COMPILE_DEFINITIONS ENDURING_CHOLMOD)
  endif()
  if(name STREQUAL "report")
    target_link_libraries(enduring_report PUBLIC CLI11::CLI11)
  endif()
  if(name STREQUAL "gltf" AND ENDURING_GLTF)
    set_source_files_properties(${folder}/gltf_file.cpp PROPERTIES COMPILE_DEFINITIONS ENDURING_GLTF)
    target_link_libraries(enduring_gltf PUBLIC TinyGLTF::TinyGLTF)
  endif()
  if(name STREQUAL "paraview")
    target_link_libraries(enduring_paraview PUBLIC pugixml::pugixml)
  endif()
  if(name STREQUAL "render" AND ENDURING_RENDER)
    target_compile_definitions(enduring_render PRIVATE ENDURING_FONT="${DEJAVU_FONT}")
    target_include_directories(enduring_render SYSTEM PUBLIC ${STB_INCLUDE})
    # The first library that gives a context draws; the other one, where it is there as well, has its tests.
    foreach(context ${ENDURING_CONTEXTS})
      add_library(enduring_${context} STATIC ${folder}/on/context/${context}.cpp)
      target_link_libraries(enduring_${context} PUBLIC enduring_options ${ENDURING_${context}_LIBRARIES})
      if(UNIX AND NOT APPLE)  # what it stands on may want a newer C++ library than this compiler brings: found when the program starts
        target_link_options(enduring_${context} PUBLIC -Wl,--allow-shlib-undefined)
      endif()
    endforeach()
    list(POP_FRONT ENDURING_CONTEXTS first)
    set(asked "$<TARGET_PROPERTY:ENDURING_CONTEXT>")
    target_link_libraries(enduring_render PUBLIC $<IF:$<BOOL:${asked}>,enduring_${asked},enduring_${first}>)
    foreach(other ${ENDURING_CONTEXTS})
      enduring_tests(test_render_${other} SOURCES ${folder}/tests/renderer.cpp USES enduring_render LABEL common PREFIX render_${other})
      set_target_properties(test_render_${other} PROPERTIES ENDURING_CONTEXT ${other})
    endforeach()
  endif()
endfunction()

# A chapter sees the base and the chapters before it, never those after.
function(enduring_chapter number name)
  cmake_parse_arguments(ARG "" "" "EXPERIMENTS_USE" ${ARGN})
  set(folder ${PROJECT_SOURCE_DIR}/chapters/${number}_${name})
  file(GLOB layer CONFIGURE_DEPENDS ${folder}/*.cpp)
  list(REMOVE_ITEM layer ${folder}/main.cpp ${folder}/tests.cpp)
  file(GLOB experiments CONFIGURE_DEPENDS ${folder}/experiments/*.cpp ${folder}/baseline/*.cpp)
  file(GLOB tests CONFIGURE_DEPENDS ${folder}/tests.cpp ${folder}/tests/*.cpp)
  file(GLOB benchmarks CONFIGURE_DEPENDS ${folder}/benchmarks/*.cpp)
  get_property(below GLOBAL PROPERTY ENDURING_CHAPTER_LAYERS)

  enduring_library(chapter${number}_layer SOURCES ${layer} USES enduring_simulation ${below}
                   OUTSIDE chapter${number} FOLDER chapters/${number}_${name})
  set_property(GLOBAL APPEND PROPERTY ENDURING_CHAPTER_LAYERS chapter${number}_layer)
  if(EXISTS ${folder}/threads.cpp AND ENDURING_TBB)
    target_link_libraries(chapter${number}_layer PUBLIC TBB::tbb)
    set_source_files_properties(${folder}/threads.cpp PROPERTIES COMPILE_DEFINITIONS ENDURING_TBB)
  endif()
  if(name STREQUAL "exact_contact" AND ENDURING_HDF5)
    set_source_files_properties(${folder}/fclib_file.cpp PROPERTIES COMPILE_DEFINITIONS ENDURING_HDF5)
    target_include_directories(chapter${number}_layer SYSTEM PRIVATE ${HDF5_INCLUDE_DIRS})
    target_link_libraries(chapter${number}_layer PRIVATE ${HDF5_LINK_LIBRARIES})
  endif()

  if(PROJECT_IS_TOP_LEVEL AND EXISTS ${folder}/main.cpp)
    enduring_library(chapter${number}_experiments SOURCES ${experiments}
                     USES chapter${number}_layer enduring_own_scene ${ARG_EXPERIMENTS_USE})
    enduring_compile_together(chapter${number}_experiments)
    # A parameter in one file may be called as a constant at the head of another.
    target_compile_options(chapter${number}_experiments PRIVATE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>)
    add_executable(chapter${number} ${folder}/main.cpp)
    target_link_libraries(chapter${number} PRIVATE chapter${number}_experiments)
    enduring_reuse_precompiled(chapter${number} enduring_headers)
    enduring_tests(test_chapter${number} SOURCES ${tests} USES chapter${number}_experiments enduring_worked_step LABEL chapter${number} PREFIX "chapter ${number}")
  endif()
  enduring_benchmarks(bench_chapter${number} SOURCES ${benchmarks} USES chapter${number}_layer enduring_run)
endfunction()

# An experiment of chapter 1 with the few files that it needs, so that `./course run` soon has a picture.
function(enduring_first_picture)
  set(folder ${PROJECT_SOURCE_DIR}/chapters/01_particle_plane)
  add_executable(first_picture ${folder}/first_picture/main.cpp ${folder}/experiments/drop.cpp
                 ${folder}/particle.cpp ${folder}/plane_impulse.cpp ${folder}/settling.cpp)
  enduring_packages(first_picture)
  target_link_libraries(first_picture PRIVATE enduring_report)
  enduring_reuse_precompiled(first_picture enduring_headers)
endfunction()

# Above the chapters: all of their solvers together, and the scenes that called for each, which know no solver.
function(enduring_motivating_scenes)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/motivating_scenes/*.cpp)
  enduring_library(motivating_scenes SOURCES ${sources} USES enduring_render)
  enduring_compile_together(motivating_scenes)
endfunction()

# The scenes under the Bullet library, which needs the base only.
function(enduring_bullet_baseline)
  set(folder ${PROJECT_SOURCE_DIR}/chapters/bullet_baseline)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  file(GLOB tests CONFIGURE_DEPENDS ${folder}/tests/*.cpp)
  enduring_library(bullet_baseline SOURCES ${sources} USES enduring_scenes)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)  # g++ warns of Bullet's own arrays where it inlines them into ours
    target_compile_options(bullet_baseline PRIVATE -Wno-maybe-uninitialized)
  endif()
  enduring_tests(test_bullet_baseline SOURCES ${tests} USES bullet_baseline enduring_run LABEL solvers PREFIX bullet)
endfunction()

# What the laboratory of the book does, without a browser: its tests, and the program `laboratory`, with which the page's numbers are compared.
function(enduring_laboratory)
  set(folder ${PROJECT_SOURCE_DIR}/live)
  file(GLOB tests CONFIGURE_DEPENDS ${folder}/lab/tests/*.cpp)
  enduring_library(enduring_laboratory SOURCES ${folder}/laboratory.cpp ${PROJECT_SOURCE_DIR}/chapters/solvers/chapter_solver.cpp
                   USES chapter10_layer enduring_scenes)
  add_executable(laboratory ${folder}/lab/native.cpp)
  target_link_libraries(laboratory PRIVATE enduring_laboratory CLI11::CLI11)
  enduring_reuse_precompiled(laboratory enduring_headers)
  enduring_tests(test_laboratory SOURCES ${tests} USES enduring_laboratory LABEL solvers PREFIX laboratory)
endfunction()

function(enduring_solvers)
  set(folder ${PROJECT_SOURCE_DIR}/chapters/solvers)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  list(REMOVE_ITEM sources ${folder}/main.cpp)
  file(GLOB tests CONFIGURE_DEPENDS ${folder}/tests/*.cpp)
  enduring_library(solvers_experiments SOURCES ${sources} USES chapter06_experiments chapter07_experiments chapter11_layer motivating_scenes bullet_baseline)
  enduring_compile_together(solvers_experiments)
  add_executable(solvers ${folder}/main.cpp)
  target_link_libraries(solvers PRIVATE solvers_experiments)
  enduring_reuse_precompiled(solvers enduring_headers)
  enduring_tests(test_solvers SOURCES ${tests} USES solvers_experiments LABEL solvers PREFIX solvers)
endfunction()

# The module `enduring`, in a build folder of its own (preset `python`): a shared library takes position-independent code only.
function(enduring_python)
  if(ENDURING_PYTHON)
    pybind11_add_module(enduring MODULE EXCLUDE_FROM_ALL NO_EXTRAS ${PROJECT_SOURCE_DIR}/python/enduring.cpp ${PROJECT_SOURCE_DIR}/chapters/solvers/chapter_solver.cpp)
    target_link_libraries(enduring PRIVATE chapter10_layer enduring_scenes)
    set_target_properties(enduring PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
  endif()
endfunction()
