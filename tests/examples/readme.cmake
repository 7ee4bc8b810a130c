# SOURCE is a block of C++ in README, to the letter, below the licence's line.
file(READ ${README} text)
file(READ ${SOURCE} source)
string(REPLACE "// SPDX-License-Identifier: BSD-3-Clause\n" "" program "${source}")
string(FIND "${text}" "```cpp\n${program}```" place)
if(program STREQUAL source OR place EQUAL -1)
  message(FATAL_ERROR "${SOURCE} is no example of the README's")
endif()
