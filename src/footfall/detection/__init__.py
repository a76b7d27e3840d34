"""From a clip to its support phases."""
