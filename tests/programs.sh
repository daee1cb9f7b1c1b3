#!/usr/bin/env bash
# Whether files that other programs have written are read as they are: the six sentences go through each program that is
# installed here (pandas, R, LibreOffice, jq), and what is learned from its file must be what is learned from the first,
# byte for byte. Says which programs are missing. Called by `make check-programs`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

groundling=$PWD/target/debug/groundling
python=${PYTHON:-python3}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp assets/corpus/six.csv assets/lexicon/demonstration.txt "$folder"
cd "$folder"
passed=0
failed=0

# learn FILE: the model of a file goes to standard output.
learn() {
    "$groundling" train --lexicon demonstration.txt --epochs 2 --corpus "$1" --out - 2>log
}

# same PROGRAM FILE…: what is learned from each file is what is learned from the six.
same() {
    local program=$1 file
    shift
    echo "$program: $*"
    for file in "$@"; do
        if learn "$file" >found && cmp -s wanted found; then
            passed=$((passed + 1))
        else
            failed=$((failed + 1))
            echo "    $file is read otherwise: $(tail -n 1 log)"
        fi
    done
}

learn six.csv >wanted

if "$python" -c 'import pandas' 2>/dev/null; then
    "$python" - <<'PY'
import pandas
table = pandas.read_csv('six.csv')
table.to_csv('pandas.csv', index=False)
table.to_csv('pandas-index.csv')
table.to_csv('pandas-na.csv', index=False, na_rep='NA')
table.to_csv('pandas.tsv', index=False, sep='\t')
table.to_csv('pandas-utf-16.csv', index=False, encoding='utf-16')
table.to_json('pandas-lines.json', orient='records', lines=True)
table.to_json('pandas-records.json', orient='records')
table.to_json('pandas-indent.json', orient='records', indent=2)
PY
    same "pandas $("$python" -c 'import pandas; print(pandas.__version__)')" pandas.csv pandas-index.csv pandas-na.csv \
        pandas.tsv pandas-utf-16.csv pandas-lines.json pandas-records.json pandas-indent.json
else
    echo "pandas is missing"
fi

if command -v Rscript >/dev/null; then
    Rscript - <<'R'
table <- read.csv("six.csv")
write.csv(table, "r.csv")
write.csv(table, "r-no-names.csv", row.names = FALSE)
write.csv(table, "r-empty.csv", row.names = FALSE, na = "")
write.csv2(table, "r-semicolons.csv", row.names = FALSE)
write.table(table, "r-tabs.txt", sep = "\t", row.names = FALSE, qmethod = "double")
R
    same "$(Rscript --version 2>&1)" r.csv r-no-names.csv r-empty.csv r-semicolons.csv r-tabs.txt
else
    echo "R is missing"
fi

if command -v soffice >/dev/null; then
    office() {
        soffice --headless -env:UserInstallation="file://$folder/office" --convert-to "$1" --outdir "$2" "$3" >office.log 2>&1
    }
    office ods office-1 six.csv
    for kind in 44,34,76 59,34,76 9,34,76; do
        office "csv:Text - txt - csv (StarCalc):$kind,1" "office-$kind" office-1/six.ods
    done
    same "$(soffice --version)" office-44,34,76/six.csv office-59,34,76/six.csv office-9,34,76/six.csv
else
    echo "LibreOffice is missing"
fi

if command -v jq >/dev/null; then
    # Batch results as JSON, then the project's own form.
    if [ -s pandas-lines.json ]; then
        mv pandas-lines.json lines.json
        jq . lines.json >jq.json
        jq -c . lines.json >jq-compact.json
        jq -s . lines.json >jq-list.json
        jq -cs . lines.json >jq-list-compact.json
        jq -c '{id: .AssignmentId, worker: .WorkerId, task: ."Input.task", command: ."Answer.command",
            pairs: [range(1; 4) as $n | {pre: ."Input.pre_\($n)" | fromjson, post: ."Input.post_\($n)" | fromjson}]}' \
            lines.json >jq-pairs.jsonl
        jq . jq-pairs.jsonl >jq-pairs.json
        jq -rs '(.[0] | keys_unsorted | @csv), (.[] | [.[]] | @csv)' lines.json >jq.csv
        same "$(jq --version)" jq.json jq-compact.json jq-list.json jq-list-compact.json jq-pairs.jsonl jq-pairs.json jq.csv
    else
        echo "jq is given what pandas writes, which is missing"
    fi
else
    echo "jq is missing"
fi

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
