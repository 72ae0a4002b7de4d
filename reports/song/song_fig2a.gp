# Song 2018, Figure 2a
name = 'song_fig2a'
load 'reports/page/style.gp'
load 'reports/page/convergence.gp'
