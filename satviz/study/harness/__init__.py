"""The tools of every section: cells kept on disk, timings, charts, and facts about the machine."""
