"""What every section works with: cells that are kept, honest charts, the machine."""
