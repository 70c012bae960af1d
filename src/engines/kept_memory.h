#pragma once

namespace rasterwalk {

/// From now on memory that this process frees stays with it, where the library can do that. By
/// default glibc gives large blocks back to the system, and whoever asks for one in each picture,
/// as llvmpipe does for its scene, pays for its pages anew: a dense mesh then takes it four times
/// as long on one thread. To be called by every program that is timed, before it asks for much.
void keep_freed_memory();

} // namespace rasterwalk
