"""How many elements a second: batch kernels against the limit of the machine, and against what else a user could take.

Every figure is a ratio of times measured side by side in one run, in random order, so that whatever else the machine
does acts on both. The limit is a compiled loop that reads the same arrays and writes as many, without arithmetic.
"""
