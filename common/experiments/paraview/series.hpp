#pragma once

#include "common/experiments/paraview/vtk_text.hpp"
#include "common/experiments/run/probes.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace enduring {

/// Watches a run and leaves it as time series for ParaView: open surfaces.pvd, elements.pvd and pairs.pvd of
/// the folder. What is in them is said at surfaces_vtp(), elements_vtu() and pairs_vtp().
class ParaviewSeries final : public Probe {
public:
    /// @param folder  created if missing
    /// @param every   a moment is saved before the first step and then after every so many
    /// @throws InputError  every is not positive
    explicit ParaviewSeries(std::filesystem::path folder, int every = 1);
    /// @throws InputError  the folder cannot be written
    void observe(const World& world, const Contacts& contacts, double dt) override;
    /// Writes the lists of moments (.pvd); without it ParaView finds single files and no times.
    void finish() const;
    int moments() const { return static_cast<int>(surfaces_.size()); }

private:
    void save(std::vector<VtkMoment>& series, const std::string& file, double time, const std::string& text);

    std::filesystem::path folder_;
    int every_;
    std::vector<VtkMoment> surfaces_, elements_, pairs_;
};

}  // namespace enduring
