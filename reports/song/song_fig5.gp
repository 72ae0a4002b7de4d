# Song 2018, Figure 5
name = 'song_fig5'
keys = 4
load 'reports/figure/style.gp'
load 'reports/figure/convergence.gp'
