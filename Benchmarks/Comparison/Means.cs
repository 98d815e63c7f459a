namespace Nowpose.Benchmarks.Comparison;

static class Means
{
    public static double Geometric(IEnumerable<double> values) => Math.Exp(values.Average(Math.Log));
}
