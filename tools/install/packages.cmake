# The Debian packages that `cpack` makes: sbeh, sbeh-dev, python3-sbeh. What they depend on is computed.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME sbeh)
set(SBEH_MAINTAINER "The maintainers of sbeh <sbeh@localhost>" CACHE STRING "Name and address in Debian packages")
set(CPACK_PACKAGE_CONTACT "${SBEH_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "shapes of ordered fluid membranes")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL sbeh sbeh-dev)
if(SBEH_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python3-sbeh)
endif()

math(EXPR python_after "${Python3_VERSION_MINOR}0 / 10 + 1")

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(packaged ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
list(TRANSFORM libraries PREPEND ${PROJECT_BINARY_DIR}/ OUTPUT_VARIABLE CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS)

# What Debian wants of libraries: which package has them, and that the loader hears of them.
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_SBEH_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/debian/triggers)

# Every package has its own changes, the project's and (in Debian's form) the package's, copyright, and what lintian
# need not say.
set(changes ${CMAKE_CURRENT_BINARY_DIR}/changes)
file(TIMESTAMP ${PROJECT_SOURCE_DIR}/CHANGELOG.md changed "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(debian/changelog.in ${changes}/changelog.Debian @ONLY)
add_custom_command(OUTPUT ${changes}/changelog.gz ${changes}/changelog.Debian.gz
  COMMAND gzip -9 -n -c ${PROJECT_SOURCE_DIR}/CHANGELOG.md > ${changes}/changelog.gz
  COMMAND gzip -9 -n -c ${changes}/changelog.Debian > ${changes}/changelog.Debian.gz
  DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${changes}/changelog.Debian VERBATIM)
add_custom_target(changelog ALL DEPENDS ${changes}/changelog.gz)
foreach(component ${CPACK_COMPONENTS_ALL})
  install(FILES ${changes}/changelog.gz ${changes}/changelog.Debian.gz copyright
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${component} COMPONENT ${component})
endforeach()
install(FILES debian/lintian-overrides RENAME sbeh
  DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT sbeh)

set(CPACK_COMPONENT_SBEH_DESCRIPTION
"Programs: stationary shapes of membranes over reduced volume and
elastic constant, their stability, their evolution in time with an
axis and in 3D, pictures of all that.")
set(CPACK_DEBIAN_SBEH_PACKAGE_NAME sbeh)
set(CPACK_DEBIAN_SBEH_PACKAGE_RECOMMENDS "xvfb, xauth, fonts-dejavu-core")  # for pictures

set(CPACK_COMPONENT_SBEH-DEV_DESCRIPTION "Headers and libraries for programs of one's own.")
set(CPACK_DEBIAN_SBEH-DEV_PACKAGE_NAME sbeh-dev)
set(CPACK_DEBIAN_SBEH-DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_SBEH-DEV_PACKAGE_DEPENDS
  "sbeh (= ${packaged}), libeigen3-dev, libfmt-dev")

set(CPACK_COMPONENT_PYTHON3-SBEH_DESCRIPTION "The Python package sbeh, with four notebooks.")
set(CPACK_DEBIAN_PYTHON3-SBEH_PACKAGE_NAME python3-sbeh)
set(CPACK_DEBIAN_PYTHON3-SBEH_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON3-SBEH_PACKAGE_DEPENDS
  "sbeh (= ${packaged}), python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}), python3 (<< ${Python3_VERSION_MAJOR}.${python_after}), python3-numpy, python3-pandas")
set(CPACK_DEBIAN_PYTHON3-SBEH_PACKAGE_RECOMMENDS python3-matplotlib)
include(CPack)
