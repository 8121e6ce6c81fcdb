#pragma once

#include <map>
#include <optional>
#include <string>

#include "portals/given_graph.h"
#include "preprocess/preprocess.h"
#include "scene/building.h"

namespace enfilade {

/// All that decides the bytes of a house, by name: the model and all that it refers to, the
/// parameters, the program, the formats.  Equal jobs make equal houses.
using PreprocessJob = std::map<std::string, std::string>;

/// The job of preprocessing `model`, which was read from `model_file`.  Throws Error (kMachine)
/// without the OpenGL that is asked for.
PreprocessJob describeJob(const std::string& model_file, const std::string& model_sha256,
                          const Building& model, const PreprocessParameters& parameters,
                          const std::optional<GivenGraph>& given);

/// The parameters as house.json tells them, units in the names.
std::map<std::string, std::string> parameterTexts(const PreprocessParameters& parameters);

/// A job as a file's text, the same for the same job.
std::string jobText(const PreprocessJob& job);

/// What is other in `job` than in the one whose text is `before`, in words: "image_size_px was 256,
/// is 128".
std::string differenceOfJobs(const std::string& before, const PreprocessJob& job);

}  // namespace enfilade
