#pragma once

namespace boxcar {

// "0.1.0", from the project's CMakeLists.txt.
const char* Version();

}  // namespace boxcar
