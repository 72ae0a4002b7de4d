#!/bin/sh
# One task a case: sbatch --array=1-$(wc -l < cases/cases.txt) array.sh
#SBATCH --output=cases/slurm-%A_%a.log
dir=$(sed -n "${SLURM_ARRAY_TASK_ID}p" cases/cases.txt)
./mycode "$dir/case" "$dir/out.csv"
echo $? >"$dir/status"
