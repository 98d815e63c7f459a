namespace Nowpose.Cli.Sync;

/// <summary>Prints estimates as CSV or JSON.</summary>
static class SyncOutput
{
    public static void WriteCsv(IEnumerable<SyncEstimate> estimates, bool atInstants, TextWriter output)
    {
        output.WriteLine(atInstants ? "t_ns,offset_ns,error_bound_ns,state" : "t4_ns,offset_ns,skew_ppm,error_bound_ns,state,estimated_error_ns");
        foreach (var estimate in estimates)
        {
            var skew = atInstants ? "" : SyncEstimate.Text(estimate.SkewPpm) + ",";
            var (offset, bound) = (SyncEstimate.Text(estimate.OffsetNanoseconds), SyncEstimate.Text(estimate.ErrorBoundNanoseconds));
            var estimated = atInstants ? "" : "," + SyncEstimate.Text(estimate.EstimatedErrorNanoseconds);
            output.WriteLine($"{estimate.Nanoseconds},{offset},{skew}{bound},{estimate.State}{estimated}");
        }
    }

    public static void WriteJson(IEnumerable<SyncEstimate> estimates, bool atInstants, TextWriter output) =>
        output.WriteLine(JsonText.Of(estimates.Select(estimate => atInstants ? AtInstant(estimate) : AtExchange(estimate))));

    static object AtInstant(SyncEstimate estimate) =>
        new { TNs = estimate.Nanoseconds, OffsetNs = estimate.OffsetNanoseconds, ErrorBoundNs = estimate.ErrorBoundNanoseconds, estimate.State };

    static object AtExchange(SyncEstimate estimate) => new
    {
        t4_ns = estimate.Nanoseconds, OffsetNs = estimate.OffsetNanoseconds, estimate.SkewPpm, ErrorBoundNs = estimate.ErrorBoundNanoseconds, estimate.State,
        EstimatedErrorNs = estimate.EstimatedErrorNanoseconds,
    };
}
