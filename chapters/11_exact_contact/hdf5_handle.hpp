#pragma once

#ifdef ENDURING_HDF5
#include <hdf5.h>

namespace enduring {

/// A handle of libhdf5, closed at the end.
class Hdf5Handle {
public:
    Hdf5Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Hdf5Handle()
    {
        if (id_ >= 0)
            close_(id_);
    }
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;
    bool valid() const { return id_ >= 0; }
    hid_t id() const { return id_; }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

}  // namespace enduring
#endif
