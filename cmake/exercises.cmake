# The exercises. Nothing here is built by `all`: `./course check` builds what an exercise needs, and compiles the
# student's file, or a solution, or a mutant, by the command that the target exercise_NN_M is the pattern of.
#   exercises/NN_name/M_title.cpp        the student's file: target exercise_NN_M
#   exercises/NN_name/M_title.check.cpp  what judges it:     target check_NN_M
function(enduring_exercises)
  enduring_precompiled(exercise_headers)
  target_compile_options(exercise_headers PRIVATE -O1 -UNDEBUG -D_GLIBCXX_ASSERTIONS)
  file(GLOB checks CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/exercises/[0-9]*/*.check.cpp)
  add_library(check_main OBJECT EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/exercises/judged_main.cpp)
  target_link_libraries(check_main PRIVATE enduring_options doctest::doctest)
  foreach(check ${checks})
    string(REGEX MATCH "exercises/(([0-9]+)_[^/]*)/(([0-9]+)_[^/]*)\\.check\\.cpp$" matched ${check})
    set(chapter ${CMAKE_MATCH_1})
    set(name ${CMAKE_MATCH_3})
    set(number ${CMAKE_MATCH_2}_${CMAKE_MATCH_4})
    set(layer chapter${CMAKE_MATCH_2}_experiments)
    set(stub ${PROJECT_SOURCE_DIR}/exercises/${chapter}/${name}.cpp)
    if(NOT EXISTS ${stub})
      continue()
    endif()
    add_library(check_${number} OBJECT EXCLUDE_FROM_ALL ${check})
    target_link_libraries(check_${number} PRIVATE ${layer} doctest::doctest)
    add_executable(exercise_${number} EXCLUDE_FROM_ALL ${stub} $<TARGET_OBJECTS:check_${number}>
                   $<TARGET_OBJECTS:check_main>)
    target_link_libraries(exercise_${number} PRIVATE ${layer} doctest::doctest)
    foreach(target check_${number} exercise_${number})
      set_target_properties(${target} PROPERTIES ENDURING_ATTEMPT ON)
      # An attempt may leave arguments unused; an index out of range says so.
      enduring_reuse_precompiled(${target} exercise_headers)
      target_compile_options(${target} PRIVATE -O1 -Wno-unused-parameter -Werror=return-type -UNDEBUG -D_GLIBCXX_ASSERTIONS
        "SHELL:-iquote \"${PROJECT_SOURCE_DIR}/chapters/${chapter}\"" "SHELL:-iquote \"${PROJECT_SOURCE_DIR}/exercises/${chapter}\"")
    endforeach()
  endforeach()
endfunction()

enduring_exercises()
