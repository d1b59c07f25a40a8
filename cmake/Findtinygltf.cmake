# SPDX-License-Identifier: Apache-2.0
# tinygltf::tinygltf, a header alone: it is compiled into the one file that asks for it. Debian's library brings along
# a reader of pictures that is not used.
find_path(tinygltf_INCLUDE_DIR tiny_gltf.h)
mark_as_advanced(tinygltf_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(tinygltf REQUIRED_VARS tinygltf_INCLUDE_DIR)

if(tinygltf_FOUND AND NOT TARGET tinygltf::tinygltf)
  add_library(tinygltf::tinygltf INTERFACE IMPORTED)
  set_target_properties(tinygltf::tinygltf PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${tinygltf_INCLUDE_DIR}")
endif()
