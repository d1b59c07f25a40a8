# SPDX-License-Identifier: Apache-2.0
# Compiler settings: what the library promises (its users inherit that), and what only its developers want.
# A project that includes this one decides about its own build type.
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

set(TWINRAY_SANITIZE "" CACHE STRING "Sanitizers, as -fsanitize takes them")
option(TWINRAY_WERROR "Treat warnings as errors" OFF)

# Where an installation has what is loaded while the program runs, below its prefix. A project that includes this one
# decides about its own folders.
if(TWINRAY_INSTALL_RULES)
  include(GNUInstallDirs)
endif()
set(twinray_module_folder ${CMAKE_INSTALL_LIBDIR}/twinray)

# The builds with and without Embree share most objects of the libraries and the program: the second one takes them from
# here. What a file reads the cache learns from the compiler (CCACHE_DEPEND): to preprocess it before would take a seventh
# of the time of the first build.
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(TWINRAY_CCACHE ccache DOC "Compiler cache, of Debian's package ccache; without it more is compiled twice")
  mark_as_advanced(TWINRAY_CCACHE)
endif()
# twinray_share_objects(TARGET): compiles it with the cache. Its options must not name a folder of the build.
function(twinray_share_objects target)
  if(TWINRAY_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(cache CCACHE_DIR=${PROJECT_SOURCE_DIR}/build/ccache CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
              CCACHE_DEPEND=1 CCACHE_MAXSIZE=1G)
    set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER
                          "${CMAKE_COMMAND};-E;env;${cache};${TWINRAY_CCACHE}")
  endif()
endfunction()

# To compile most files is mostly to read the headers that they include, and to make the templates in them: sixteen
# together take little longer than one. The preset dev takes each alone, and so sees whether it includes what it needs.
# What traverses (accel) and the waves (integrators) stand alone in any case.
option(TWINRAY_UNITY "Compile many files at a time: half of the time of a build from nothing" ON)
set(twinray_files_together 16)
# twinray_compile_together(TARGET [file...]): these of its files, or all. No two that are taken together may use a name for
# two things: the compiler says so, and one of them takes a better name.
function(twinray_compile_together target)
  set(files ${ARGN})
  if(NOT files)
    get_target_property(files ${target} SOURCES)
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${TWINRAY_UNITY} UNITY_BUILD_MODE GROUP)
  list(GET files 0 first)
  set(place 0)
  foreach(file ${files})
    math(EXPR part "${place} / ${twinray_files_together}")
    math(EXPR place "${place} + 1")
    string(MAKE_C_IDENTIFIER "with_${first}_${part}" group)
    set_source_files_properties(${file} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()

# twinray_compile_soon(TARGET [LEVEL]): with those optimisations alone that the compiler makes quickly, -O1 or what is said.
# For code whose speed nobody notices: rays, trees and light are in other libraries.
function(twinray_compile_soon target)
  set(level ${ARGN})
  if(NOT level)
    set(level -O1)
  endif()
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${level}>)
endfunction()

# Warnings and sanitizers: linked PRIVATE by every target of ours, never installed.
add_library(twinray_developer INTERFACE)
target_compile_options(twinray_developer INTERFACE -Wall -Wextra -Wno-missing-field-initializers
                       $<$<BOOL:${TWINRAY_WERROR}>:-Werror>)
# A program loads only the libraries that it calls: not Highway's, for one, where its headers are all that is used.
target_link_options(twinray_developer INTERFACE LINKER:--as-needed)
# Clang also finds names hidden that another file has, where files are compiled together.
if(NOT (TWINRAY_UNITY AND CMAKE_CXX_COMPILER_ID MATCHES "Clang"))
  target_compile_options(twinray_developer INTERFACE -Wshadow)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # The compiler need not look so often for what it can forget: a sixth of its time, for a fifth more memory.
  target_compile_options(twinray_developer INTERFACE "SHELL:--param ggc-min-heapsize=524288")
endif()
if(TWINRAY_SANITIZE)
  # Without recovery: a test that meets undefined behaviour fails.
  target_compile_options(twinray_developer INTERFACE -fsanitize=${TWINRAY_SANITIZE} -fno-sanitize-recover=all
                         -fno-omit-frame-pointer)
  # GCC 12 takes strings that are put together for writes beyond their ends where it also counts accesses.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(twinray_developer INTERFACE -Wno-array-bounds -Wno-stringop-overflow)
  elseif(TWINRAY_SANITIZE MATCHES "address")
    target_compile_definitions(twinray_developer INTERFACE __SANITIZE_ADDRESS__)  # As GCC itself does.
  elseif(TWINRAY_SANITIZE MATCHES "thread")
    target_compile_definitions(twinray_developer INTERFACE __SANITIZE_THREAD__)
  endif()
  # A sanitizer opens libraries in the program's place: it sees the program's RPATH, but no RUNPATH.
  target_link_options(twinray_developer INTERFACE -fsanitize=${TWINRAY_SANITIZE} LINKER:--disable-new-dtags)
endif()

# twinray_library(NAME file...): the static library twinray::NAME, with includes from the root of the tree.
function(twinray_library name)
  add_library(twinray_${name} STATIC ${ARGN})
  add_library(twinray::${name} ALIAS twinray_${name})
  set_target_properties(twinray_${name} PROPERTIES EXPORT_NAME ${name} CXX_EXTENSIONS OFF
                        POSITION_INDEPENDENT_CODE ON)
  target_compile_features(twinray_${name} PUBLIC cxx_std_20)
  target_include_directories(twinray_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                             $<INSTALL_INTERFACE:include/twinray>)
  # Nobody reads errno: a square root is one instruction.
  target_compile_options(twinray_${name} PRIVATE -fno-math-errno)
  target_link_libraries(twinray_${name} PRIVATE $<BUILD_INTERFACE:twinray_developer>)
  twinray_share_objects(twinray_${name})
endfunction()
