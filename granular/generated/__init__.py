"""Functions emitted by ``derivations write``; do not edit, change the derivation instead."""
