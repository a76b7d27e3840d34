"""The weighted mean of normalized poses."""
