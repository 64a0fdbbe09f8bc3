"""Speed against accuracy: the methods measured beside each other, against the truth in rationals."""
