# Wall time over the number of particles.
chart = 'growth'; subject = 'wall time against particles'
X = 2; Y = 4; bars = 'y'; front = ''
across = 'particles  [-]'
along = 'wall time of a run  [s]'
load 'reports/bench/bench_style.gp'
