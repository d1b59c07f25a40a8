# SPDX-License-Identifier: Apache-2.0
# Configures the presets that the README names, each in a folder of its own below WORK, and looks into one for what it
# promises. What they give is compiled by whoever uses them.
foreach(preset dev asan tsan fallback)
  set(options -D TWINRAY_EMBREE=${EMBREE})
  if(preset STREQUAL fallback)
    set(options)
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} --preset ${preset} -S ${TWINRAY} -B ${WORK}/${preset} ${options}
                          -D CMAKE_PREFIX_PATH=${PREFIX_PATH}
                  WORKING_DIRECTORY ${TWINRAY} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result)
    message(FATAL_ERROR "the preset ${preset} cannot be configured:\n${output}")
  endif()
endforeach()
file(STRINGS ${WORK}/tsan/CMakeCache.txt sanitizer REGEX "^TWINRAY_SANITIZE:")
if(NOT sanitizer MATCHES "=thread$")
  message(FATAL_ERROR "the preset tsan has ${sanitizer}")
endif()
