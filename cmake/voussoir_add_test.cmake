# voussoir_add_test(NAME name SOURCES a.cpp ... [RANKS 1 2 4] [LABELS ...] [TIMEOUT seconds] [ARGS ...])
#
# One executable test_<name>, made of Teuchos unit tests and the main program of tests/support, and one ctest per
# number of ranks, called <folder>.<name>.np<ranks>. Defaults: RANKS 1, LABELS the folders below tests/ (tests/unit/mesh
# has the labels unit and mesh), TIMEOUT 600. Limits are for hangs: ten times what
# a test usually takes.
# A test runs in its own build folder; files of the repository are found by repository() of tests/support.
#
# voussoir_add_script(NAME name SCRIPT a.py [ARGS ...] [LABELS ...] [TIMEOUT seconds] [PROCESSORS n])
#
# One ctest <folder>.<name> that runs a Python script; it fails when the script returns other than 0. PROCESSORS are the
# cores that it keeps busy most of its time, and that ctest takes from other tests. One that starts more ranks now and then,
# on a small scene, is no such: ranks that wait leave their core to others.

# Debian's numpy and h5py belong to this Python, which need not be the first on PATH.
set(VOUSSOIR_PYTHON /usr/bin/python3 CACHE FILEPATH "Python with numpy, h5py and matplotlib")

set(VOUSSOIR_TEST_ENVIRONMENT
    OMP_NUM_THREADS=1 # one thread per rank, or ranks fight over the cores
    OPENBLAS_NUM_THREADS=1
    OMPI_ALLOW_RUN_AS_ROOT=1 # containers run as root
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    OMPI_MCA_btl_vader_single_copy_mechanism=none # containers forbid reading another process' memory
    OMPI_MCA_mpi_yield_when_idle=1 # waiting ranks leave the core to others
    OMPI_MCA_hwloc_base_binding_policy=none # tests that run side by side must not be bound to the same core
    "ASAN_OPTIONS=leak_check_at_exit=0" # programs look for leaks while MPI is still there: src/base/leaks.hpp
    "LSAN_OPTIONS=suppressions=${CMAKE_CURRENT_LIST_DIR}/leaks.txt:print_suppressions=0"
    "UBSAN_OPTIONS=print_stacktrace=1")

# Every ctest goes through here, so that all see the same environment.
function(voussoir_register_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PROCESSORS;TIMEOUT" "COMMAND;LABELS")
  if(VOUSSOIR_SANITIZE) # sanitizers slow a test down three to ten times
    math(EXPR arg_TIMEOUT "10 * ${arg_TIMEOUT}")
  endif()
  add_test(NAME ${name} COMMAND ${arg_COMMAND})
  set_tests_properties(
    ${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${arg_TIMEOUT} PROCESSORS ${arg_PROCESSORS}
                       ENVIRONMENT "${VOUSSOIR_TEST_ENVIRONMENT}")
endfunction()

# The folders of the current list below tests/, such as unit;mesh.
function(voussoir_test_folders result)
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/tests OUTPUT_VARIABLE folder)
  string(REPLACE "/" ";" folders "${folder}")
  set(${result} "${folders}" PARENT_SCOPE)
endfunction()

macro(voussoir_test_defaults)
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_NAME)
    message(FATAL_ERROR "A test needs a NAME; not understood: '${arg_UNPARSED_ARGUMENTS}'")
  endif()
  voussoir_test_folders(folders)
  list(GET folders 0 kind)
  if(NOT arg_LABELS)
    set(arg_LABELS ${folders})
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 600)
  endif()
endmacro()

function(voussoir_add_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;TIMEOUT" "SOURCES;RANKS;LABELS;ARGS")
  voussoir_test_defaults()
  if(NOT arg_RANKS)
    set(arg_RANKS 1)
  endif()

  set(target test_${arg_NAME})
  add_executable(${target} ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE voussoir voussoir_test_main voussoir_warnings)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  # What tests do themselves takes no time; the compiler need not try hard.
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  if(VOUSSOIR_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM voussoir_test_headers)
  endif()
  foreach(ranks IN LISTS arg_RANKS)
    voussoir_register_test(
      ${kind}.${arg_NAME}.np${ranks}
      PROCESSORS ${ranks}
      TIMEOUT ${arg_TIMEOUT}
      LABELS ${arg_LABELS}
      COMMAND ${MPIEXEC_EXECUTABLE} --oversubscribe -np ${ranks} $<TARGET_FILE:${target}> ${arg_ARGS})
  endforeach()
endfunction()

function(voussoir_add_script)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;SCRIPT;TIMEOUT;PROCESSORS" "LABELS;ARGS")
  voussoir_test_defaults()
  if(NOT arg_PROCESSORS)
    set(arg_PROCESSORS 1)
  endif()
  voussoir_register_test(
    ${kind}.${arg_NAME}
    PROCESSORS ${arg_PROCESSORS}
    TIMEOUT ${arg_TIMEOUT}
    LABELS ${arg_LABELS}
    COMMAND ${VOUSSOIR_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/${arg_SCRIPT} ${arg_ARGS})
endfunction()
