"""What scripts/bench, scripts/compare_records and scripts/scaling share. Python's standard library only."""
