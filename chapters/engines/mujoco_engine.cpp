#include "chapters/engines/mjcf.hpp"

#ifdef ENDURING_MUJOCO
#include "common/input/input_error.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cstring>
#endif

namespace enduring::engines {

#ifdef ENDURING_MUJOCO
namespace {

mjModel* model_of(const std::string& xml)
{
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(xml.size()));
    std::memcpy(files->filedata[0], xml.data(), xml.size());
    std::array<char, 1000> error{};
    mjModel* const model = mj_loadXML("scene.xml", files.get(), error.data(), static_cast<int>(error.size()));
    mj_deleteVFS(files.get());
    if (!model)
        throw InputError(std::string("MuJoCo: ") + error.data());
    return model;
}

class MujocoWorld final : public EngineWorld {
public:
    MujocoWorld(const EngineScene& scene, const Way& way, double step)
        : model_(model_of(mjcf_of(scene, way, step, true))), data_(mj_makeData(model_.get()))
    {
        const std::vector<double> velocities = mujoco_velocities(scene);
        std::copy(velocities.begin(), velocities.end(), data_->qvel);
        for (const EngineBody& body : scene.bodies)
            number_.push_back(body.moves ? ++moving_ : 0);  // the world itself is 0
    }
    void step(double) override { mj_step(model_.get(), data_.get()); }
    Pose pose(std::size_t body) const override
    {
        const mjtNum* const q = data_->qpos + std::ptrdiff_t{7} * (number_[body] - 1);  // of a free joint
        return {Vec3(q[0], q[1], q[2]), Quaternion(q[3], q[4], q[5], q[6])};
    }

private:
    struct Free {
        void operator()(mjModel* model) const { mj_deleteModel(model); }
        void operator()(mjData* data) const { mj_deleteData(data); }
    };
    std::unique_ptr<mjModel, Free> model_;
    std::unique_ptr<mjData, Free> data_;
    std::vector<std::ptrdiff_t> number_;
    std::ptrdiff_t moving_ = 0;
};

}  // namespace
#endif

Engine mujoco_engine()
{
    Engine engine{"MuJoCo of Debian",
                  "",
                  "",
                  "https://mujoco.readthedocs.io/en/stable/modeling.html#preventing-slip",
                  {"default", 0},
                  {"best", 0, 0, true},
                  {}};
#ifdef ENDURING_MUJOCO
    engine.version = mj_versionString();
    engine.run = [](const Scene& scene, const Way& way, int steps) {
        const EngineScene described = describe(scene);
        const int substeps = substeps_of(way, described, mujoco_default_step);
        MujocoWorld world(described, way, described.dt / substeps);
        return follow(described, world, substeps, steps);
    };
#else
    engine.missing = "libmujoco-dev is not installed";
#endif
    return engine;
}

}  // namespace enduring::engines
