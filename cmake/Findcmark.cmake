# SPDX-License-Identifier: Apache-2.0
# cmark::cmark, found by header and library. The configuration file that Debian 12 ships is not used: it stops with
# an error unless the program cmark is installed too.
find_path(cmark_INCLUDE_DIR cmark.h)
find_library(cmark_LIBRARY cmark)
mark_as_advanced(cmark_INCLUDE_DIR cmark_LIBRARY)

if(cmark_INCLUDE_DIR)
  file(STRINGS ${cmark_INCLUDE_DIR}/cmark_version.h line REGEX "^#define CMARK_VERSION_STRING ")
  string(REGEX MATCH "[0-9.]+" cmark_VERSION "${line}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(cmark REQUIRED_VARS cmark_LIBRARY cmark_INCLUDE_DIR VERSION_VAR cmark_VERSION)

if(cmark_FOUND AND NOT TARGET cmark::cmark)
  add_library(cmark::cmark UNKNOWN IMPORTED)
  set_target_properties(cmark::cmark PROPERTIES
    IMPORTED_LOCATION "${cmark_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${cmark_INCLUDE_DIR}")
endif()
