"""Lists of contacts, measured or simulated: reading, checking, summing, and what the continuum model makes of them."""
