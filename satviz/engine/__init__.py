"""The engine: shapes, the one loop over axes, its record and its verdict; standard library only."""
