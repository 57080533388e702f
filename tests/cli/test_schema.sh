# test_schema.sh -- the schemas are JSON, and they say what the readers do.
. "$SOURCE/tests/cli/cli.sh"

for name in problem model report; do
    run 0 schema "$name"
    cmp -s out.txt "$SOURCE/docs/schema/$name.json" || complain "schema $name is another than docs/schema/$name.json"
    # taut's own parser gets through it, and stumbles over its first member only
    refused 3 'unknown-member /\$schema' measure "$SOURCE/docs/schema/$name.json"
done

python_with jsonschema || skip python3-jsonschema 'tools/deps.sh test'
"$PYTHON" -W ignore "$SOURCE/tests/cli/schemas.py" || complain "the schemas and the readers differ"
finish
