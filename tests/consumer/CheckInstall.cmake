# SPDX-License-Identifier: Apache-2.0
# cmake -D BUILD=folder -D SOURCE=folder -D CXX=compiler -P CheckInstall.cmake: installs the build to a folder of
# its own, then builds and runs the consumer project against it.
set(work ${BUILD}/consumer)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})

function(step)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${work} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    file(REMOVE_RECURSE ${work})
    message(FATAL_ERROR "${command}\n${output}")
  endif()
endfunction()

step(${CMAKE_COMMAND} --install ${BUILD} --prefix ${work}/prefix)
step(${work}/prefix/bin/twinray --version)
step(${work}/prefix/bin/pathtracer -h)
# Moved elsewhere it still finds its parts.
file(RENAME ${work}/prefix ${work}/moved)
step(${work}/moved/bin/twinray render ${SOURCE}/../../scenes/box.dae -r 8 6 -s 1 -q -o ${work}/moved.exr)
file(RENAME ${work}/moved ${work}/prefix)
step(${CMAKE_COMMAND} -S ${SOURCE} -B ${work}/build -G Ninja -D CMAKE_BUILD_TYPE=Release
     -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_PREFIX_PATH=${work}/prefix -D CANONICAL_TABLE=${SOURCE}/../accel)
step(${CMAKE_COMMAND} --build ${work}/build)
step(${work}/build/consumer)
file(REMOVE_RECURSE ${work})
