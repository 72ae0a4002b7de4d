# Song 2018, Figure 2a
name = 'song_fig2a'
load 'reports/style.gp'
load 'reports/convergence.gp'
