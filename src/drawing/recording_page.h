// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tricover::detail {

// The page's parts, in the order of their script elements.
extern const char* const kPageStyle;     ///< CSS.
extern const char* const kPageBody;      ///< The elements.
extern const char* const kPageData;      ///< Reads the data: bodies, their poses at a time, who meets whom.
extern const char* const kPagePicture;   ///< Draws the bodies at a time, and what is recorded beside them.
extern const char* const kPageControls;  ///< The time line, keys, pointer and buttons.

/// The HTML document around a recording's data, which is safe within a script element.
std::string recordingPage(const std::string& data);

}  // namespace tricover::detail
