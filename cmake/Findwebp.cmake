# SPDX-License-Identifier: Apache-2.0
# webp::webp, found by header and library: Debian 12 has no configuration file of it.
find_path(webp_INCLUDE_DIR webp/decode.h)
find_library(webp_LIBRARY webp)
mark_as_advanced(webp_INCLUDE_DIR webp_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(webp REQUIRED_VARS webp_LIBRARY webp_INCLUDE_DIR)

if(webp_FOUND AND NOT TARGET webp::webp)
  add_library(webp::webp UNKNOWN IMPORTED)
  set_target_properties(webp::webp PROPERTIES
    IMPORTED_LOCATION "${webp_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${webp_INCLUDE_DIR}")
endif()
