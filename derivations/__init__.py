"""Closed forms of the stiffness of granular assemblies, derived with SymPy and emitted as numeric functions."""
