#include "samples/app/stats.h"

#include <algorithm>

namespace boxcar {

void AddTimes(std::vector<PassTime>& total, const std::vector<PassTime>& times) {
    auto at = total.begin();
    for (const PassTime& time : times) {
        at = std::find_if(at, total.end(), [&](const PassTime& t) { return t.name == time.name; });
        if (at == total.end())
            at = total.insert(at, time);
        else
            at->milliseconds += time.milliseconds;
        ++at;
    }
}

}  // namespace boxcar
