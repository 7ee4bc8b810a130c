# What users build has none of the switches and counters of tests.
execute_process(COMMAND ${NM} -C ${OBJECTS} OUTPUT_VARIABLE symbols RESULT_VARIABLE failed)
if(failed OR NOT symbols MATCHES "tricover::detail::orientExact" OR NOT symbols MATCHES "tricover::detail::Derived::begin")
  message(FATAL_ERROR "cannot read the symbols of ${OBJECTS}")
endif()
if(symbols MATCHES "[^\n]*(useStages|used_stages|usePortableLanes|exactCalls|exact_calls)[^\n]*")
  message(FATAL_ERROR "a library without TRICOVER_TEST_SWITCHES has ${CMAKE_MATCH_0}")
endif()
