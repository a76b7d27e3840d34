"""One pose, this body, this ground."""
