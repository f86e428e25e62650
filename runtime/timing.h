// How long passes took on the device.
#pragma once

#include <string>

namespace boxcar {

struct PassTime {
    std::string name;
    double milliseconds = 0;  // on the device, from the first to the last of its work
};

}  // namespace boxcar
