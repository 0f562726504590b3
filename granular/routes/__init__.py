"""The ways of computing a stiffness, one file a way."""
