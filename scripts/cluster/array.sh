#!/bin/sh
# One task a case: sbatch --array=1-$(wc -l < cases/cases.txt) array.sh
#SBATCH --output=cases/slurm-%A_%a.log
exec heatladder case --run "$(sed -n "${SLURM_ARRAY_TASK_ID}p" cases/cases.txt)" --solver './mycode {case} {out}'
