# Song 2018, Figure 2b
name = 'song_fig2b'
load 'reports/style.gp'
load 'reports/convergence.gp'
