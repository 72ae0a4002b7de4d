# Song 2018, Figure 2a
name = 'song_fig2a'
keys = 4
load 'reports/figure/style.gp'
load 'reports/figure/convergence.gp'
