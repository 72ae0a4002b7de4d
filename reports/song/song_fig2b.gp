# Song 2018, Figure 2b
name = 'song_fig2b'
load 'reports/figure/style.gp'
load 'reports/figure/convergence.gp'
