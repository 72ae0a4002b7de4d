# Error over the number of particles along x: the order of each.
chart = 'convergence'; subject = 'error against particles along x'
X = 1; Y = 3; bars = ''; front = ''
across = 'particles along x  [-]'
along = 'E1  [-]'
load 'reports/bench/bench_style.gp'
