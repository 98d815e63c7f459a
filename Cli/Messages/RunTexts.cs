namespace Nowpose.Cli.Messages;

/// <summary>Texts in the tables of both <c>demo</c> and <c>headset</c>.</summary>
static class RunTexts
{
    public const string ApplicationLatency = "application latency";
    public const string CountsRow = "frames, samples, dropped";

    public static string MedianP95(string median, string p95) => $"{median} median, {p95} P95";
    public static string Counts(int frames, long samples, long dropped) => FormattableString.Invariant($"{frames}, {samples}, {dropped}");
}
