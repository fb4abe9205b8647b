# What is not C++: the `course` command and the book's weaver, as tests. And the targets `course` asks for by one name.
get_property(targets DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
foreach(kind bench fuzz)
  set(programs ${targets})
  list(FILTER programs INCLUDE REGEX "^${kind}_")
  string(REPLACE "bench" "benchmarks" name ${kind})
  string(REPLACE "fuzz" "fuzzers" name ${name})
  add_custom_target(${name} DEPENDS ${programs})
endforeach()

find_program(BASH bash)
find_package(Python3 QUIET COMPONENTS Interpreter)
if(BASH AND NOT ENDURING_SANITIZE AND NOT ENDURING_FUZZ)
  set(test_course "course: what it refuses, and what it lists")
  set(test_packages "course: each command asks for its own packages, says before what they cost, and goes on without pictures")
  set(test_results "course: results hold while the program and what it reads are the same, also in a folder with a space")
  foreach(script test_course test_packages test_results)
    add_test(NAME "${${script}}" COMMAND ${BASH} ${PROJECT_SOURCE_DIR}/docs/tests/${script}.sh)
    set_tests_properties("${${script}}" PROPERTIES LABELS course ENVIRONMENT "ENDURING_BUILD=${CMAKE_BINARY_DIR}")
  endforeach()
  if(Python3_FOUND)
    add_test(NAME "book: what the weaver brings and what stops it"
             COMMAND ${Python3_EXECUTABLE} -m unittest discover -s ${PROJECT_SOURCE_DIR}/docs/tests)
    add_test(NAME "exercises: what the catalogue reads, the judge says and the grades hold"
             COMMAND ${Python3_EXECUTABLE} -m unittest discover -s ${PROJECT_SOURCE_DIR}/exercises/tests)
    add_test(NAME "examples: they print what falls, and another project can build them in both ways"
             COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/examples/test_examples.py ${CMAKE_BINARY_DIR})
    set_tests_properties("book: what the weaver brings and what stops it"
      "exercises: what the catalogue reads, the judge says and the grades hold"
      "examples: they print what falls, and another project can build them in both ways" PROPERTIES LABELS course)
  endif()
endif()
