# Error against counted work, which does not depend on the machine.
chart = 'work'; subject = 'error against counted work'
X = 7; Y = 3; bars = ''; front = 'work'
across = 'work  [pairs of particles]'
along = 'E1  [-]'
load 'reports/bench/bench_style.gp'
