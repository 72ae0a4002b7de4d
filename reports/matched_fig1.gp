# Error against counted work on square-step: Song's choice, and the matched run.
name = 'matched_fig1'
load 'reports/style.gp'
set logscale xy
set format xy '10^{%T}'
set xlabel 'work of all steps  [pairs of particles]'
set ylabel 'E = Σ|T_e − T_n| / ΣT_e  [-]' offset 0.5
set offsets graph 0.03, graph 0.03, 0, 0
set key bottom left
set label 1 'dx = 0.1 m, 5000 steps' at first 96e6, 0.0102 left offset 1,0.6 font size_of(10)
set label 2 'dx = 0.1 m, 18 steps' at first 576e3, 4e-5 left offset 1,0.6 font size_of(10)
plot data index 'as published' using 1:2 with linespoints lc rgb RED pt 7 lw 1.2 dt 2 title 'SO-SSPH as published', \
     data index 'matched, without the start' using 1:2 with linespoints lc rgb GREY pt 9 lw 1.2 dt 3 title 'matched step, clock started at 0', \
     data index 'matched' using 1:2 with linespoints lc rgb BLUE pt 5 lw 1.2 title 'matched run'
