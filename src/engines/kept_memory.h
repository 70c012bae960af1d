#pragma once

namespace rasterwalk {

/// Makes this process keep the memory that it frees, if the C library can do that. By default glibc
/// returns large blocks to the system, and a program that allocates one for each picture, as
/// llvmpipe does for its scene, pays for the page faults every time: a dense mesh then takes four
/// times as long on one thread. Every timed program calls this before it allocates much.
void keep_freed_memory();

} // namespace rasterwalk
