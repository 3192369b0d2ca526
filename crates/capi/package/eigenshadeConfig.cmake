# find_package(eigenshade) gives the target eigenshade::eigenshade.
get_filename_component(_eigenshade "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT TARGET eigenshade::eigenshade)
  add_library(eigenshade::eigenshade STATIC IMPORTED)
  set_target_properties(eigenshade::eigenshade PROPERTIES
    IMPORTED_LOCATION "${_eigenshade}/lib/libeigenshade_capi.a"
    INTERFACE_INCLUDE_DIRECTORIES "${_eigenshade}/include"
    INTERFACE_LINK_OPTIONS "@OPTIONS@"
    INTERFACE_LINK_LIBRARIES "@LIBRARIES@")
endif()
unset(_eigenshade)
