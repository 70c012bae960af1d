# What may differ between the version before the types and the stream were made anew (commit 4727bb7) and those after
# it. compare_versions reads the answers of both versions through this script: what is taken out or spelled alike here
# is not a difference. Every rule says why. A record goes from ">>> invocation" to "<<< exit code".
