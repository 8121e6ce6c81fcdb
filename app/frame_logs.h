#pragma once

#include <string>

#include "app/report_reader.h"

namespace enfilade {

/// A method's frames as a log of MangoHud 0.8 (mangoplot, FlightlessMango and FlightlessSomething
/// read it): what nobody measured is 0, as MangoHud writes of a sensor that it lacks.
/// Frame time [ms], time since the start [ns], memory [KiB].
std::string mangoHudLog(const RecordedRun& run, const RecordedMethod& method);

/// The same as a capture of PresentMon 1.7, which CapFrameX reads.
std::string presentMonLog(const RecordedRun& run, const RecordedMethod& method);

}  // namespace enfilade
