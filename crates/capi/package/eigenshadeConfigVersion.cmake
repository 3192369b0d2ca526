set(PACKAGE_VERSION "@VERSION@")
# Before 1.0 a minor version may break what the one before it promised.
string(REGEX MATCH "^[0-9]+\\.[0-9]+" _minor "${PACKAGE_VERSION}")
if(PACKAGE_FIND_VERSION MATCHES "^${_minor}(\\.|$)" AND
    NOT PACKAGE_FIND_VERSION VERSION_GREATER PACKAGE_VERSION)
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()
if(PACKAGE_FIND_VERSION VERSION_EQUAL PACKAGE_VERSION)
  set(PACKAGE_VERSION_EXACT TRUE)
endif()
unset(_minor)
