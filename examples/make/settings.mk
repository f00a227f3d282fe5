SETTINGS := --error 1e-3 --max-depth 5
