# The job of burst_test.py: how long a report takes to its stroke, and that none is lost.
pump_probe burst "$(cat /burst_seconds)" 1000 >/out/burst.json 2>/out/burst.err
