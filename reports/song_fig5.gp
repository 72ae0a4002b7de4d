# Song 2018, Figure 5
name = 'song_fig5'
load 'reports/style.gp'
load 'reports/convergence.gp'
