# What Debian's dpkg-buildflags asks of programs that read untrusted files, for programs and libraries of optimised
# builds on Linux: overflows that the compiler can see are stopped (_FORTIFY_SOURCE), a function with an array on its
# stack notices that the array was overrun, code lies at random addresses (PIE), and the tables of the linker are read-only
# before main begins. tests/package/hardening_test reads the files that were made.
#
# Sanitizers have checks of their own, and their own view of the memory; WebAssembly has neither a stack to overrun nor
# such tables; without optimisation, _FORTIFY_SOURCE does nothing but warn.
option(PATINA_HARDENING "Build programs and libraries with Debian's hardening flags" ON)
set(PATINA_IS_HARDENED FALSE)
if(PATINA_HARDENING AND CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang"
   AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize" AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
  set(PATINA_IS_HARDENED TRUE)
  # -U first: compilers of some systems define it themselves, and a second definition is a warning.
  # -fno-plt: with addresses that are known before main, calls of other libraries need no detour by a table.
  add_compile_options(-fno-plt $<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE> $<$<NOT:$<CONFIG:Debug>>:-D_FORTIFY_SOURCE=2>
                      -fstack-protector-strong -Wformat -Werror=format-security)
  add_link_options(-Wl,-z,relro -Wl,-z,now -Wl,-z,noexecstack)
  # -fPIE where an object is not for a shared library: -fPIC, which CMake would take for static libraries, is slower.
  add_compile_options($<$<NOT:$<BOOL:$<TARGET_PROPERTY:POSITION_INDEPENDENT_CODE>>>:-fPIE>)
  add_link_options($<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-pie>)
endif()
