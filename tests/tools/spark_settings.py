"""How Spark is set in the tests: small and quick to start."""

#: Java that starts quickly, and never gets as fast as it could. What it compiles in all the tests of a
#: process needs more room than it is given by itself; without room nothing is compiled any more.
QUICK_JAVA = "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC -XX:ReservedCodeCacheSize=256m"

#: Spark that makes no program of its own for each query and plans none anew while it runs: a third of
#: the time of small cases. Recordings run with Spark's own settings (test_spark_recordings.py).
QUICK_SPARK = {
    "spark.sql.codegen.wholeStage": "false",
    "spark.sql.codegen.factoryMode": "NO_CODEGEN",
    "spark.sql.adaptive.enabled": "false",
}
