"""What a user would take instead: other packages that answer one of the questions this one answers."""
