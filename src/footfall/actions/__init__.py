"""What can be started and stopped."""
