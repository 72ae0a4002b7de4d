# Error against wall time; bars from the fastest to the slowest run.
chart = 'time'; subject = 'error against wall time'
X = 4; Y = 3; bars = 'x'; front = 'time'
across = 'wall time of a run  [s]'
along = 'E1  [-]'
load 'reports/bench/bench_style.gp'
