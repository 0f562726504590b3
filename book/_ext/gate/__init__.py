"""The gate on the built book, one kind of fault a file."""
