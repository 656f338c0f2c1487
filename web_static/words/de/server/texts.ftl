### How sentences of the server stand one after the other.

# Two or more whole sentences.
text-sequence = { $before } { $after }
