#pragma once

#include "common/experiments/render/picture.hpp"
#include "common/experiments/render/stage.hpp"
#include "common/input/source_directory.hpp"

#include <filesystem>
#include <string>

namespace enduring {

/// Where references lie, and where a picture that differs is left to be looked at.
struct ReferencePlaces {
    std::filesystem::path renders = source_directory() / "renders";
    std::filesystem::path differences = source_directory() / "build/results/differences";
};

struct ReferenceCheck {
    bool passed = false;
    std::string message;
    explicit operator bool() const { return passed; }
};

/// Compares a picture with renders/NAME, as in
///
///     const ReferenceCheck check = check_reference_picture(picture, "01_particle_plane/ground.png");
///     CHECK_MESSAGE(check.passed, check.message);
///
/// On failure the picture and its difference go to build/results/differences. With
/// the environment variable ENDURING_RENEW_RENDERS=1 (`./course renders`) the
/// reference is written instead. Passes where pictures are off.
/// @throws InputError  a file cannot be written
ReferenceCheck check_reference_picture(const Picture& picture, const std::string& name,
                                       const ReferencePlaces& places = {});

/// The same for a stage whose bodies fill the picture, 480 x 320 pixels.
/// @param seen_from  from the bodies to the eye, any length
/// @param margin     free share of the picture on each side, 0 to 0.4
ReferenceCheck check_reference_view(Stage stage, const Vec3& seen_from, const std::string& name,
                                    double margin = 0.08);

}  // namespace enduring
