# SPDX-License-Identifier: Apache-2.0
# cmake -D WORK=folder -D TWINRAY=folder -D CXX=compiler -D GENERATOR=name -D MAKE=program -P CheckOldEmbree.cmake:
# configures where Embree 3.12 is all that there is, and sees it refused by name.
file(REMOVE_RECURSE ${WORK})
file(WRITE ${WORK}/embree-3.12.0/embree-config.cmake "")
file(WRITE ${WORK}/embree-3.12.0/embree-config-version.cmake
     "set(PACKAGE_VERSION 3.12.0)\nif(NOT PACKAGE_FIND_VERSION VERSION_GREATER PACKAGE_VERSION)\n"
     "  set(PACKAGE_VERSION_COMPATIBLE TRUE)\nendif()\n")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${TWINRAY} -B ${WORK}/build -G ${GENERATOR} -D CMAKE_MAKE_PROGRAM=${MAKE}
                        -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_PREFIX_PATH=${WORK}
                        -D CMAKE_FIND_USE_CMAKE_SYSTEM_PATH=OFF -D CMAKE_FIND_USE_SYSTEM_ENVIRONMENT_PATH=OFF
                RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
string(REGEX REPLACE "[ \n]+" " " output "${output}")
if(result EQUAL 0 OR NOT output MATCHES "Embree 3\\.13 or 4 is needed\\. Embree 3\\.12\\.0 was found")
  message(FATAL_ERROR "Embree 3.12 was not refused:\n${output}")
endif()
file(REMOVE_RECURSE ${WORK})
