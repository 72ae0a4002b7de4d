# Song 2018, Figure 2b
name = 'song_fig2b'
keys = 4
load 'reports/figure/style.gp'
load 'reports/figure/convergence.gp'
