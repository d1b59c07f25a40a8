# SPDX-License-Identifier: Apache-2.0
# cmake -D WORK=folder -D TWINRAY=folder -D CXX=compiler -D EMBREE=ON|OFF -P CheckParent.cmake: configures the parent
# project, and sees that what it installs is its own file alone.
file(REMOVE_RECURSE ${WORK})

function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${output}")
  endif()
endfunction()

step(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build -G Ninja -D CMAKE_CXX_COMPILER=${CXX}
     -D TWINRAY=${TWINRAY} -D TWINRAY_EMBREE=${EMBREE} -D CMAKE_PREFIX_PATH=${PREFIX_PATH})
step(${CMAKE_COMMAND} --install ${WORK}/build --prefix ${WORK}/prefix)
file(GLOB_RECURSE installed RELATIVE ${WORK}/prefix ${WORK}/prefix/*)
if(NOT installed STREQUAL "mine/CMakeLists.txt")
  message(FATAL_ERROR "the parent installs ${installed}; it asked for mine/CMakeLists.txt alone")
endif()
file(REMOVE_RECURSE ${WORK})
