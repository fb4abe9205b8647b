# How the course itself is compiled; other projects that use the layers are spared this.
# Our own code compiles without a warning, also with compilers newer than ours, where one does not stop a reader's build.
# Outside headers are system headers and keep theirs.
add_compile_options(
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  $<$<AND:$<BOOL:${ENDURING_WERROR}>,$<NOT:$<BOOL:$<TARGET_PROPERTY:ENDURING_ATTEMPT>>>>:-Werror>  # a student's attempt may leave a warning
  $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>)  # clang counts it to -Wconversion, g++ does not
if(ENDURING_RENDER)
  add_compile_definitions(ENDURING_RENDER)
endif()
if(ENDURING_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
  # What the sanitizers put in between hides from g++ that an empty std::optional is not read. The other presets keep this warning.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  add_compile_definitions(ENDURING_SANITIZE)
endif()
