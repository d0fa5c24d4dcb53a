# Read by ctest: one test for each suite of a test program. Given: program, excluded
# (the end of a filter of GoogleTest: tests that are listed elsewhere), label, folder.
if(NOT EXISTS "${program}")
  get_filename_component(name "${program}" NAME)
  add_test(${name}_NOT_BUILT ${name}_NOT_BUILT)
  return()
endif()
get_filename_component(name "${program}" NAME)

# Asking a program costs a start of it, so its answer is kept while the program is the same.
set(kept "${folder}/${name}_suites.txt")
if(NOT EXISTS "${kept}" OR "${program}" IS_NEWER_THAN "${kept}" OR "${CMAKE_CURRENT_LIST_FILE}" IS_NEWER_THAN "${kept}")
  execute_process(
    COMMAND "${program}" --gtest_list_tests "--gtest_filter=*${excluded}"
    OUTPUT_VARIABLE listed
    ERROR_VARIABLE said
    RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${program} --gtest_list_tests: ${status}\n${listed}${said}")
  endif()
  # A suite stands at the beginning of a line, its tests are indented below it.
  string(REGEX MATCHALL "(^|\n)[A-Za-z_][A-Za-z_0-9/]*\\." suites "${listed}")
  string(REGEX REPLACE "[\n.]" "" suites "${suites}")
  file(WRITE "${kept}" "${suites}")
endif()
file(READ "${kept}" suites)

foreach(suite IN LISTS suites)
  add_test("${name}.${suite}" "${program}" "--gtest_filter=${suite}.*${excluded}")
  set_tests_properties("${name}.${suite}" PROPERTIES LABELS "${label}" TIMEOUT 900)
endforeach()
