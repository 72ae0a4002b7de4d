# Song 2018, Figure 5
name = 'song_fig5'
load 'reports/page/style.gp'
load 'reports/page/convergence.gp'
