# Where the package goes is known when it is installed, for `cmake --install --prefix` may change the prefix, and cpack does.
# - TRICOVER_PYTHON_DIR, below the prefix or absolute, if it is set;
# - below /usr (the .deb) and /usr/local, Debian's dist-packages, which its Python looks into;
# - below any other prefix lib/python3.X/site-packages, as in a virtual environment: add that to PYTHONPATH elsewhere.
set(TRICOVER_PYTHON_DIR "" CACHE STRING "Where the Python package is installed: below the prefix, or an absolute path; empty: the interpreter's way")
install(CODE "
  set(TRICOVER_PYTHON_TO \"${TRICOVER_PYTHON_DIR}\")
  if(NOT TRICOVER_PYTHON_TO)
    set(TRICOVER_PYTHON_TO lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/site-packages)
    if(EXISTS /etc/debian_version AND CMAKE_INSTALL_PREFIX MATCHES \"^/usr/?$|/_CPack_Packages/.*/usr$\")
      set(TRICOVER_PYTHON_TO lib/python3/dist-packages)
    elseif(EXISTS /etc/debian_version AND CMAKE_INSTALL_PREFIX MATCHES \"^/usr/local/?$\")
      set(TRICOVER_PYTHON_TO lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/dist-packages)
    endif()
  endif()" COMPONENT tricover_python)
install(DIRECTORY tricover DESTINATION "\${TRICOVER_PYTHON_TO}" COMPONENT tricover_python FILES_MATCHING PATTERN *.py PATTERN *.pyi PATTERN py.typed
  PATTERN __pycache__ EXCLUDE)
install(TARGETS tricover_python LIBRARY DESTINATION "\${TRICOVER_PYTHON_TO}/tricover" COMPONENT tricover_python)
# A shared libtricover is found from there: three folders up is the prefix's lib.
set_target_properties(tricover_python PROPERTIES INSTALL_RPATH "$ORIGIN/../../../../${CMAKE_INSTALL_LIBDIR}")
