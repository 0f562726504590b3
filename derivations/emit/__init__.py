"""From records to text: one printer a target; nothing here knows any physics."""
