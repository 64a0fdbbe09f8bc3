"""Shapes out of whatever text somebody has: WKT, JSON, or lines of code; what they are told, and how it is sent on."""
