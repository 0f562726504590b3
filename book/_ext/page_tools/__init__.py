"""What pages import to show records of the library: boxes, tables, formulas. Presentation only, no physics."""
